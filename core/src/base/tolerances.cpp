// SPDX-License-Identifier: MIT
//
// Ties: distances that are equal up to rounding are made equal.
#include "base/tolerances.h"

#include <algorithm>
#include <utility>

#include "base/sorting.h"

namespace gvd {
namespace {

/// Whether any two distances are equal up to rounding, but not exactly.
bool haveUnequalTies(std::span<const LabelledDistance> here, const TieTolerance& ties) {
  for (size_t i = 1; i < here.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const auto [low, high] = std::minmax(here[i].distance, here[j].distance);
      if (low != high && ties.isAtMost(high, low)) return true;
    }
  return false;
}

}  // namespace

TieTolerance::TieTolerance(const TriangleMesh& mesh) {
  for (int v = 0; v < mesh.vertexCount(); ++v)
    absolute_ = std::max(absolute_, 0x1p-46 * mesh.longestEdge(v));
}

bool equalizeTies(std::span<LabelledDistance> here, const TieTolerance& ties) {
  constexpr size_t kFew = 32;  // up to here, comparing all pairs is quicker than sorting
  if (here.size() <= kFew && !haveUnequalTies(here, ties)) return false;
  sortStably(here, [](const LabelledDistance& a, const LabelledDistance& b) {
    return a.distance < b.distance;
  });
  double least = here.front().distance;
  bool hasChanged = false;
  for (LabelledDistance& d : here) {
    if (ties.isAtMost(d.distance, least))
      hasChanged |= std::exchange(d.distance, least) != least;
    else
      least = d.distance;
  }
  sortStably(
      here, [](const LabelledDistance& a, const LabelledDistance& b) { return a.label < b.label; });
  return hasChanged;
}

}  // namespace gvd
