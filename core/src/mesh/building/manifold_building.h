// SPDX-License-Identifier: MIT
//
// Steps 5 to 9 of building a `TriangleMesh`, in slices: from the kept triangles to an oriented
// manifold. O(n), except O(k log k) at a vertex of k triangles.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/triangle_selection.h"
#include "mesh/corners.h"

namespace gvd {

/// Finds the twin of each halfedge on an edge of exactly two triangles, whichever way the twin
/// runs; -1 on all other edges. Counts the edges of three or more triangles.
class HalfedgeMatching {
 public:
  /// Sets the twins of faces that have none; they must outlive this.
  HalfedgeMatching(Faces& faces, int vertexCount, MeshRepairs& repairs)
      : faces_(faces), vertexCount_(vertexCount), repairs_(repairs) {}
  bool step(long& budget);
  /// The edges of three or more triangles, each by the halfedges of its triangles.
  std::vector<std::vector<int>> take() { return std::move(nonManifold_); }

 private:
  void match(std::span<const int> halfedges);

  Faces& faces_;
  const int vertexCount_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  Grouping byLowerEnd_;
  std::vector<KeyedItem> byHigherEnd_;  ///< halfedges of one lower end; no second key
  std::vector<std::vector<int>> nonManifold_;
};

/// The component of each triangle, and which triangles were turned over.
struct OrientedComponents {
  std::vector<int> component;  ///< of each triangle, numbered in order of the first triangle
  std::vector<char> flipped;   ///< of each triangle, whether it was turned over
  std::vector<int> size;       ///< of each component, its number of triangles
};

/// Orients each component like the majority of its triangles (on a draw, like the first), and cuts
/// the edges whose triangles cannot agree. A triangle (a, b, c) that is turned over becomes (a, c,
/// b). Afterwards, twins run in opposite directions. With `Orientation::kKeep`, no triangle is
/// turned over, and all edges whose triangles disagree are cut.
class TriangleOrienting {
 public:
  /// Changes the faces, which must outlive this.
  TriangleOrienting(Faces& faces, Orientation orientation, MeshRepairs& repairs)
      : faces_(faces), orientation_(orientation), repairs_(repairs) {}
  bool step(long& budget);
  OrientedComponents take() { return std::move(out_); }

 private:
  bool disagree(int h) const;
  void cutIfInconsistent(int h);
  void visit(int index);
  void endComponent();
  void turnOver(int t);

  Faces& faces_;
  const Orientation orientation_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  std::vector<int> queue_;  ///< triangles, component by component, each breadth first
  std::size_t firstOfComponent_ = 0;
  int nextRoot_ = 0;
  int flips_ = 0;                        ///< triangles marked in the current component
  std::vector<char> isComponentTurned_;  ///< per component: most triangles were marked
  OrientedComponents out_;
};

/// Joins triangles at an edge of three or more, as step 7 at `TriangleMesh` says. Components may
/// become one. The halfedges of the edge are as they were before triangles were turned over.
void stitch(Faces& faces, const OrientedComponents& oriented, std::span<const double> positions,
            std::span<const int> halfedges);

/// Drops the components of fewer than `least` triangles, and counts them. Throws
/// `Error(kInvalidMesh)` if none is left.
class SmallComponents {
 public:
  /// Changes all lists and counts passed, which must outlive this.
  SmallComponents(int least, Selection& selection, OrientedComponents& oriented,
                  MeshRepairs& repairs);
  bool step(long& budget);

 private:
  void moveUp(int t);
  void shorten();

  const std::size_t count_;  ///< of triangles
  Selection& selection_;
  OrientedComponents& oriented_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  std::vector<int> newComponent_;  ///< of each component, -1 if it is dropped
  std::vector<int> newTriangle_;   ///< of each triangle, -1 if it is dropped
  int kept_ = 0;
};

/// The vertices of an oriented manifold. Vertices keep the order of their representatives; the
/// copies for further fans come last.
struct Fans {
  std::vector<int> representative;  ///< of each vertex
  /// A halfedge that leaves each vertex; at the boundary, the most clockwise one.
  std::vector<int> outgoing;
};

/// Splits every vertex whose triangles form several fans, one vertex per fan. The vertices of faces
/// were representatives, and are those of the manifold then.
class FanSplitting {
 public:
  /// Changes the faces, which must outlive this.
  FanSplitting(Faces& faces, int inputVertexCount, MeshRepairs& repairs)
      : faces_(faces), inputVertexCount_(inputVertexCount), repairs_(repairs) {}
  bool step(long& budget);
  Fans take() { return std::move(out_); }

 private:
  void takeFan(int h);

  Faces& faces_;
  const int inputVertexCount_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  int used_ = 0;                  ///< number of representatives in use
  std::vector<int> firstVertex_;  ///< of each representative, -1 if it is not in use
  std::vector<char> isInFan_;     ///< of each halfedge, whether its fan has a vertex
  Fans out_;
};

}  // namespace gvd
