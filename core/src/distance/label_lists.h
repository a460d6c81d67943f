// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "base/small_lists.h"
#include "distance/label_spread.h"
#include "distance/labelled_distances.h"
#include "distance/nearest_bounds.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The labels known at each vertex, ascending, with their distances and their indices in
/// `LabelSpread::reached`.
class LabelLists {
 public:
  LabelLists(const LabelSpread& spread, const NearestBounds& bounds)
      : spread_(spread), bounds_(bounds) {}
  /// Makes room for the lists of so many vertices, in slices; true when it is there.
  bool prepare(int vertexCount, long& budget) {
    return distances_.addLists(vertexCount, budget) && indices_.addLists(vertexCount, budget) &&
           fillInSlices(isEqualized_, vertexCount, char{false}, budget);
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
  /// The distance of a label before `equalizeTies`: it does not depend on the other labels.
  /// Infinity if the label is not known.
  double foundDistance(int vertex, int label) const {
    if (!isEqualized_[vertex]) return distance(vertex, label);
    const int index = reachedIndex(vertex, label);
    return index < 0 ? kInfinity : listed(spread_.reached(label)[index]);
  }
  /// The least distance that a label may have in the list, whatever others are known.
  double leastDistance(int vertex, int label) const {
    return bounds_.ties().leastTying(foundDistance(vertex, label));
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
    isEqualized_[vertex] = false;
  }
  void clear(int vertex) {
    distances_.clear(vertex);
    indices_.clear(vertex);
    isEqualized_[vertex] = false;
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
  /// Also once labels were added since.
  void equalizeTies(int vertex) {
    if (isEqualized_[vertex])
      for (size_t i = 0; i < distances_[vertex].size(); ++i) {
        LabelledDistance& d = distances_[vertex][i];
        d.distance = listed(spread_.reached(d.label)[indices_[vertex][i]]);
      }
    isEqualized_[vertex] = gvd::equalizeTies(distances_[vertex], bounds_.ties()) ? 1 : 0;
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
  std::vector<char> isEqualized_;  ///< per vertex: whether `equalizeTies` has changed distances
};

}  // namespace gvd
