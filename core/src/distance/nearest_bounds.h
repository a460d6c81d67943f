// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd {

/// At each vertex, the least distance known so far, an upper bound on that of the nearest site, and
/// its label; -1 while the distance is only the length of a path along edges. Once all labels have
/// spread, the label is the lowest of those that tie with the least distance: the owner
/// (`KnownLabels`).
using NearestBounds = std::vector<LabelledDistance>;

/// Whether a distance is at most another one, up to rounding.
inline bool isAtMost(double distance, double other) {
  return distance <= other * (1 + kDistanceTolerance);
}

/// Lowers a bound by the distance of a label. A label takes over the bound by a path along edges
/// even if rounding makes its distance longer than that path.
inline void lower(LabelledDistance& bound, int label, double distance) {
  const bool isFirst = bound.label < 0 && isAtMost(distance, bound.distance);
  if (isFirst || distance < bound.distance) bound = {label, distance};
}

}  // namespace gvd
