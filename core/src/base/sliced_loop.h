// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
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
    const std::size_t begin = next_, end = advance(count, budget, perUnit);
    for (std::size_t i = begin; i < end; ++i) body(static_cast<int>(i));
    return end == count;
  }

 private:
  std::size_t advance(std::size_t count, long& budget, long perUnit);

  std::size_t next_ = 0;
};

/// Rounds per unit of loops that read or write a few numbers in each.
inline constexpr long kQuickRounds = 32;

/// Things to do one after the other, each of which may stop where a budget is used up: it is called
/// again until it returns true. What returns nothing is done at one go.
class SlicedSequence {
 public:
  /// Goes on with the first of `parts` that is not done; true when all are.
  template <class... Parts>
  bool run(Parts... parts) {
    count_ = sizeof...(parts);
    int i = 0;
    return ((i++ < done_ || (isDone(parts) && ++done_ > 0)) && ...);
  }
  /// The share of the parts that is done; 0 before the first call.
  double progress() const { return count_ > 0 ? static_cast<double>(done_) / count_ : 0; }

 private:
  template <class Part>
  static bool isDone(Part& part) {
    if constexpr (std::is_void_v<decltype(part())>) {
      part();
      return true;
    } else {
      return part();
    }
  }

  int done_ = 0, count_ = 0;
};

/// Works on a part of a whole, which is made of `arguments` when it is first come to; true when it
/// is done.
template <class Part, class... Arguments>
bool runPart(std::optional<Part>& part, long& budget, Arguments&&... arguments) {
  if (!part) part.emplace(std::forward<Arguments>(arguments)...);
  return part->step(budget);
}

/// What a part has made; the part goes, and all its memory with it.
template <class Part>
auto taken(std::optional<Part>& part) {
  auto result = part->take();
  part.reset();
  return result;
}

/// How far a budget leads from a place in a list of `count` items; what that takes is taken off it.
/// A budget below zero, since something that cannot be divided took more than there was, leads
/// nowhere.
std::size_t endOfSlice(std::size_t begin, std::size_t count, long& budget, long perUnit);

/// Lengthens a list to `count` items; true when it is that long.
template <class Item>
bool fillInSlices(std::vector<Item>& list, std::size_t count, const Item& value, long& budget) {
  constexpr long kItemsPerUnit = 256;
  if (list.size() >= count) return true;
  list.reserve(count);
  list.resize(endOfSlice(list.size(), count, budget, kItemsPerUnit), value);
  return list.size() == count;
}

/// Gives up the memory of a list that is not needed any more.
template <class Item>
void release(std::vector<Item>& list) {
  std::vector<Item>().swap(list);
}

}  // namespace gvd
