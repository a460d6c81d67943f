// SPDX-License-Identifier: MIT
#include "base/tolerances.h"

#include <algorithm>

namespace gvd {

void equalizeTies(std::span<LabelledDistance> here) {
  if (here.size() < 2) return;
  std::sort(here.begin(), here.end(), [](const LabelledDistance& a, const LabelledDistance& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.label < b.label);
  });
  double least = here.front().distance;
  for (LabelledDistance& d : here) {
    if (d.distance <= least * (1 + kDistanceTolerance))
      d.distance = least;
    else
      least = d.distance;
  }
  std::sort(here.begin(), here.end(),
            [](const LabelledDistance& a, const LabelledDistance& b) { return a.label < b.label; });
}

}  // namespace gvd
