// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

namespace gvd {

/// The point of a triangle that is nearest to p, as barycentric coordinates: the projection if it
/// falls inside, else the nearest of the three sides. Also on needles, rounding moves the point by
/// no more than it would move the corners: p is split into a part along the longest side, which has
/// no errors from the height, and the rest, which the height is compared with.
Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p,
                                  const std::array<Eigen::Vector3d, 3>& corners);

}  // namespace gvd
