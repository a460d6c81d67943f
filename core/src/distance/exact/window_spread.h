// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/index_map.h"
#include "distance/exact/label_state.h"
#include "distance/exact/point_distances.h"
#include "distance/exact/window_sweep.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"

namespace gvd::exact {

/// The exact metric: polyhedral distance by windows (Mitchell et al. 1987). Keeps distances at
/// vertices. At other points, a search from the point back to vertices and sites finds the nearest
/// labels (`WindowSweep::search`); for the distance of another label, its windows spread once more
/// (`PointDistances`).
class WindowSpread final : public LabelSpread {
 public:
  WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds);

  bool prepare(long& budget) override { return sweep_.prepare(budget); }
  void setEdgeBound(int /*vertex*/, double /*bound*/) override {}
  void start(int label) override;
  void resume(int label) override;
  long require(int label, std::span<const int> faces) override;
  bool step(long& budget) override { return sweep_.step(budget); }
  int indexOf(int vertex) const override { return sweep_.indexOf(vertex); }
  void remove(std::span<const int> labels) override;

  const std::vector<ReachedVertex>& reached(int label) const override {
    return labels_[label].vertices;
  }
  void markFinal(int label, int index) override;
  bool dependsOnEdgeBounds() const override { return false; }
  std::vector<LabelledDistance> nearestAt(const SurfacePoint& p, const DistanceField& known,
                                          long& budget) override;
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points, const DistanceField& known) override;
  Eigen::Vector2d direction(int label, int index) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) override;

 private:
  class NearestLabels;
  class OneLabel;
  /// The distance of a label at a point, and the path to its site as it was followed.
  struct FoundPath {
    std::vector<SurfacePoint> points;
    double distance;
  };
  LabelState& stateOf(int label);
  FoundPath followedBack(int label, const SurfacePoint& p);
  std::vector<SurfacePoint> pathBack(const SurfacePoint& p, int label, const LabelState& state);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  NearestBounds& bounds_;
  WindowSweep sweep_;
  IndexMap index_;
  std::vector<LabelState> labels_;
  FoundDistances found_;
  std::unique_ptr<WindowSweep> spare_;  ///< for `PointDistances`; null while one has it
};

}  // namespace gvd::exact
