// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "base/tolerances.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Which distances on a mesh are equal up to rounding: all decisions on ties are made here. The
/// absolute part of the tolerance is for faces much larger than the distances in them: unfolding
/// across these rounds by a share of the longest edge.
class TieTolerance {
 public:
  explicit TieTolerance(const TriangleMesh& mesh);
  /// Whether a distance is at most another one, up to rounding.
  bool isAtMost(double distance, double other) const { return distance <= mostTying(other); }
  /// The largest distance that is at most another one, up to rounding.
  double mostTying(double distance) const {
    return distance * (1 + kDistanceTolerance) + absolute_;
  }
  /// The least distance that `equalizeTies` may set one to.
  double leastTying(double distance) const {
    return std::max(0.0, (distance - absolute_) / (1 + kDistanceTolerance));
  }
  /// Whether two distances are equal up to rounding, but not exactly.
  bool tieUnequally(double a, double b) const { return a != b && isAtMost(a, b) && isAtMost(b, a); }

 private:
  double absolute_;
};

/// Sets distances at one place that are equal up to rounding to the least of them. All distances
/// that a diagram is traced from pass through here, so that later comparisons can be exact.
/// Returns whether there were any that were not equal exactly.
bool equalizeTies(std::span<LabelledDistance> here, const TieTolerance& ties);

}  // namespace gvd
