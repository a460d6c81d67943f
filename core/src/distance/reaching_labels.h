// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "base/small_lists.h"
#include "distance/label_spread.h"
#include "distance/reached_loop.h"

namespace gvd {

/// The labels that have reached each vertex. Only changes of a diagram need them, so they are
/// collected at the beginning of a change, from what labels have reached since the last one.
class ReachingLabels {
 public:
  explicit ReachingLabels(int vertexCount) : vertexCount_(vertexCount) {}

  /// Adds what the labels below `labelCount` have reached since the last change, in slices; true
  /// when that is done.
  bool collect(const LabelSpread& spread, int labelCount, long& budget) {
    constexpr long kVerticesPerUnit = 8, kLabelsPerUnit = 8;
    if (!lists_.addLists(vertexCount_, budget)) return false;
    collected_.resize(labelCount, 0);
    for (; next_ < labelCount; ++next_) {
      if (budget <= 0) return false;
      const auto& reached = spread.reached(next_);
      size_t& i = collected_[next_];
      const size_t end = endOfSlice(i, reached.size(), budget, kVerticesPerUnit);
      for (; i < end; ++i) lists_.add(reached[i].vertex, next_);
      if (end < reached.size()) return false;
      if (next_ % kLabelsPerUnit == 0) --budget;
    }
    next_ = 0;
    return true;
  }
  /// Removes some labels, in slices; true when that is done. Call before the spread forgets them.
  bool remove(const LabelSpread& spread, std::span<const int> labels, long& budget) {
    const IndexSet gone(static_cast<int>(collected_.size()), labels);
    for (const int label : labels) collected_[label] = 0;
    return loop_.run(spread, labels, budget, [&](int /*label*/, int /*i*/, const ReachedVertex& r) {
      lists_.eraseIf(r.vertex, [&](int other) { return gone.contains(other); });
    });
  }
  std::span<const int> operator[](int vertex) const { return lists_[vertex]; }

 private:
  const int vertexCount_;
  SmallLists<int> lists_;
  std::vector<size_t> collected_;  ///< per label, how many of the vertices it has reached
  int next_ = 0;                   ///< label to collect
  ReachedLoop loop_;
};

}  // namespace gvd
