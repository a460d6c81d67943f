// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

namespace gvd {

/// Which points are one: a union-find structure over points by number (Tarjan 1975). Takes memory up
/// to the last point that is one with another only, for mostly there are few or none.
class PointMerging {
 public:
  /// The point that stands for all that are one with `point`.
  int root(int point) {
    if (point >= limit()) return point;
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }

  /// Makes the root `b` and all it stands for one with the root `a`, which stands for them then.
  void unite(int a, int b) {
    while (limit() <= std::max(a, b)) {
      parent_.push_back(limit());
      isMerged_.push_back(false);
    }
    parent_[b] = a;
    isMerged_[a] = true;
  }

  bool isRoot(int point) const { return point >= limit() || parent_[point] == point; }
  /// Whether a root stands for several points.
  bool isMerged(int root) const { return root < limit() && isMerged_[root]; }
  bool any() const { return !parent_.empty(); }
  /// All points from this on are one with no other.
  int limit() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
  std::vector<char> isMerged_;  ///< of roots
};

}  // namespace gvd
