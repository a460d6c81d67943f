// SPDX-License-Identifier: MIT
#include "diagram/complex/near_labels.h"

#include <algorithm>

#include "distance/labelled_distances.h"
#include "gvd/surface_point.h"

namespace gvd {
namespace {

/// The relative error of the lengths of sides: in thin faces it is the root of the rounding of
/// their squares.
constexpr double kLengthError = 0x1p-23;

/// The longest way between two corners of a triangle, the same or others, by way of a third point
/// in it: the sum of two distances is largest at a corner.
double longestWay(int from, int to, const std::array<double, 3>& lengths) {
  const auto distance = [&](int i, int j) {
    return i == j ? 0 : lengths[cornerAfter(i) == j ? i : j];
  };
  double longest = 0;
  for (int by = 0; by < 3; ++by) longest = std::max(longest, distance(from, by) + distance(by, to));
  return (1 + kLengthError) * longest;
}

}  // namespace

void findNearLabels(const std::array<std::span<const LabelledDistance>, 3>& known,
                    const std::array<double, 3>& lengths, const TieTolerance& ties,
                    std::vector<NearLabel>& near) {
  std::array<double, 3> nearest;  // of the labels known at all corners
  nearest.fill(kInfinity);
  visitLabels(known[0], known[1], known[2], [&](int /*label*/, const auto& at) {
    for (int i = 0; i < 3 && at[0] && at[1] && at[2]; ++i)
      nearest[i] = std::min(nearest[i], at[i]->distance);
  });
  // A label farther from corner i than most[i] is farther everywhere than one known at all corners.
  std::array<double, 3> most;
  for (int i = 0; i < 3; ++i) {
    most[i] = kInfinity;
    for (int j = 0; j < 3; ++j) most[i] = std::min(most[i], nearest[j] + longestWay(i, j, lengths));
    most[i] = ties.mostTying(most[i]);
  }
  near.clear();
  visitLabels(known[0], known[1], known[2], [&](int label, const auto& at) {
    NearLabel found{label, {}};
    bool isFar = false, isNearest = false;
    for (int i = 0; i < 3; ++i) {
      found.isKnown[i] = at[i];
      isFar |= at[i] && at[i]->distance > most[i];
      isNearest |= at[i] && at[i]->distance <= nearest[i];
    }
    if (!isFar || isNearest) near.push_back(found);
  });
}

}  // namespace gvd
