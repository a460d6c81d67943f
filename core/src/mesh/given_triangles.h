// SPDX-License-Identifier: MIT
//
// Checks of triangles that are given as flat arrays.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace gvd {

/// Throws `Error(kInvalidMesh)` unless both arrays have a multiple of three numbers, as many as an
/// int can count.
void requireTriples(std::size_t coordinates, std::size_t indices);

/// Throws `Error(kInvalidMesh)` if a triangle has a vertex that does not exist.
void requireVertices(std::span<const int> triangles, int triangle, int vertexCount);

}  // namespace gvd
