// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "base/small_lists.h"

namespace gvd {

/// A short list of items for each of many indices, most of which have none: these take one number
/// each.
template <class Item>
class SparseLists {
 public:
  /// Lengthens this to `count` lists, in slices; true when there are as many.
  bool addLists(std::size_t count, long& budget) {
    return fillInSlices(numbers_, count, kEmpty, budget);
  }

  std::span<const Item> operator[](int i) const { return lists_[numbers_[i]]; }
  void add(int i, Item item) {
    if (numbers_[i] == kEmpty) numbers_[i] = lists_.addList();
    lists_.add(numbers_[i], item);
  }
  void clear(int i) { lists_.clear(numbers_[i]); }
  template <class Predicate>
  void eraseIf(int i, Predicate predicate) {
    lists_.eraseIf(numbers_[i], predicate);
  }

 private:
  static constexpr int kEmpty = 0;  ///< the number of a list that stays empty
  std::vector<int> numbers_;        ///< per index, that of its list in `lists_`
  SmallLists<Item> lists_{1};
};

}  // namespace gvd
