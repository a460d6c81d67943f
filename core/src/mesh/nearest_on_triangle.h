// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

#include "gvd/surface_point.h"

namespace gvd {

/// The point of a triangle that is nearest to p, as barycentric coordinates: the projection if it
/// falls inside, else the nearest of the three sides.
inline Eigen::Vector3d nearestOnTriangle(const Eigen::Vector3d& p,
                                         const std::array<Eigen::Vector3d, 3>& corners) {
  using Eigen::Vector3d;
  const Vector3d u = corners[1] - corners[0], v = corners[2] - corners[0], w = p - corners[0];
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), wu = w.dot(u), wv = w.dot(v);
  const double area = uu * vv - uv * uv, b = vv * wu - uv * wv, c = uu * wv - uv * wu;
  if (area > 0 && b >= 0 && c >= 0 && b + c <= area) {
    const double second = b / area, third = c / area;
    return {std::max(0.0, 1 - second - third), second, third};
  }
  Vector3d best = Vector3d::Unit(0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d &from = corners[i], &to = corners[cornerAfter(i)];
    const double length = (to - from).squaredNorm();
    const double share =
        length > 0 ? std::clamp((p - from).dot(to - from) / length, 0.0, 1.0) : 0.0;
    const double distance = (from + share * (to - from) - p).squaredNorm();
    if (distance < least) {
      least = distance;
      best = (1 - share) * Vector3d::Unit(i) + share * Vector3d::Unit(cornerAfter(i));
    }
  }
  return best;
}

}  // namespace gvd
