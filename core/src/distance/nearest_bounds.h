// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd {

/// At each vertex, the least distance known so far, an upper bound on that of the nearest site, and
/// its label; -1 while the distance is only the length of a path along edges.
using NearestBounds = std::vector<LabelledDistance>;

/// Whether a distance is at most another one, up to rounding.
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
