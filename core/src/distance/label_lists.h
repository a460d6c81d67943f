// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "base/small_lists.h"
#include "distance/label_spread.h"
#include "distance/labelled_distances.h"
#include "distance/nearest_bounds.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A label in the list of a vertex.
struct LabelAtVertex {
  int vertex, label;
};

/// The labels known at each vertex, ascending, with their distances and their indices in
/// `LabelSpread::reached`.
class LabelLists {
 public:
  LabelLists(const LabelSpread& spread, const NearestBounds& bounds)
      : spread_(spread), bounds_(bounds) {}
  /// Makes room for the lists of so many vertices, in slices; true when it is there.
  bool prepare(int vertexCount, long& budget) {
    return distances_.addLists(vertexCount, budget) && indices_.addLists(vertexCount, budget);
  }

  std::span<const LabelledDistance> operator[](int vertex) const { return distances_[vertex]; }
  /// The distance of a label, infinity if it is not known.
  double distance(int vertex, int label) const { return distanceIn(distances_[vertex], label); }
  /// The index in `LabelSpread::reached(label)` of the vertex, -1 if the label is not known.
  int reachedIndex(int vertex, int label) const {
    const auto known = distances_[vertex];
    const LabelledDistance* const found = findLabel(known, label);
    return found ? indices_[vertex][found - known.data()] : -1;
  }
  /// Those of all labels in the list.
  std::span<const int> reachedIndices(int vertex) const { return indices_[vertex]; }

  /// Gives up all lists, each of which is then to be allotted; `total` is the room for all labels.
  void beginAllotting(size_t total) {
    distances_.beginAllotting(total);
    indices_.beginAllotting(total);
  }
  /// Makes a list empty, with room for `count` labels.
  void allot(int vertex, int count) {
    distances_.allot(vertex, count);
    indices_.allot(vertex, count);
  }
  void clear(int vertex) {
    distances_.clear(vertex);
    indices_.clear(vertex);
  }
  /// Adds a label at the vertex `reached(label)[reachedIndex]`, where it is not known yet.
  void add(int label, int reachedIndex) {
    const ReachedVertex& reached = spread_.reached(label)[reachedIndex];
    const auto known = distances_[reached.vertex];
    size_t index = known.size();
    while (index > 0 && known[index - 1].label > label) --index;
    distances_.insert(reached.vertex, index, {label, listed(reached)});
    indices_.insert(reached.vertex, index, reachedIndex);
  }
  void equalizeTies(int vertex) { gvd::equalizeTies(distances_[vertex], bounds_.ties()); }
  /// The same once labels were added since, from the distances that the labels have found: listed
  /// ones may have been lowered, and the result must not depend on the order of labels.
  void equalizeTiesAgain(int vertex) {
    for (size_t i = 0; i < distances_[vertex].size(); ++i) {
      LabelledDistance& d = distances_[vertex][i];
      d.distance = listed(spread_.reached(d.label)[indices_[vertex][i]]);
    }
    equalizeTies(vertex);
  }
  /// Whether `equalizeTies` would change the distance of a known label, or of another to its own.
  bool hasUnequalTie(int vertex, int label) const {
    const double own = distance(vertex, label);
    const auto known = distances_[vertex];
    return std::any_of(known.begin(), known.end(), [&](const LabelledDistance& d) {
      return bounds_.ties().tieUnequally(d.distance, own);
    });
  }

 private:
  /// An approximate (DGPC) distance may come out shorter than the owner's: keeps the owner nearest.
  double listed(const ReachedVertex& r) const {
    const double nearest = bounds_[r.vertex].distance;
    return r.distance < nearest ? std::nextafter(nearest, kInfinity) : r.distance;
  }

  const LabelSpread& spread_;
  const NearestBounds& bounds_;
  SmallLists<LabelledDistance> distances_;
  SmallLists<int> indices_;
};

}  // namespace gvd
