// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/small_lists.h"
#include "distance/label_spread.h"

namespace gvd {

/// The labels that have reached each vertex. Only changes of a diagram need them, so they are
/// collected at the beginning of a change, from what labels have reached since the last one.
class ReachingLabels {
 public:
  explicit ReachingLabels(int vertexCount) : lists_(vertexCount) {}

  /// Adds what the labels below `labelCount` have reached since the last call.
  void collect(const LabelSpread& spread, int labelCount) {
    collected_.resize(labelCount, 0);
    for (int label = 0; label < labelCount; ++label) {
      const auto& reached = spread.reached(label);
      for (size_t& i = collected_[label]; i < reached.size(); ++i)
        lists_.add(reached[i].vertex, label);
    }
  }
  /// Removes some labels. Call before the spread forgets them.
  void remove(const LabelSpread& spread, std::span<const int> labels) {
    const IndexSet gone(static_cast<int>(collected_.size()), labels);
    for (const int label : labels) {
      for (const ReachedVertex& r : spread.reached(label))
        lists_.eraseIf(r.vertex, [&](int other) { return gone.contains(other); });
      collected_[label] = 0;
    }
  }
  std::span<const int> operator[](int vertex) const { return lists_[vertex]; }

 private:
  SmallLists<int> lists_;
  std::vector<size_t> collected_;  ///< per label, how many of the vertices it has reached
};

}  // namespace gvd
