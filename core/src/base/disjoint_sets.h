// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace gvd {

/// Disjoint sets of numbers, such as points that are merged (union-find, Tarjan 1975). Each number
/// is alone at first. Allocates only up to the last united one: mostly there are few or none.
class DisjointSets {
 public:
  /// The representative of the set that a number is in.
  int root(int i) {
    if (i >= limit()) return i;
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Unites the sets of two roots; `a` becomes their root.
  void unite(int a, int b) {
    if (const int last = std::max(a, b), first = limit(); first <= last) {
      hasOthers_.resize(last + 1);
      for (std::vector<int>* const list : {&parent_, &nextMember_}) {
        list->resize(last + 1);
        std::iota(list->begin() + first, list->end(), first);
      }
    }
    parent_[b] = a;
    std::swap(nextMember_[a], nextMember_[b]);
    hasOthers_[a] = true;
  }

  /// Whether a predicate is true for any member of a root's set.
  template <class Predicate>
  bool anyMember(int root, Predicate predicate) const {
    int i = root;
    do {
      if (predicate(i)) return true;
      if (i < limit()) i = nextMember_[i];
    } while (i != root);
    return false;
  }

  bool isRoot(int i) const { return i >= limit() || parent_[i] == i; }
  /// Whether a root's set has several members.
  bool isMerged(int root) const { return root < limit() && hasOthers_[root]; }
  bool any() const { return !parent_.empty(); }
  /// All numbers from this one on are alone.
  int limit() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
  std::vector<int> nextMember_;  ///< the ring of each set
  std::vector<char> hasOthers_;  ///< of roots
};

}  // namespace gvd
