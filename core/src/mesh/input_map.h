// SPDX-License-Identifier: MIT
//
// Where the input's triangles and vertices are found in a `TriangleMesh`.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"

namespace gvd {

/// For every corner of every input triangle a halfedge that leaves it, all three on one face: the
/// triangle itself, the one it duplicates, or, of a degenerate triangle, any that has its two
/// positions; -1 if there is none. And for every input vertex a halfedge that leaves it: on the
/// first triangle that names the vertex and has a face, else anywhere at its position; -1 if there
/// is none. Counts welded and isolated vertices. In slices, O(n log n) in the number of degenerate
/// triangles.
class InputMap {
 public:
  /// `triangles` and their vertices' representatives are the input's, `faces` the mesh's by
  /// representatives, `kept` is the face of each input triangle or -1. All must outlive this; the
  /// vertices in `triangles` become the halfedges.
  InputMap(std::vector<int>& triangles, const std::vector<int>& representative,
           const std::vector<Corners>& faces, std::vector<int>& kept, MeshRepairs& repairs)
      : triangles_(triangles),
        representative_(representative),
        faces_(faces),
        kept_(kept),
        repairs_(repairs) {}
  bool step(long& budget);
  /// The halfedges of the vertices.
  std::vector<int> take() { return std::move(ofVertex_); }

 private:
  WeldedTriangles welded() const { return {triangles_, representative_}; }
  void offer(int a, int b, int face);
  void mapTriangle(int t);
  void mapVertex(int v);

  std::vector<int>& triangles_;
  const std::vector<int>& representative_;
  const std::vector<Corners>& faces_;
  std::vector<int>& kept_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::map<std::pair<int, int>, int> faceWith_;  ///< the positions of degenerate triangles
  std::vector<int> ofVertex_, ofRepresentative_;
};

}  // namespace gvd
