// SPDX-License-Identifier: MIT
#include "mesh/convex_triangulation.h"

#include <limits>

namespace gvd {

/// Every chord leaves a smaller convex polygon on its right, whose triangle at the chord is the one
/// with no corner inside its circle.
std::span<const std::array<int, 3>> ConvexTriangulation::compute(
    std::span<const Eigen::Vector2d> corners) {
  corners_ = corners;
  triangles_.clear();
  open_.assign(1, {0, static_cast<int>(corners.size()) - 1});
  while (!open_.empty()) {
    const std::array<int, 2> chord = open_.back();
    open_.pop_back();
    if (chord[1] - chord[0] < 2) continue;
    const int k = apex(chord[0], chord[1]);
    triangles_.push_back({chord[0], k, chord[1]});
    open_.push_back({k, chord[1]});
    open_.push_back({chord[0], k});
  }
  return triangles_;
}

/// Of the corners between the ends of a chord, the one that sees it at the largest angle, which is
/// the one of the least cotangent. One on the chord itself is the last choice: a triangle without
/// area.
int ConvexTriangulation::apex(int from, int to) const {
  int best = from + 1;
  double least = std::numeric_limits<double>::infinity();
  for (int k = from + 1; k < to; ++k) {
    const Eigen::Vector2d p = corners_[to] - corners_[k], q = corners_[from] - corners_[k];
    const double area = p[0] * q[1] - p[1] * q[0];
    if (!(area > 0)) continue;
    const double cotangent = p.dot(q) / area;
    if (cotangent < least) {
      least = cotangent;
      best = k;
    }
  }
  return best;
}

}  // namespace gvd
