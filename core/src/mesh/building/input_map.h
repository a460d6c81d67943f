// SPDX-License-Identifier: MIT
//
// Where the input's triangles and vertices are found in a `TriangleMesh`.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/triangle_selection.h"
#include "mesh/corners.h"

namespace gvd {

/// Maps every corner of a dropped triangle to a halfedge that leaves it, all three on one face:
/// that of the triangle it duplicates or, if it is degenerate, any face with corners at both of its
/// positions. Maps every input vertex to a halfedge that leaves it: on the first triangle that
/// names the vertex and has a face, else on any face at its position, else -1. Counts welded and
/// isolated vertices. In slices, O(n log n) in the number of degenerate triangles.
class InputMap {
 public:
  /// `selection` has the faces that the mesh will have, their vertices still representatives; the
  /// mesh takes its list `kept`. All must outlive this.
  InputMap(const WeldedTriangles& welded, Selection& selection, TriangleMesh& mesh)
      : welded_(welded), selection_(selection), mesh_(mesh) {}
  bool step(long& budget);

 private:
  void offer(int a, int b, int face);
  void mapTriangle(int t);
  void mapVertex(int v);

  const WeldedTriangles welded_;
  Selection& selection_;
  TriangleMesh& mesh_;

  SlicedSequence sequence_;
  std::map<std::pair<int, int>, int> faceWith_;  ///< by the positions of a degenerate triangle
  std::vector<int> ofRepresentative_;
};

}  // namespace gvd
