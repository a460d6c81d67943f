// SPDX-License-Identifier: MIT
//
// Sets of indices of vertices, faces or labels.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace gvd {

/// Some of the indices below a limit, each once.
class IndexSet {
 public:
  explicit IndexSet(int limit) : isIn_(limit) {}
  IndexSet(int limit, std::span<const int> indices) : IndexSet(limit) {
    for (const int i : indices) add(i);
  }

  /// Adds an index; returns whether it is new.
  bool add(int i) {
    if (isIn_[i]) return false;
    isIn_[i] = true;
    list_.push_back(i);
    return true;
  }
  /// Makes it the set of all indices.
  void addAll() {
    std::fill(isIn_.begin(), isIn_.end(), true);
    list_.resize(isIn_.size());
    std::iota(list_.begin(), list_.end(), 0);
  }
  /// Empties the set, in time proportional to its size.
  void clear() {
    for (const int i : list_) isIn_[i] = false;
    list_.clear();
  }
  bool contains(int i) const { return isIn_[i]; }
  int size() const { return static_cast<int>(list_.size()); }
  /// The indices in the order in which they were added.
  const std::vector<int>& list() const { return list_; }
  std::vector<int> sorted() const {
    std::vector<int> result = list_;
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  std::vector<char> isIn_;
  std::vector<int> list_;
};

/// Sorts a list of indices and drops duplicates. Quick if the list is mostly a sorted set to which
/// a few indices were appended.
inline void makeSet(std::vector<int>& indices) {
  const auto added = std::is_sorted_until(indices.begin(), indices.end());
  std::sort(added, indices.end());
  std::inplace_merge(indices.begin(), added, indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

}  // namespace gvd
