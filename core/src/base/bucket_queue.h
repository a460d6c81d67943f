// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace gvd {

/// A queue of items by distance, in buckets of equal width. Items of a bucket come in the order in
/// which they were added, at any time before the bucket is done; an item that belongs to an earlier
/// bucket goes to the current one. Constant time per item, and 1/64 of that per bucket without
/// items: where some edges are a million times as long as others, most buckets have none.
class BucketQueue {
 public:
  explicit BucketQueue(double bucketsPerUnit) : bucketsPerUnit_(bucketsPerUnit) {}

  /// The bucket of a distance.
  std::size_t bucketOf(double distance) const {
    return std::max(front_, static_cast<std::size_t>(distance * bucketsPerUnit_));
  }
  void add(int item, std::size_t bucket) {
    if (bucket >= buckets_.size()) {
      buckets_.resize(bucket + 1);
      occupied_.resize(bucket / kBits + 1, 0);
    }
    buckets_[bucket].push_back(item);
    occupied_[bucket / kBits] |= std::uint64_t{1} << bucket % kBits;
  }

  /// Moves on to the next item; false if there is none, and the queue begins again at distance 0.
  bool advance() {
    while (front_ < buckets_.size()) {
      if (next_ < buckets_[front_].size()) return true;
      buckets_[front_].clear();
      next_ = 0;
      occupied_[front_ / kBits] &= ~(std::uint64_t{1} << front_ % kBits);
      front_ = nextOccupied();
    }
    front_ = 0;
    return false;
  }
  /// Takes the next item, after `advance`.
  int take() { return buckets_[front_][next_++]; }
  /// The item after a few others of the same bucket.
  std::optional<int> ahead(std::size_t others) const {
    const std::vector<int>& bucket = buckets_[front_];
    return next_ + others < bucket.size() ? std::optional(bucket[next_ + others]) : std::nullopt;
  }

  /// The current bucket, and the distance at which it begins.
  std::size_t frontBucket() const { return front_; }
  double front() const { return static_cast<double>(front_) / bucketsPerUnit_; }

 private:
  static constexpr std::size_t kBits = 64;

  std::size_t nextOccupied() const {
    for (std::size_t word = front_ / kBits; word < occupied_.size(); ++word)
      if (occupied_[word]) return word * kBits + std::countr_zero(occupied_[word]);
    return buckets_.size();
  }

  double bucketsPerUnit_;
  std::vector<std::vector<int>> buckets_;
  std::vector<std::uint64_t> occupied_;  ///< one bit per bucket: whether it has items
  std::size_t front_ = 0, next_ = 0;
};

}  // namespace gvd
