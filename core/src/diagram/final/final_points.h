// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/surface_point.h"

namespace gvd {

/// The points of a diagram. If none are merged, they are the points of its graph. Otherwise they
/// are the roots of the points in use, numbered in order of first use.
class FinalPoints {
 public:
  FinalPoints(BisectorGraph& graph, std::vector<SurfacePoint>& places)
      : graph_(graph), places_(places) {}

  /// Takes the points out of the graph if none are merged, else makes room for them; true when
  /// done. The first call, before any point is numbered.
  bool prepare(long& budget) {
    if (areThoseOfGraph()) {
      places_ = std::move(graph_.places);
      return true;
    }
    places_.reserve(graph_.points.size());
    roots_.reserve(graph_.points.size());
    return fillInSlices(index_, graph_.points.size(), -1, budget);
  }

  /// Whether the points, with their numbers, are those of the graph.
  bool areThoseOfGraph() const { return !graph_.merging.any(); }

  /// The number of a point of the graph.
  int number(int point) {
    if (areThoseOfGraph()) return point;
    const int root = graph_.merging.root(point);
    if (index_[root] < 0) {
      index_[root] = static_cast<int>(places_.size());
      places_.push_back(graph_.places[root]);
      roots_.push_back(root);
    }
    return index_[root];
  }

  /// The point of the graph that has a number, if points are merged.
  int root(int number) const { return roots_[number]; }

 private:
  BisectorGraph& graph_;
  std::vector<SurfacePoint>& places_;
  // If points are merged:
  std::vector<int> roots_;
  std::vector<int> index_;  ///< per point of the graph, -1 if not in use yet
};

}  // namespace gvd
