// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "gvd/geodesic.h"

namespace gvd {

/// Calls `visit` with every label known at all three corners of a triangle, ascending, and its
/// distances there, given what is known at each.
template <class Visit>
void visitCommonLabels(std::span<const LabelledDistance> a, std::span<const LabelledDistance> b,
                       std::span<const LabelledDistance> c, Visit visit) {
  for (auto i = a.begin(), j = b.begin(), k = c.begin();
       i != a.end() && j != b.end() && k != c.end();) {
    const int label = std::max({i->label, j->label, k->label});
    if (i->label < label) {
      ++i;
    } else if (j->label < label) {
      ++j;
    } else if (k->label < label) {
      ++k;
    } else {
      visit(label, std::array<double, 3>{i->distance, j->distance, k->distance});
      ++i, ++j, ++k;
    }
  }
}

}  // namespace gvd
