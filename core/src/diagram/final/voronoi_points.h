// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "diagram/final/final_points.h"
#include "diagram/final/region_outlines.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/diagram.h"

namespace gvd {

/// Collects the Voronoi points of a diagram, in order of the graph's points. An unmerged inner
/// point of the graph has its three labels; it is left out if all its segments led to one merged
/// point, so that no outline reaches it. The labels around a merged point are found from the
/// outlines through it.
class VoronoiPoints {
 public:
  VoronoiPoints(BisectorGraph& graph, const RegionOutlines& outlines, FinalPoints& points,
                Diagram& diagram)
      : graph_(graph), outlines_(outlines), points_(points), out_(diagram) {}
  bool step(long& budget);

 private:
  /// A region's outline that comes to a point from `before` and leaves it to `after` covers the
  /// sector counterclockwise from `after` to `before`.
  struct Sector {
    int point;
    int label, before, after;
  };

  void collectSectors(int outline);
  void addMerged(int point);
  void add(int point, std::vector<int> labels);
  static void orderAround(std::span<Sector> sectors);
  bool isOnOutline(int point) const { return isOnOutline_.empty() || isOnOutline_[point]; }
  static bool joinRounds(std::span<Sector> chained, std::span<Sector> others);

  BisectorGraph& graph_;
  const RegionOutlines& outlines_;
  FinalPoints& points_;
  Diagram& out_;
  SlicedSequence sequence_;
  std::vector<char> isOnOutline_;  ///< per point; empty if none are merged: all are then
  std::vector<Sector> sectors_;    ///< at merged points
  Grouping byPoint_;               ///< sectors
};

}  // namespace gvd
