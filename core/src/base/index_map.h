// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "base/sliced_loop.h"

namespace gvd {

/// Numbers for some of the indices below a limit, such as the place of a vertex in a list. It takes
/// memory for all indices, but time only for those with a number, so that it can be used again and
/// again for small parts of a mesh.
class IndexMap {
 public:
  explicit IndexMap(std::size_t limit = 0) : numbers_(limit, kNone) {}
  /// Raises the limit of the indices, in slices; true when done.
  bool extend(std::size_t limit, long& budget) {
    return fillInSlices(numbers_, limit, kNone, budget);
  }

  /// The number of an index, -1 if it has none.
  int operator[](int index) const { return numbers_[index]; }
  /// Gives a number, which is not negative, to an index that has none.
  void add(int index, int number) {
    indices_.push_back(index);
    numbers_[index] = number;
  }
  /// How many indices have a number.
  int size() const { return static_cast<int>(indices_.size()); }
  /// Takes the numbers from all indices, in time proportional to those that have one.
  void clear() {
    for (const int index : indices_) numbers_[index] = kNone;
    indices_.clear();
  }

 private:
  static constexpr int kNone = -1;
  std::vector<int> numbers_;
  std::vector<int> indices_;  ///< with a number
};

}  // namespace gvd
