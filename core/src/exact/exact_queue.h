// SPDX-License-Identifier: MIT
// This work is based on:
// Chunxu Xu, Tuanfeng Wang, Yong-Jin Liu, Ligang Liu, Ying He. Fast Wavefront Propagation (FWP) for
// Computing Exact Geodesic Distances on Meshes. 2015
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "exact/exact_window.h"

namespace gvd::exact {

/// A vertex to become a virtual source of a label, if its distance still is this one then.
struct Event {
  int entry;
  int next;
  double distance;
};

/// What waits to spread, in buckets of distance. Within a bucket windows come before events, and
/// each in the order in which they were added. Windows in wrong order are no error: they are
/// trimmed again when they are taken.
class WavefrontQueue {
 public:
  explicit WavefrontQueue(double bucketWidth) : bucketWidth_(bucketWidth) {}

  /// Goes to the first bucket in which something waits; true if there is none.
  bool isEmpty() {
    while (bucket_ < buckets_.size() && buckets_[bucket_].isEmpty()) ++bucket_;
    return bucket_ == buckets_.size();
  }
  /// Of the bucket that `isEmpty` went to, as the following two.
  bool hasWindow() const { return buckets_[bucket_].firstWindow >= 0; }
  int takeWindow(const WindowPool& windows) {
    const int id = buckets_[bucket_].firstWindow;
    buckets_[bucket_].firstWindow = windows[id].next;
    return id;
  }
  Event takeEvent() {
    const Event event = events_[buckets_[bucket_].firstEvent];
    buckets_[bucket_].firstEvent = event.next;
    return event;
  }

  void addWindow(WindowPool& windows, int id) {
    Bucket& b = bucketFor(windows[id].least());
    windows[id].next = -1;
    (b.firstWindow < 0 ? b.firstWindow : windows[b.lastWindow].next) = id;
    b.lastWindow = id;
  }
  void addEvent(int entry, double distance) {
    Bucket& b = bucketFor(distance);
    const int id = static_cast<int>(events_.size());
    events_.push_back({entry, -1, distance});
    (b.firstEvent < 0 ? b.firstEvent : events_[b.lastEvent].next) = id;
    b.lastEvent = id;
  }

  /// Lets what comes be put into any bucket again; before, it goes to the current one at least.
  void rewind() { bucket_ = 0; }

 private:
  struct Bucket {
    int firstWindow = -1, lastWindow = -1;
    int firstEvent = -1, lastEvent = -1;
    bool isEmpty() const { return firstWindow < 0 && firstEvent < 0; }
  };

  Bucket& bucketFor(double distance) {
    const std::size_t b = std::max(bucket_, static_cast<std::size_t>(distance / bucketWidth_));
    if (b >= buckets_.size()) buckets_.resize(b + 1);
    return buckets_[b];
  }

  std::vector<Bucket> buckets_;
  std::vector<Event> events_;
  std::size_t bucket_ = 0;
  double bucketWidth_;
};

}  // namespace gvd::exact
