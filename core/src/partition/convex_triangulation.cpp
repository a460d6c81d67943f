// SPDX-License-Identifier: MIT
#include "partition/convex_triangulation.h"

#include <algorithm>
#include <limits>

#include "base/plane.h"

namespace gvd {

/// Every chord cuts off a smaller convex polygon, on its right. Of the triangles on the chord, the
/// Delaunay one has no corner inside its circumcircle.
std::span<const std::array<int, 3>> ConvexTriangulation::compute(
    std::span<const Eigen::Vector2d> corners, const IsRuledOut& isRuledOut) {
  corners_ = corners;
  triangles_.clear();
  open_.assign(1, {0, static_cast<int>(corners.size()) - 1});
  while (!open_.empty()) {
    const std::array<int, 2> chord = open_.back();
    open_.pop_back();
    if (chord[1] - chord[0] < 2) continue;
    const int k = apex(chord[0], chord[1], isRuledOut);
    triangles_.push_back({chord[0], k, chord[1]});
    open_.push_back({k, chord[1]});
    open_.push_back({chord[0], k});
  }
  return triangles_;
}

/// The corner between the ends of a chord that sees the chord at the largest angle, that is, with
/// the least cotangent. Corners on the chord, whose triangles have no area, come after all others,
/// and those behind ruled-out chords last.
int ConvexTriangulation::apex(int from, int to, const IsRuledOut& isRuledOut) const {
  int best = from;
  double least = std::numeric_limits<double>::infinity();
  for (int k = from + 1; k < to; ++k) {
    if (isRuledOut && ((k - from > 1 && isRuledOut(from, k)) || (to - k > 1 && isRuledOut(k, to))))
      continue;
    const Eigen::Vector2d p = corners_[to] - corners_[k], q = corners_[from] - corners_[k];
    const double area = cross(p, q);
    const double cotangent = area > 0 ? p.dot(q) / area : least;
    if (best == from || cotangent < least) {
      least = cotangent;
      best = k;
    }
  }
  return std::max(best, from + 1);
}

}  // namespace gvd
