// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "distance/label_spread.h"

namespace gvd {

/// A loop over what some labels have reached, label after label, in slices: a single label may have
/// reached all of the mesh.
class ReachedLoop {
 public:
  /// Calls body(label, i, reached(label)[i]). Returns true when it has been called with all of
  /// them; the next loop then starts from the first label.
  template <class Body>
  bool run(const LabelSpread& spread, std::span<const int> labels, long& budget, Body body) {
    for (; next_ < labels.size(); ++next_) {
      const int label = labels[next_];
      const std::vector<ReachedVertex>& reached = spread.reached(label);
      if (!loop_.run(reached.size(), budget, kQuickRounds,
                     [&](int i) { body(label, i, reached[i]); }))
        return false;
    }
    next_ = 0;
    return true;
  }

 private:
  std::size_t next_ = 0;
  SlicedLoop loop_;  ///< over what the next label has reached
};

}  // namespace gvd
