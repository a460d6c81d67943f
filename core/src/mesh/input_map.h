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

/// Maps every corner of every input triangle to a halfedge that leaves it, all three on one face:
/// that of the triangle, or of the triangle it duplicates, or, if it is degenerate, any face with
/// corners at both of its positions; -1 if there is none. Maps every input vertex to a halfedge
/// that leaves it: on the first triangle that names the vertex and has a face, else on any face at
/// its position, else -1. Counts welded and isolated vertices. In slices, O(n log n) in the number
/// of degenerate triangles.
class InputMap {
 public:
  /// `triangles` and `representative` are the input's; `faces` are the mesh's, as representatives;
  /// `kept` is the face of each input triangle, or -1. All must outlive this. The vertices in
  /// `triangles` are replaced by the halfedges.
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
  std::map<std::pair<int, int>, int> faceWith_;  ///< by the positions of a degenerate triangle
  std::vector<int> ofVertex_, ofRepresentative_;
};

}  // namespace gvd
