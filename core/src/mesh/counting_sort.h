// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace gvd {

/// `items` ascending by key(item), which is in [0, keyCount); items with the same key keep their
/// order. O(items + keyCount).
template <class Key>
std::vector<int> countingSort(const std::vector<int>& items, int keyCount, Key key) {
  std::vector<int> position(keyCount + 1, 0);
  for (int item : items) ++position[key(item) + 1];
  std::partial_sum(position.begin(), position.end(), position.begin());
  std::vector<int> sorted(items.size());
  for (int item : items) sorted[position[key(item)]++] = item;
  return sorted;
}

/// Calls visit(run) for every maximal run of items that are the same as the run's first.
template <class Same, class Visit>
void forEachRun(const std::vector<int>& items, Same same, Visit visit) {
  const int* const end = items.data() + items.size();
  for (const int* first = items.data(); first != end;) {
    const int* last = std::find_if(first, end, [&](int item) { return !same(*first, item); });
    visit(std::span(first, last));
    first = last;
  }
}

}  // namespace gvd
