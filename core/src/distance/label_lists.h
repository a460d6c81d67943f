// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "base/tolerances.h"
#include "distance/common_labels.h"
#include "distance/small_lists.h"
#include "gvd/geodesic.h"

namespace gvd {

/// The labels known at each vertex, ascending, with their distances and their indices in
/// `LabelSpread::reached`.
class LabelLists {
 public:
  explicit LabelLists(int vertexCount) : distances_(vertexCount), indices_(vertexCount) {}

  std::span<const LabelledDistance> operator[](int vertex) const { return distances_[vertex]; }
  /// The distance of a label, infinity if it is not known.
  double distance(int vertex, int label) const {
    const LabelledDistance* const found = findLabel(distances_[vertex], label);
    return found ? found->distance : kInfinity;
  }
  /// The index in `LabelSpread::reached(label)` of the vertex, -1 if the label is not known.
  int reachedIndex(int vertex, int label) const {
    const auto known = distances_[vertex];
    const LabelledDistance* const found = findLabel(known, label);
    return found ? indices_[vertex][found - known.data()] : -1;
  }
  /// The same of each label in the list.
  std::span<const int> reachedIndices(int vertex) const { return indices_[vertex]; }

  /// Empties all lists, with room for `counts[v]` labels at vertex v.
  void allot(std::span<const int> counts) {
    distances_.allot(counts);
    indices_.allot(counts);
  }
  void clear(int vertex) {
    distances_.clear(vertex);
    indices_.clear(vertex);
  }
  /// Adds a label that is not known yet.
  void add(int vertex, const LabelledDistance& added, int reachedIndex) {
    const auto known = distances_[vertex];
    size_t place = known.size();
    while (place > 0 && known[place - 1].label > added.label) --place;
    distances_.insert(vertex, place, added);
    indices_.insert(vertex, place, reachedIndex);
  }
  void equalizeTies(int vertex, const TieTolerance& ties) {
    gvd::equalizeTies(distances_[vertex], ties);
  }
  /// Whether `equalizeTies` would change the distance of a known label, or of another to its own.
  bool hasUnequalTie(int vertex, int label, const TieTolerance& ties) const {
    const double own = distance(vertex, label);
    const auto known = distances_[vertex];
    return std::any_of(known.begin(), known.end(), [&](const LabelledDistance& d) {
      return ties.tieUnequally(d.distance, own);
    });
  }

 private:
  SmallLists<LabelledDistance> distances_;
  SmallLists<int> indices_;
};

}  // namespace gvd
