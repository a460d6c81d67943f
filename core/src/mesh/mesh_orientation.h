// SPDX-License-Identifier: MIT
//
// Steps 4 to 7 of building a `TriangleMesh`, in slices: from triangles that stay to an oriented
// manifold. All in O(n), but O(k log k) for a vertex of k triangles.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/grouping.h"
#include "mesh/triangle_selection.h"

namespace gvd {

/// The halfedge on the other side of each edge of exactly two triangles, whichever way it runs; -1
/// on all other edges. Counts the edges of three or more.
class HalfedgeMatching {
 public:
  /// The triangles must outlive this.
  HalfedgeMatching(const std::vector<Corners>& triangles, int vertexCount, MeshRepairs& repairs)
      : triangles_(triangles), vertexCount_(vertexCount), repairs_(repairs) {}
  bool step(long& budget);
  std::vector<int> take() { return std::move(twin_); }

 private:
  void match(std::span<int> halfedges);

  const std::vector<Corners>& triangles_;
  const int vertexCount_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  Grouping byLowerEnd_;
  std::vector<int> twin_;
};

/// What each triangle's component is, and which triangles were turned over.
struct OrientedComponents {
  std::vector<int> component;  ///< of each triangle, numbered in order of the first triangle
  std::vector<char> flipped;   ///< of each triangle, whether it was turned over
  int components = 0;
};

/// Orients each component as most of its triangles are (on a draw, as its first one), cuts the
/// edges where that is not possible, and turns triangles over: (a, b, c) becomes (a, c, b). From
/// then on twins run in opposite directions. If orientations are kept, all edges are cut where they
/// do not agree, and that is all.
class TriangleOrienting {
 public:
  /// Both lists, which this changes, must outlive it.
  TriangleOrienting(std::vector<Corners>& triangles, std::vector<int>& twin,
                    Orientation orientation, MeshRepairs& repairs)
      : triangles_(triangles), twin_(twin), orientation_(orientation), repairs_(repairs) {}
  bool step(long& budget);
  OrientedComponents take() { return std::move(out_); }

 private:
  bool disagree(int h) const;
  void cutIfInconsistent(int h);
  void visit(int place);
  void endComponent();
  void turnOver(int t);

  std::vector<Corners>& triangles_;
  std::vector<int>& twin_;
  const Orientation orientation_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::vector<int> queue_;  ///< triangles, component by component, each breadth first
  std::size_t firstOfComponent_ = 0;
  int nextRoot_ = 0;
  int flips_ = 0;                        ///< of the component so far
  std::vector<char> isComponentTurned_;  ///< whether its majority was turned over at first
  OrientedComponents out_;
};

/// Drops the components of fewer than `least` triangles, and counts them. Throws
/// `Error(kInvalidMesh)` if none is left.
class SmallComponents {
 public:
  /// All that this changes must outlive it.
  SmallComponents(int least, Selection& selection, std::vector<int>& twin,
                  OrientedComponents& oriented, MeshRepairs& repairs)
      : least_(least),
        count_(selection.input.size()),
        selection_(selection),
        twin_(twin),
        oriented_(oriented),
        repairs_(repairs) {}
  bool step(long& budget);

 private:
  void numberAnew();
  bool drop(long& budget);
  void moveUp(int t);
  void shorten();

  const int least_;
  const std::size_t count_;  ///< of triangles
  Selection& selection_;
  std::vector<int>& twin_;
  OrientedComponents& oriented_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_, dropping_;
  SlicedLoop loop_;
  std::vector<int> size_;          ///< of each component
  std::vector<int> newComponent_;  ///< of each component, -1 if it is dropped
  std::vector<int> newTriangle_;   ///< of each triangle, likewise
  int kept_ = 0;
};

/// The vertices of an oriented manifold. Vertices keep the order of their representatives; the
/// copies for further fans come last.
struct Fans {
  std::vector<int> tail;            ///< of each halfedge, the vertex that it leaves
  std::vector<int> representative;  ///< of each vertex
  /// Of each vertex, a halfedge that leaves it; at the boundary the first one clockwise.
  std::vector<int> outgoing;
};

/// Splits every vertex whose triangles form several fans, one vertex per fan.
class FanSplitting {
 public:
  /// Both lists must outlive this.
  FanSplitting(const std::vector<Corners>& triangles, const std::vector<int>& twin,
               int inputVertexCount, MeshRepairs& repairs)
      : triangles_(triangles),
        twin_(twin),
        inputVertexCount_(inputVertexCount),
        repairs_(repairs) {}
  bool step(long& budget);
  Fans take() { return std::move(out_); }

 private:
  void takeFan(int h);

  const std::vector<Corners>& triangles_;
  const std::vector<int>& twin_;
  const int inputVertexCount_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  int used_ = 0;                  ///< of the input's vertices
  std::vector<int> firstVertex_;  ///< of each representative, -1 if it is not in use
  Fans out_;
};

}  // namespace gvd
