// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

namespace gvd {

/// A priority queue of small items, least first: a heap of four children a node, which halves the
/// levels of a binary one and keeps siblings in one cache line.
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

/// A priority queue for sweeps, least first, in exactly the order a heap would give: items wait
/// unsorted in buckets of a range of keys, and only the bucket at hand is a heap, small enough to
/// stay in the cache. An item below the bucket at hand joins it.
///
/// `Item` has a member `distance` >= 0, the leading part of its order.
template <class Item>
class SweepQueue {
 public:
  /// `width` of a bucket: about as much as keys differ between neighbours. Keys beyond the last
  /// bucket share it.
  explicit SweepQueue(double width) : inverseWidth_(1 / width) {}

  bool empty() const { return size_ == 0; }

  void push(const Item& item) {
    ++size_;
    const double place = item.distance * inverseWidth_;
    const size_t bucket = place < kMaxBuckets ? static_cast<size_t>(place) : kMaxBuckets;
    if (bucket <= current_) {
      heap_.push(item);
    } else {
      if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
      buckets_[bucket].push_back(item);
    }
  }

  Item pop() {
    while (heap_.empty()) {
      ++current_;
      for (const Item& item : buckets_[current_]) heap_.push(item);
      buckets_[current_] = {};
    }
    --size_;
    const Item item = heap_.top();
    heap_.pop();
    return item;
  }

 private:
  static constexpr size_t kMaxBuckets = 1 << 16;

  double inverseWidth_;
  QuaternaryHeap<Item> heap_;
  std::vector<std::vector<Item>> buckets_;
  size_t current_ = 0;
  size_t size_ = 0;
};

}  // namespace gvd
