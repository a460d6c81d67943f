// SPDX-License-Identifier: MIT
//
// Lists of labelled distances, ascending by label, and the labels of three of them together.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "gvd/geodesic.h"

namespace gvd {

/// The entry of a label in a list, which is ascending by label; null if there is none. Halves long
/// lists first; most are short.
inline const LabelledDistance* findLabel(std::span<const LabelledDistance> list, int label) {
  constexpr size_t kFew = 8;
  while (list.size() > kFew) {
    const auto upper = list.subspan(list.size() / 2);
    list = upper.front().label <= label ? upper : list.first(list.size() / 2);
  }
  // A branch to leave the loop early would be predicted badly.
  const LabelledDistance* found = nullptr;
  for (const LabelledDistance& d : list) found = d.label == label ? &d : found;
  return found;
}

/// The distance of a label in such a list, infinity if it has none.
inline double distanceIn(std::span<const LabelledDistance> list, int label) {
  const LabelledDistance* const found = findLabel(list, label);
  return found ? found->distance : kInfinity;
}

/// Puts an entry in its place in a list, which is ascending by label.
inline void insertByLabel(std::vector<LabelledDistance>& list, const LabelledDistance& added) {
  const auto isBefore = [](const auto& a, const auto& b) { return a.label < b.label; };
  list.insert(std::upper_bound(list.begin(), list.end(), added, isBefore), added);
}

/// Whether isSought(label, at) is true for any label known at a corner of a triangle. Labels come
/// in ascending order; `at` has the label's distance at each corner, null where it is not known.
template <class IsSought>
bool anyLabel(std::span<const LabelledDistance> a, std::span<const LabelledDistance> b,
              std::span<const LabelledDistance> c, IsSought isSought) {
  constexpr int kNone = std::numeric_limits<int>::max();
  std::array<std::span<const LabelledDistance>, 3> rest = {a, b, c};
  for (;;) {
    int label = kNone;
    for (const auto& list : rest)
      if (!list.empty()) label = std::min(label, list.front().label);
    if (label == kNone) return false;
    std::array<const LabelledDistance*, 3> at{};
    for (int i = 0; i < 3; ++i)
      if (!rest[i].empty() && rest[i].front().label == label) {
        at[i] = rest[i].data();
        rest[i] = rest[i].subspan(1);
      }
    if (isSought(label, at)) return true;
  }
}

/// Calls visit(label, at) for every label known at a corner of a triangle, as `anyLabel` does.
template <class Visit>
void visitLabels(std::span<const LabelledDistance> a, std::span<const LabelledDistance> b,
                 std::span<const LabelledDistance> c, Visit visit) {
  anyLabel(a, b, c, [&](int label, const auto& at) {
    visit(label, at);
    return false;
  });
}

}  // namespace gvd
