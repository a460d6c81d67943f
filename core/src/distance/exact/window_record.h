// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "distance/exact/window.h"

namespace gvd::exact {

/// The windows by which a label has crossed faces, from which its distances follow at all points of
/// these.
class WindowRecord {
 public:
  void add(int halfedge, const Window& w) { windows_.push_back({halfedge, w}); }
  /// To be called between `add` and `visit`.
  void sort() {
    const auto added = windows_.begin() + static_cast<std::ptrdiff_t>(sortedCount_);
    std::stable_sort(added, windows_.end(), before);
    std::inplace_merge(windows_.begin(), added, windows_.end(), before);
    sortedCount_ = windows_.size();
  }
  /// Calls `visit` with every window that has crossed the face of a halfedge from there.
  template <class Visit>
  void visit(int halfedge, Visit visit) const {
    auto it = std::lower_bound(windows_.begin(), windows_.end(), Entry{halfedge, {}}, before);
    for (; it != windows_.end() && it->halfedge == halfedge; ++it) visit(it->window);
  }

 private:
  struct Entry {
    int halfedge;
    Window window;
  };
  static bool before(const Entry& a, const Entry& b) { return a.halfedge < b.halfedge; }

  std::vector<Entry> windows_;
  size_t sortedCount_ = 0;
};

}  // namespace gvd::exact
