// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/hashing.h"
#include "base/sliced_loop.h"

namespace gvd {

/// Pairs of indices, such as the ends of sides, in either order: a hash table with chaining. Each
/// pair is numbered when it is first added. Not inlined, as the WebAssembly module would be larger.
class IndexPairs {
 public:
  /// Makes room for `count` pairs, in slices; true when it is there. To be called before any pair
  /// is added. Further pairs can be added, too, but pairs then take longer to find.
  [[gnu::noinline]] bool prepare(std::size_t count, long& budget) {
    pairs_.reserve(count);
    next_.reserve(count);
    return fillInSlices(first_, std::bit_ceil(count + 1), -1, budget);
  }

  /// Adds a pair; returns its number, which is the former `size()` if the pair is new.
  [[gnu::noinline]] int add(int a, int b) {
    const int known = find(a, b);
    if (known >= 0) return known;
    const std::array<int, 2> pair = {std::min(a, b), std::max(a, b)};
    next_.push_back(std::exchange(first_[bucketOf(pair)], size()));
    pairs_.push_back(pair);
    return size() - 1;
  }
  /// The number of a pair, -1 if it was not added.
  [[gnu::noinline]] int find(int a, int b) const {
    const std::array<int, 2> pair = {std::min(a, b), std::max(a, b)};
    int i = first_[bucketOf(pair)];
    while (i >= 0 && pairs_[i] != pair) i = next_[i];
    return i;
  }

  int size() const { return static_cast<int>(pairs_.size()); }
  /// A pair by its number, the lower index first.
  const std::array<int, 2>& operator[](int number) const { return pairs_[number]; }
  std::vector<std::array<int, 2>> take() { return std::move(pairs_); }

 private:
  std::size_t bucketOf(const std::array<int, 2>& pair) const {
    return hashOf(pair[1], hashOf(pair[0], 0)) & (first_.size() - 1);
  }

  std::vector<int> first_;  ///< per bucket, -1 for none
  std::vector<int> next_;   ///< per pair, the next in its bucket, -1 for none
  std::vector<std::array<int, 2>> pairs_;
};

}  // namespace gvd
