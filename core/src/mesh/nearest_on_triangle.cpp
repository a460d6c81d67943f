// SPDX-License-Identifier: MIT
#include "mesh/nearest_on_triangle.h"

#include <algorithm>
#include <limits>

#include "gvd/surface_point.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

Vector3d nearestBary(const Vector3d& p, const SpaceTriangle& corners) {
  const int from = longestSide(corners), to = cornerAfter(from), apex = cornerBefore(from);
  const Vector3d u = corners[to] - corners[from], v = corners[apex] - corners[from],
                 w = p - corners[from];
  const double uu = u.squaredNorm();
  const Vector3d height = v - v.dot(u) / uu * u;
  const double share = (w - w.dot(u) / uu * u).dot(height) / height.squaredNorm();
  const double along = (w - share * v).dot(u) / uu;
  if (share >= 0 && along >= 0 && share + along <= 1) {
    Vector3d inside;
    inside[from] = std::max(0.0, 1 - along - share);
    inside[to] = along;
    inside[apex] = share;
    return inside;
  }
  Vector3d best = Vector3d::Unit(0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d &start = corners[i], side = corners[cornerAfter(i)] - start;
    const double length = side.squaredNorm();
    const double part = length > 0 ? std::clamp((p - start).dot(side) / length, 0.0, 1.0) : 0.0;
    const double distance = (start + part * side - p).squaredNorm();
    if (distance < least) {
      least = distance;
      best = (1 - part) * Vector3d::Unit(i) + part * Vector3d::Unit(cornerAfter(i));
    }
  }
  return best;
}

}  // namespace

int longestSide(const SpaceTriangle& corners) {
  const auto squared = [&](int i) { return (corners[cornerAfter(i)] - corners[i]).squaredNorm(); };
  const int longest = squared(1) > squared(0) ? 1 : 0;
  return squared(2) > squared(longest) ? 2 : longest;
}

NearestPoint nearestOnTriangle(const Vector3d& p, const SpaceTriangle& corners) {
  const Vector3d bary = nearestBary(p, corners);
  const Vector3d point = bary[0] * corners[0] + bary[1] * corners[1] + bary[2] * corners[2];
  return {bary, (point - p).squaredNorm()};
}

}  // namespace gvd
