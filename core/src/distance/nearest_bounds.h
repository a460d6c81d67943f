// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd {

/// The least distance known at each vertex, an upper bound on that of the nearest site, and the
/// label that it belongs to; -1 while it is but a bound (the length of a path along edges).
using NearestBounds = std::vector<LabelledDistance>;

/// Whether a distance is not larger than another one by more than rounding.
inline bool isAtMost(double distance, double other) {
  return distance <= other * (1 + kDistanceTolerance);
}

/// Lowers a bound by the distance of a label; of labels that tie, the lowest owns the vertex.
inline void lower(LabelledDistance& bound, int label, double distance) {
  if (!isAtMost(distance, bound.distance)) return;
  const bool isTie = isAtMost(bound.distance, distance);
  if (!isTie || bound.label < 0 || label < bound.label) bound.label = label;
  bound.distance = std::min(bound.distance, distance);
}

}  // namespace gvd
