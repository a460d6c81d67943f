// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace gvd {

/// The three vertices of a triangle.
using Corners = std::array<int, 3>;

/// Halfedges of a list of triangles are numbered as those of `TriangleMesh`: halfedge h is side
/// h % 3 of triangle h / 3 and runs from corner h % 3 to the next one.
inline int tailOf(const std::vector<Corners>& triangles, int h) { return triangles[h / 3][h % 3]; }
inline int tipOf(const std::vector<Corners>& triangles, int h) {
  return triangles[h / 3][(h + 1) % 3];
}

}  // namespace gvd
