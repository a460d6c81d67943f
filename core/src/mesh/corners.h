// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The three vertices of a triangle.
using Corners = std::array<int, 3>;

/// The input's triangles, with the representatives of their corners; -1 for a corner that is not
/// finite. Looked up on access, because a list would be as large as the input.
struct WeldedTriangles {
  std::span<const int> triangles;
  std::span<const int> representative;

  int size() const { return static_cast<int>(triangles.size() / 3); }
  Corners operator[](int t) const {
    const int* const v = &triangles[3 * static_cast<std::size_t>(t)];
    return {representative[v[0]], representative[v[1]], representative[v[2]]};
  }
};

/// The faces of a mesh, also while it is built.
using Faces = std::vector<TriangleMesh::Face>;

/// Halfedges of a list of triangles are numbered as in `TriangleMesh`: halfedge h is side
/// h % 3 of triangle h / 3 and runs from corner h % 3 to the next one.
inline int tailOf(const Faces& faces, int h) { return faces[h / 3].vertices[h % 3]; }
inline int tipOf(const Faces& faces, int h) { return faces[h / 3].vertices[cornerAfter(h % 3)]; }
inline int& twinOf(Faces& faces, int h) { return faces[h / 3].twins[h % 3]; }
inline int tailOf(const std::vector<Corners>& triangles, int h) { return triangles[h / 3][h % 3]; }
inline int tipOf(const std::vector<Corners>& triangles, int h) {
  return triangles[h / 3][cornerAfter(h % 3)];
}

}  // namespace gvd
