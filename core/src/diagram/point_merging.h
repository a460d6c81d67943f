// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace gvd {

/// Which points are one: a union-find structure over points by number (Tarjan 1975). Takes memory
/// up to the last point that is one with another only, for mostly there are few or none.
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
      nextMember_.push_back(limit() - 1);
      isMerged_.push_back(false);
    }
    parent_[b] = a;
    std::swap(nextMember_[a], nextMember_[b]);
    isMerged_[a] = true;
  }

  /// Whether `isOne` of any of the points that a root stands for.
  template <class Predicate>
  bool anyMember(int root, Predicate isOne) const {
    int point = root;
    do {
      if (isOne(point)) return true;
      if (point < limit()) point = nextMember_[point];
    } while (point != root);
    return false;
  }

  bool isRoot(int point) const { return point >= limit() || parent_[point] == point; }
  /// Whether a root stands for several points.
  bool isMerged(int root) const { return root < limit() && isMerged_[root]; }
  bool any() const { return !parent_.empty(); }
  /// All points from this on are one with no other.
  int limit() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
  std::vector<int> nextMember_;  ///< rings of the points that are one
  std::vector<char> isMerged_;   ///< of roots
};

}  // namespace gvd
