// SPDX-License-Identifier: MIT
//
// Areas and distances in a face, of points in barycentric coordinates.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The squared edge lengths of a face; entry i is of side i (corner i to the next).
inline std::array<double, 3> squaredSides(const TriangleMesh& mesh, int face) {
  std::array<double, 3> squared;
  for (int i = 0; i < 3; ++i) {
    const double length = mesh.length(3 * face + i);
    squared[i] = length * length;
  }
  return squared;
}

/// The area of a triangle in a face as a share of the face's; negative if it is clockwise.
inline double areaShare(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The same of a convex polygon of `count` corners, which `at(i)` gives.
template <class At>
double areaShare(std::size_t count, At at) {
  double sum = 0;
  for (std::size_t i = 2; i < count; ++i) sum += areaShare(at(0), at(i - 1), at(i));
  return sum;
}

/// The squared distance between two points of one face, along the face; clamped because rounding
/// may make it negative. Computed from the two shorter sides, which cancel less in thin faces, and
/// from two coordinates of the difference only, because all three sum to zero only up to rounding.
inline double squaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const std::array<double, 3>& sides) {
  const int longest = sides[0] >= sides[1] && sides[0] >= sides[2] ? 0
                      : sides[1] >= sides[2]                       ? 1
                                                                   : 2;
  const int next = cornerAfter(longest), previous = cornerBefore(longest);
  const double u = a[longest] - b[longest], v = a[next] - b[next];
  const double twiceDot = sides[previous] + sides[next] - sides[longest];
  const double s = u * u * sides[previous] + v * v * sides[next] + u * v * twiceDot;
  return s > 0 ? s : 0;
}

/// Σ bᵢ bⱼ |eᵢⱼ|²: by how much squared distances, interpolated linearly, exceed those in the plane.
inline double interpolationExcess(const Eigen::Vector3d& bary, const std::array<double, 3>& sides) {
  return bary[0] * bary[1] * sides[0] + bary[1] * bary[2] * sides[1] + bary[2] * bary[0] * sides[2];
}

/// Whether a quadrangle is cut along the first of its diagonals, given their squared lengths: the
/// shorter one, or the first if they are equal but for rounding, so that the choice does not depend
/// on where the numbering of a triangle's corners begins.
inline bool isFirstDiagonalTaken(double first, double second) {
  constexpr double kRounding = 1e-12;  // of a difference of coordinates: some thousand 2^-53
  return first <= (1 + kRounding) * second;
}

}  // namespace gvd
