// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace gvd {

/// A priority queue of small items, least first: a heap with four children per node, which has half
/// the levels of a binary heap and keeps siblings in one cache line.
template <class Item>
class QuaternaryHeap {
 public:
  bool empty() const { return items_.empty(); }
  const Item& top() const { return items_.front(); }

  void push(const Item& item) {
    size_t hole = items_.size();
    items_.push_back(item);
    while (hole > 0) {
      const size_t parent = (hole - 1) / 4;
      if (!(item < items_[parent])) break;
      items_[hole] = items_[parent];
      hole = parent;
    }
    items_[hole] = item;
  }

  void pop() {
    const Item last = items_.back();
    items_.pop_back();
    const size_t size = items_.size();
    if (size == 0) return;
    size_t hole = 0;
    for (size_t child = 1; child < size; child = 4 * hole + 1) {
      size_t least = child;
      const size_t end = child + 4 < size ? child + 4 : size;
      for (size_t c = child + 1; c < end; ++c)
        if (items_[c] < items_[least]) least = c;
      if (!(items_[least] < last)) break;
      items_[hole] = items_[least];
      hole = least;
    }
    items_[hole] = last;
  }

 private:
  std::vector<Item> items_;
};

}  // namespace gvd
