// SPDX-License-Identifier: MIT
#include "distance/ties.h"

#include <algorithm>
#include <utility>

#include "base/sorting.h"

namespace gvd {
namespace {

/// By how much distances may round whose paths cross a hundred faces, as a share of the longest
/// edge: each face rounds by a few 2^-53.
constexpr double kUnfoldingTolerance = 0x1p-46;

/// Whether any two distances are equal up to rounding, but not exactly.
bool haveUnequalTies(std::span<const LabelledDistance> here, const TieTolerance& ties) {
  for (size_t i = 1; i < here.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (ties.tieUnequally(here[i].distance, here[j].distance)) return true;
  return false;
}

}  // namespace

TieTolerance::TieTolerance(const TriangleMesh& mesh)
    : absolute_(kUnfoldingTolerance * mesh.longestEdge()) {}

bool equalizeTies(std::span<LabelledDistance> here, const TieTolerance& ties) {
  constexpr size_t kFew = 32;  // up to here, comparing all pairs is quicker than sorting
  if (here.size() <= kFew && !haveUnequalTies(here, ties)) return false;
  sortStably(here, [](const LabelledDistance& a, const LabelledDistance& b) {
    return a.distance < b.distance;
  });
  bool hasChanged = false;
  double least = here.front().distance;
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
