// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "distance/exact/window.h"

namespace gvd::exact {

/// The windows by which a label has crossed faces, from which its distances follow at all points of
/// these. They are millions where one label crosses a whole mesh: they stay where they are put, and
/// what is sorted is where to find them.
class WindowRecord {
 public:
  void add(int halfedge, const Window& w) {
    places_.push_back(placeOf(halfedge, windows_.size()));
    windows_.push_back(w);
  }
  /// To be called between `add` and `visit`.
  void sort() {
    const auto added = places_.begin() + static_cast<std::ptrdiff_t>(sortedCount_);
    std::sort(added, places_.end());
    std::inplace_merge(places_.begin(), added, places_.end());
    sortedCount_ = places_.size();
  }
  /// Calls `visit` with every window that has crossed the face of a halfedge from there.
  template <class Visit>
  void visit(int halfedge, Visit visit) const {
    auto it = std::lower_bound(places_.begin(), places_.end(), placeOf(halfedge, 0));
    for (; it != places_.end() && *it < placeOf(halfedge + 1, 0); ++it)
      visit(windows_[static_cast<std::uint32_t>(*it)]);
  }

 private:
  /// A halfedge and the index of a window there, in one number.
  static std::uint64_t placeOf(int halfedge, std::size_t index) {
    return static_cast<std::uint64_t>(halfedge) << 32 | index;
  }

  std::deque<Window> windows_;
  std::vector<std::uint64_t> places_;
  std::size_t sortedCount_ = 0;
};

}  // namespace gvd::exact
