// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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
    const int place = placeOf(vertex, label);
    return place < 0 ? kInfinity : distances_[vertex][place].distance;
  }
  /// The index in `LabelSpread::reached(label)` of the vertex, -1 if the label is not known.
  int reachedIndex(int vertex, int label) const {
    const int place = placeOf(vertex, label);
    return place < 0 ? -1 : reachedIndices(vertex)[place];
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
  /// The place of a label in the list of a vertex, -1 if it is not known. Halves long lists first;
  /// most are short.
  int placeOf(int vertex, int label) const {
    constexpr size_t kFew = 8;
    const auto all = distances_[vertex];
    auto known = all;
    while (known.size() > kFew) {
      const auto upper = known.subspan(known.size() / 2);
      known = upper.front().label <= label ? upper : known.first(known.size() / 2);
    }
    for (const LabelledDistance& d : known)
      if (d.label == label) return static_cast<int>(&d - all.data());
    return -1;
  }

  SmallLists<LabelledDistance> distances_;
  SmallLists<int> indices_;
};

}  // namespace gvd
