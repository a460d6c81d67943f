// SPDX-License-Identifier: MIT
//
// Sets of indices of vertices, faces or labels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"

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
  /// Makes an empty set the set of all indices, in slices; true when it is.
  bool addAll(long& budget) {
    constexpr long kIndicesPerUnit = 128;
    list_.reserve(isIn_.size());
    std::size_t i = list_.size();
    const std::size_t end = endOfSlice(i, isIn_.size(), budget, kIndicesPerUnit);
    list_.resize(end);
    for (; i < end; ++i) {
      list_[i] = static_cast<int>(i);
      isIn_[i] = true;
    }
    return end == isIn_.size();
  }
  /// Raises the limit of the indices.
  void extend(int limit) { isIn_.resize(limit); }
  /// Empties the set, in time proportional to its size.
  void clear() {
    for (const int i : list_) isIn_[i] = false;
    list_.clear();
  }
  bool contains(int i) const { return isIn_[i]; }
  int size() const { return static_cast<int>(list_.size()); }
  /// The indices in the order in which they were added.
  const std::vector<int>& list() const { return list_; }
  /// In time proportional to the limit at most, because sorting a large share takes longer.
  std::vector<int> sorted() const {
    constexpr std::size_t kLargeShare = 16;  // a sixteenth
    if (list_.size() < isIn_.size() / kLargeShare) {
      std::vector<int> result = list_;
      std::sort(result.begin(), result.end());
      return result;
    }
    std::vector<int> result;
    result.reserve(list_.size());
    for (std::size_t i = 0; i < isIn_.size(); ++i)
      if (isIn_[i]) result.push_back(static_cast<int>(i));
    return result;
  }

 private:
  std::vector<char> isIn_;
  std::vector<int> list_;
};

/// All indices below a limit, ascending.
inline std::vector<int> indicesBelow(int limit) {
  std::vector<int> indices(limit);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// Sorts a list of indices and drops duplicates. Quick if the list is mostly a sorted set to which
/// a few indices were appended.
inline void makeSet(std::vector<int>& indices) {
  const auto added = std::is_sorted_until(indices.begin(), indices.end());
  std::sort(added, indices.end());
  std::vector<int> merged(indices.size());
  std::merge(indices.begin(), added, added, indices.end(), merged.begin());
  merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
  indices.swap(merged);
}

}  // namespace gvd
