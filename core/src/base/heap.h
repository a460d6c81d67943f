// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
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
  /// The least one and its children in the heap, of which one is the next but one.
  std::span<const Item> topFew() const {
    return {items_.data(), std::min<size_t>(1 + 4, items_.size())};
  }

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
  /// `step` is by about how much keys differ between neighbours. Keys beyond the last bucket share
  /// it.
  explicit SweepQueue(double step) : inverseWidth_(kBucketsPerStep / step) {}

  bool empty() const { return size_ == 0; }

  /// Lets a queue that is empty begin anew: what is pushed need not come late to be in order, but
  /// it costs less if it goes to its own bucket.
  void restart() {
    if (empty()) current_ = 0;
  }

  void push(const Item& item) {
    ++size_;
    const double place = item.distance * inverseWidth_;
    const size_t bucket = place < kMaxBuckets ? static_cast<size_t>(place) : kMaxBuckets;
    if (bucket <= current_) {
      heap_.push(item);
    } else {
      if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
      if (buckets_[bucket].capacity() == 0 && !spare_.empty()) {
        buckets_[bucket] = std::move(spare_.back());
        spare_.pop_back();
      }
      buckets_[bucket].push_back(item);
    }
  }

  /// Of the items that come next, those that are known already without looking for them, the next
  /// one first, unless others are pushed before: a bucket's last ones do not know who follows.
  std::span<const Item> upcoming() const { return heap_.topFew(); }

  Item pop() {
    while (heap_.empty()) {
      ++current_;
      std::vector<Item>& bucket = buckets_[current_];
      if (bucket.empty()) continue;
      for (const Item& item : bucket) heap_.push(item);
      bucket.clear();
      spare_.push_back(std::exchange(bucket, {}));
    }
    --size_;
    const Item item = heap_.top();
    heap_.pop();
    return item;
  }

 private:
  static constexpr size_t kMaxBuckets = 1 << 16;
  static constexpr double kBucketsPerStep = 48;

  double inverseWidth_;
  QuaternaryHeap<Item> heap_;
  std::vector<std::vector<Item>> buckets_;
  std::vector<std::vector<Item>> spare_;  ///< the memory of those that are done
  size_t current_ = 0;
  size_t size_ = 0;
};

}  // namespace gvd
