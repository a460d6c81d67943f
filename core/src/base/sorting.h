// SPDX-License-Identifier: MIT
//
// A stable sort that keeps programs small. The standard library's is compiled for each kind of item
// and each order, which was a twentieth of the library; here it is compiled for indices only.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace gvd {

/// The indices below `count`, sorted stably by `isBefore(context, a, b)`.
std::vector<int> sortedIndices(int count, bool (*isBefore)(const void* context, int a, int b),
                               const void* context);

/// Sorts items by `isBefore(a, b)`; equal items keep their order.
template <class Item, class Before>
void sortStably(std::span<Item> items, const Before& isBefore) {
  if (std::is_sorted(items.begin(), items.end(), isBefore)) return;
  const auto isBeforeByIndex = [&](int a, int b) { return isBefore(items[a], items[b]); };
  const std::vector<int> order = sortedIndices(
      static_cast<int>(items.size()),
      [](const void* context, int a, int b) {
        return (*static_cast<const decltype(isBeforeByIndex)*>(context))(a, b);
      },
      &isBeforeByIndex);
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const int i : order) sorted.push_back(std::move(items[i]));
  std::move(sorted.begin(), sorted.end(), items.begin());
}

}  // namespace gvd
