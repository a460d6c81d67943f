// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/prefetch.h"

namespace gvd {

/// The most buckets that a queue may have per short edge (`TriangleMesh::shortEdgeLength`). No
/// distance is longer than all sides of faces together, and a short edge is at least 6 / 2^30 of
/// that: so distances have no more than 2^30 buckets, which an int can number.
inline constexpr double kMostBucketsPerEdge = 6;

/// A queue of items by distance, in buckets of equal width. Items of a bucket come in the order in
/// which they were added. An item of an earlier bucket than the current one may still be added; it
/// comes next, since what follows from it would have to be done twice otherwise. Constant time per
/// item, and 1/64 of that each time that a bucket without items is passed over: where some edges
/// are a million times as long as others, most buckets have none. Memory is held for the buckets
/// with items, in pages of 64, and 1/8 of a byte for every other one.
class BucketQueue {
 public:
  explicit BucketQueue(double bucketsPerUnit) : bucketsPerUnit_(bucketsPerUnit) {}

  /// The bucket of a distance.
  std::size_t bucketOf(double distance) const {
    return static_cast<std::size_t>(distance * bucketsPerUnit_);
  }
  void add(int item, std::size_t bucket) {
    if (bucket < front_) goBackTo(bucket);
    Page& page = pageOf(bucket);
    page.buckets[bucket % kPerPage].items.push_back(item);
    page.occupied |= std::uint64_t{1} << bucket % kPerPage;
    ++count_;
  }

  /// Moves on to the next item; false if there is none, and the queue begins again at distance 0.
  bool advance() {
    while (!current_ || current_->isDone()) {
      leaveCurrent();
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
    return current_->items[current_->next++];
  }
  /// The item `others` places on in the bucket; after `advance`.
  std::optional<int> ahead(std::size_t others) const {
    const std::size_t i = current_->next + others;
    return i < current_->items.size() ? std::optional(current_->items[i]) : std::nullopt;
  }

  /// The items of the bucket to be prefetched before the next one is taken; after `advance`.
  std::span<const int> toPrefetch() const {
    return itemsToPrefetch<int>(current_->items, current_->next);
  }

  /// The current bucket, and the distance at which it begins.
  std::size_t frontBucket() const { return front_; }
  double front() const { return static_cast<double>(front_) / bucketsPerUnit_; }

 private:
  static constexpr std::size_t kPerPage = 64;
  struct Bucket {
    std::vector<int> items;
    std::size_t next = 0;  ///< of the items, the next one to be taken

    bool isDone() const { return next == items.size(); }
  };
  struct Page {
    std::array<Bucket, kPerPage> buckets;
    std::uint64_t occupied = 0;  ///< one bit per bucket: whether it has items
  };

  Page& pageOf(std::size_t bucket) {
    const std::size_t number = bucket / kPerPage;
    if (number >= pages_.size()) pages_.resize(number + 1);
    std::unique_ptr<Page>& page = pages_[number];
    if (!page) page = newPage();
    return *page;
  }
  /// Not inlined, because most items go into a page that is there.
  [[gnu::noinline]] std::unique_ptr<Page> newPage() {
    if (free_.empty()) return std::make_unique<Page>();
    std::unique_ptr<Page> page = std::move(free_.back());
    free_.pop_back();
    return page;
  }

  /// Makes a bucket before the current one the first to be looked at. Not inlined, because that is
  /// rare on most meshes.
  [[gnu::noinline]] void goBackTo(std::size_t bucket) {
    leaveCurrent();
    front_ = bucket;
  }

  /// Leaves the current bucket, if it has begun, with the items that have not been taken.
  void leaveCurrent() {
    Bucket* const left = std::exchange(current_, nullptr);
    if (!left || !left->isDone()) return;
    std::unique_ptr<Page>& page = pages_[front_ / kPerPage];
    page->occupied &= ~(std::uint64_t{1} << front_ % kPerPage);
    left->items.clear();
    left->next = 0;
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
  Bucket* current_ = nullptr;                 ///< the bucket `front_`, once it has begun
  std::size_t front_ = 0;
  std::size_t count_ = 0;  ///< of items that have not been taken
};

}  // namespace gvd
