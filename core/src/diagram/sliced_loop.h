// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {

/// A loop over the indices from 0 to below a count that stops where a budget is used up, and goes
/// on from there when it is called again.
///
/// A budget is what a caller lets one step do. Its unit is a microsecond or less: dividing one
/// mixed face, or `perUnit` rounds of a loop that does little in each.
class SlicedLoop {
 public:
  /// Calls `body` with the indices. Returns true when it has been called with all of them; the next
  /// loop then starts from 0.
  template <class Body>
  bool run(std::size_t count, long& budget, long perUnit, Body body) {
    const auto left = static_cast<long>(count - next_);
    const long units = std::min(budget, (left + perUnit - 1) / perUnit);
    const std::size_t end = units > left / perUnit ? count : next_ + units * perUnit;
    for (std::size_t i = next_; i < end; ++i) body(static_cast<int>(i));
    budget -= units;
    next_ = end < count ? end : 0;
    return end == count;
  }

 private:
  std::size_t next_ = 0;
};

/// Rounds per unit of loops that read or write a few numbers in each.
inline constexpr long kQuickRounds = 32;

/// Lengthens a list to `count` items; true when it is that long.
template <class Item>
bool fillInSlices(std::vector<Item>& list, std::size_t count, const Item& value, long& budget) {
  constexpr long kItemsPerUnit = 256;
  if (list.size() >= count) return true;
  list.reserve(count);
  const auto left = static_cast<long>(count - list.size());
  const long units = std::min(budget, (left + kItemsPerUnit - 1) / kItemsPerUnit);
  list.resize(list.size() + std::min(left, units * kItemsPerUnit), value);
  budget -= units;
  return list.size() == count;
}

}  // namespace gvd
