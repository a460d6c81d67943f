// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "base/index_map.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"

namespace gvd::dgpc {

/// The approximate metric: geodesic polar coordinates. A label spreads on from a vertex if its
/// distance exceeds the edge bound (`EdgeBounds`) by at most the vertex's longest edge. The slack
/// is needed because the shortest path to a point that a label owns may cross edges whose ends
/// belong to other labels. Edge bounds depend on the sites alone, so the order in which labels
/// spread does not matter.
class UnfoldingSpread final : public LabelSpread {
 public:
  UnfoldingSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds);

  bool prepare(long& budget) override { return sweep_.prepare(budget); }
  void setEdgeBound(int vertex, double bound) override {
    sweep_.setReach(vertex, bound + mesh_.longestEdge(vertex));
  }
  void start(int label) override;
  void resume(int label) override;
  long require(int label, std::span<const int> faces) override;
  bool step(long& budget) override;
  int indexOf(int vertex) const override { return index_[vertex]; }
  void remove(std::span<const int> labels) override;

  const std::vector<ReachedVertex>& reached(int label) const override {
    return labels_[label].vertices;
  }
  void markFinal(int label, int index) override { labels_[label].vertices[index].isFinal = true; }
  bool dependsOnEdgeBounds() const override { return true; }
  std::vector<LabelledDistance> nearestAt(const SurfacePoint& p, const DistanceField& known,
                                          long& budget) override;
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points, const DistanceField& known) override;
  Eigen::Vector2d direction(int label, int index) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) override;

 private:
  struct LabelState {
    std::vector<ReachedVertex> vertices;
    std::vector<Eigen::Vector2d> directions;  ///< at the site, per entry of `vertices`
    int sweptCount = 0;                       ///< these come first; the others were required
  };
  void index(int label);
  void store();
  void requireVertex(LabelState& state, int vertex);
  void takeRequired();
  class PointDistances;
  /// `atVertex` gives the label's distance at a vertex.
  template <class AtVertex>
  double distanceAt(int label, const SurfacePoint& p, AtVertex atVertex) const;

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  NearestBounds& bounds_;
  UnfoldingSweep sweep_;
  std::vector<LabelState> labels_;
  int running_ = -1;  ///< the label that spreads
  int indexed_ = -1;  ///< the label that was required, or whose path was asked for, last
  IndexMap index_;    ///< of its vertices
};

}  // namespace gvd::dgpc
