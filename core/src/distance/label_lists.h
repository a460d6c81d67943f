// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "base/tolerances.h"
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
    for (const LabelledDistance& d : distances_[vertex])
      if (d.label == label) return d.distance;
    return kInfinity;
  }
  /// The index in `LabelSpread::reached(label)` of the vertex, -1 if the label is not known.
  int reachedIndex(int vertex, int label) const {
    const auto known = distances_[vertex];
    for (size_t i = 0; i < known.size(); ++i)
      if (known[i].label == label) return indices_[vertex][i];
    return -1;
  }

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
  bool equalizeTies(int vertex, const TieTolerance& ties) {
    return gvd::equalizeTies(distances_[vertex], ties);
  }

 private:
  SmallLists<LabelledDistance> distances_;
  SmallLists<int> indices_;
};

}  // namespace gvd
