// SPDX-License-Identifier: MIT
//
// Positions and triangles that are given as flat arrays.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace gvd {

/// The position of a vertex: its three numbers in the array.
inline Eigen::Vector3d positionOf(std::span<const double> positions, int vertex) {
  return Eigen::Vector3d::Map(&positions[3 * static_cast<std::size_t>(vertex)]);
}

/// Throws `Error(kInvalidMesh)` unless both arrays have a multiple of three numbers, as many as an
/// int can count.
void requireTriples(std::size_t coordinates, std::size_t indices);

/// Throws `Error(kInvalidMesh)` if a triangle has a vertex that does not exist.
void requireVertices(std::span<const int> triangles, int triangle, int vertexCount);

}  // namespace gvd
