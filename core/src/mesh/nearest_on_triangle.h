// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace gvd {

/// A triangle in space, by its corners.
using SpaceTriangle = std::array<Eigen::Vector3d, 3>;

/// The longest side of a triangle, the first one of equals; from corner i to the next.
int longestSide(const SpaceTriangle& corners);

/// A point of a triangle, and its squared distance from a given point.
struct NearestPoint {
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();
  double squaredDistance = std::numeric_limits<double>::infinity();
};

/// The nearest point of several triangles, and its triangle, -1 if there is none.
struct NearestOfTriangles : NearestPoint {
  int triangle = -1;
};

/// The point of a triangle that is nearest to p: the projection if it falls inside, else the
/// nearest of the three sides. Also on needles, rounding moves the point by no more than it would
/// move the corners: p is split into a part along the longest side, which has no errors from the
/// height, and the rest, which the height is compared with.
NearestPoint nearestOnTriangle(const Eigen::Vector3d& p, const SpaceTriangle& corners);

}  // namespace gvd
