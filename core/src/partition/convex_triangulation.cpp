// SPDX-License-Identifier: MIT
#include "partition/convex_triangulation.h"

#include <limits>

namespace gvd {

/// Every chord cuts off a smaller convex polygon, on its right. Of the triangles on the chord, the
/// Delaunay one has no corner inside its circumcircle.
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

/// The corner between the ends of a chord that sees the chord at the largest angle, that is, with
/// the least cotangent. A corner on the chord itself is the last choice, because its triangle has
/// no area.
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
