// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/sliced_loop.h"

namespace gvd {

/// A counting sort: puts the items 0 … count - 1 into groups, in slices. O(items + groups).
class Grouping {
 public:
  /// `groupOf(item)` is below `groupCount`, or negative for an item in no group. Call `run` with
  /// the same arguments until it returns true.
  template <class GroupOf>
  bool run(int itemCount, int groupCount, GroupOf groupOf, long& budget) {
    constexpr long kItemsPerUnit = 16;  // memory is accessed in random order
    return sequence_.run([&] { return fillInSlices(end_, groupCount + 1, 0, budget); },
                         forEach(itemCount, budget, kItemsPerUnit,
                                 [&](int item) {
                                   if (const int group = groupOf(item); group >= 0)
                                     ++end_[group + 1];
                                 }),
                         forEach(groupCount, budget, kQuickRounds,
                                 [&](int group) { end_[group + 1] += end_[group]; }),
                         [&] { return fillInSlices(items_, end_[groupCount], 0, budget); },
                         // `end_` holds the start of each group, and advances to its end.
                         forEach(itemCount, budget, kItemsPerUnit, [&](int item) {
                           if (const int group = groupOf(item); group >= 0)
                             items_[end_[group]++] = item;
                         }));
  }

  /// Calls visit(items) for every group, in slices; `visit` may sort the items. Call it with the
  /// same arguments until it returns true.
  template <class Visit>
  bool visitGroups(Visit visit, long& budget) {
    constexpr long kItemsPerUnit = 8;
    return loop_.run(end_.size() - 1, budget, kItemsPerUnit, [&](int group) {
      const std::span<int> all = items(group);
      visit(all);
      return static_cast<long>(all.size()) + 1;
    });
  }

  /// Group after group.
  std::span<const int> items() const { return items_; }
  /// Ascending, unless the caller has reordered them.
  std::span<int> items(int group) {
    const int begin = group > 0 ? end_[group - 1] : 0;
    return std::span(items_).subspan(begin, end_[group] - begin);
  }

 private:
  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::vector<int> end_;  ///< of each group in `items_`
  std::vector<int> items_;
};

/// Calls visit(run) for every maximal run of items that are the same as the first of the run.
template <class Item, class Same, class Visit>
void forEachRun(std::span<Item> items, Same same, Visit visit) {
  for (auto first = items.begin(); first != items.end();) {
    const auto last =
        std::find_if(first, items.end(), [&](const Item& item) { return !same(*first, item); });
    visit(std::span(first, last));
    first = last;
  }
}

/// An item after two keys. Whatever is sorted by one key or two is sorted as this, because the
/// standard library's sort is compiled anew for every other kind of item and order.
using KeyedItem = std::array<int, 3>;

/// Sorts items by their keys, and calls visit(run) for every run of items with the same keys,
/// ascending.
template <class Visit>
void visitSame(std::vector<KeyedItem>& items, Visit visit) {
  std::sort(items.begin(), items.end());
  forEachRun(
      std::span<const KeyedItem>(items),
      [](const KeyedItem& a, const KeyedItem& b) { return a[0] == b[0] && a[1] == b[1]; }, visit);
}

}  // namespace gvd
