// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace gvd {

/// The merged points of a graph: a union-find structure over point numbers (Tarjan 1975). Allocates
/// only up to the last merged point, because there are usually few or none.
class PointMerging {
 public:
  /// The representative of all points merged with `point`.
  int root(int point) {
    if (point >= limit()) return point;
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }

  /// Merges the root `b` and its members into the root `a`.
  void unite(int a, int b) {
    if (const int last = std::max(a, b), first = limit(); first <= last) {
      isMerged_.resize(last + 1);
      for (std::vector<int>* const list : {&parent_, &nextMember_}) {
        list->resize(last + 1);
        std::iota(list->begin() + first, list->end(), first);
      }
    }
    parent_[b] = a;
    std::swap(nextMember_[a], nextMember_[b]);
    isMerged_[a] = true;
  }

  /// Whether `isOne` is true for any member of a root.
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
  /// Whether a root has several members.
  bool isMerged(int root) const { return root < limit() && isMerged_[root]; }
  bool any() const { return !parent_.empty(); }
  /// All points from this number on are unmerged.
  int limit() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
  std::vector<int> nextMember_;  ///< rings of merged points
  std::vector<char> isMerged_;   ///< of roots
};

}  // namespace gvd
