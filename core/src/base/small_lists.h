// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/sliced_loop.h"

namespace gvd {

/// A short list of items for each of many indices, all in one array. A list that grows beyond its
/// room moves to a larger one (a power of two) and leaves its own to another list.
template <class Item>
class SmallLists {
 public:
  explicit SmallLists(int count = 0) : lists_(count) {}
  /// Lengthens this to `count` lists, in slices; true when there are as many.
  bool addLists(size_t count, long& budget) { return fillInSlices(lists_, count, List(), budget); }

  /// Appends an empty list and returns its index.
  int addList() {
    lists_.emplace_back();
    return static_cast<int>(lists_.size()) - 1;
  }

  std::span<const Item> operator[](int i) const {
    return {items_.data() + lists_[i].first, lists_[i].size};
  }
  std::span<Item> operator[](int i) { return {items_.data() + lists_[i].first, lists_[i].size}; }

  void clear(int i) { lists_[i].size = 0; }
  /// Inserts before the item at `position`.
  void insert(int i, size_t position, Item item) {
    List& list = lists_[i];
    if (list.size == list.capacity) grow(list);
    const auto first = items_.begin() + list.first;
    std::copy_backward(first + position, first + list.size, first + list.size + 1);
    first[position] = item;
    ++list.size;
  }
  template <class Predicate>
  void eraseIf(int i, Predicate predicate) {
    const std::span<Item> list = (*this)[i];
    const auto end = std::remove_if(list.begin(), list.end(), predicate);
    lists_[i].size = static_cast<std::uint32_t>(end - list.begin());
  }
  void add(int i, Item item) { insert(i, lists_[i].size, item); }

  /// Gives up all lists, each of which is then to be allotted; `total` is the room for all items.
  void beginAllotting(size_t total) {
    items_.clear();
    items_.reserve(total);
    for (auto& free : free_) free.clear();
  }
  /// Makes a list empty, with room for `count` items.
  void allot(int i, int count) {
    lists_[i] = {static_cast<std::uint32_t>(items_.size()), 0, static_cast<std::uint32_t>(count)};
    items_.resize(items_.size() + count);
  }

 private:
  struct List {
    std::uint32_t first = 0;
    std::uint32_t size = 0, capacity = 0;
  };

  void grow(List& list) {
    const std::uint32_t capacity = std::bit_ceil(list.capacity + 1);
    std::vector<std::uint32_t>& free = free_[std::bit_width(capacity)];
    std::uint32_t first;
    if (free.empty()) {
      first = static_cast<std::uint32_t>(items_.size());
      items_.resize(items_.size() + capacity);
    } else {
      first = free.back();
      free.pop_back();
    }
    std::copy_n(items_.begin() + list.first, list.size, items_.begin() + first);
    // Room that is no power of two comes from `allot` and is not reused.
    if (std::has_single_bit(list.capacity))
      free_[std::bit_width(list.capacity)].push_back(list.first);
    list.first = first;
    list.capacity = capacity;
  }

  std::vector<List> lists_;
  std::vector<Item> items_;
  std::array<std::vector<std::uint32_t>, 33> free_;  ///< by the bits of their capacity
};

}  // namespace gvd
