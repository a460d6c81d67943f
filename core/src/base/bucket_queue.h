// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gvd {

/// The most buckets that a queue may have per short edge (`TriangleMesh::shortEdgeLength`). No
/// distance is longer than all sides of faces together, and a short edge is at least 6 / 2^30 of
/// that: so distances have no more than 2^30 buckets, which an int can number.
inline constexpr double kMostBucketsPerEdge = 6;

/// A queue of items by distance, in buckets of equal width. Items of a bucket come in the order in
/// which they were added, at any time before the bucket is done; an item that belongs to an earlier
/// bucket goes to the current one. Constant time per item, and 1/64 of that per bucket without
/// items: where some edges are a million times as long as others, most buckets have none. Memory is
/// held for the buckets with items, in pages of 64, and 1/8 of a byte for every other one.
class BucketQueue {
 public:
  explicit BucketQueue(double bucketsPerUnit) : bucketsPerUnit_(bucketsPerUnit) {}

  /// The bucket of a distance.
  std::size_t bucketOf(double distance) const {
    return std::max(front_, static_cast<std::size_t>(distance * bucketsPerUnit_));
  }
  void add(int item, std::size_t bucket) {
    Page& page = pageOf(bucket);
    page.buckets[bucket % kPerPage].push_back(item);
    page.occupied |= std::uint64_t{1} << bucket % kPerPage;
    ++count_;
  }

  /// Moves on to the next item; false if there is none, and the queue begins again at distance 0.
  bool advance() {
    while (!current_ || next_ == current_->size()) {
      if (current_) leaveCurrent();
      if (count_ == 0) {
        front_ = 0;
        return false;
      }
      front_ = nextOccupied();
      current_ = &pages_[front_ / kPerPage]->buckets[front_ % kPerPage];
    }
    return true;
  }
  /// Takes the next item, after `advance`.
  int take() {
    --count_;
    return (*current_)[next_++];
  }
  /// The item after a few others of the same bucket, after `advance`.
  std::optional<int> ahead(std::size_t others) const {
    return next_ + others < current_->size() ? std::optional((*current_)[next_ + others])
                                             : std::nullopt;
  }

  /// The current bucket, and the distance at which it begins.
  std::size_t frontBucket() const { return front_; }
  double front() const { return static_cast<double>(front_) / bucketsPerUnit_; }

 private:
  static constexpr std::size_t kPerPage = 64;
  struct Page {
    std::array<std::vector<int>, kPerPage> buckets;
    std::uint64_t occupied = 0;  ///< one bit per bucket: whether it has items
  };

  Page& pageOf(std::size_t bucket) {
    const std::size_t number = bucket / kPerPage;
    if (number >= pages_.size()) pages_.resize(number + 1);
    std::unique_ptr<Page>& page = pages_[number];
    if (!page && free_.empty()) page = std::make_unique<Page>();
    if (!page) {
      page = std::move(free_.back());
      free_.pop_back();
    }
    return *page;
  }

  void leaveCurrent() {
    std::unique_ptr<Page>& page = pages_[front_ / kPerPage];
    page->occupied &= ~(std::uint64_t{1} << front_ % kPerPage);
    current_->clear();
    current_ = nullptr;
    next_ = 0;
    if (page->occupied == 0) free_.push_back(std::move(page));
  }

  std::size_t nextOccupied() const {
    std::size_t number = front_ / kPerPage;
    while (!pages_[number]) ++number;
    return number * kPerPage + std::countr_zero(pages_[number]->occupied);
  }

  double bucketsPerUnit_;
  std::vector<std::unique_ptr<Page>> pages_;  ///< null where no bucket has items
  std::vector<std::unique_ptr<Page>> free_;   ///< without items, to be used again
  std::vector<int>* current_ = nullptr;       ///< the bucket `front_`, once it has begun
  std::size_t front_ = 0, next_ = 0;          ///< `next_`: in the current bucket
  std::size_t count_ = 0;                     ///< of items that have not been taken
};

}  // namespace gvd
