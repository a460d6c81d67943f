// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "distance/exact/window_sweep.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"

namespace gvd::exact {

/// The exact metric: polyhedral distance by windows (Mitchell et al. 1987). Keeps the windows of
/// all labels, from which the distance follows at every point of the surface.
class WindowSpread final : public LabelSpread {
 public:
  WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
               SpreadTo startTo);

  void start(int label) override;
  void resume(int label) override;
  void require(int label, std::span<const int> faces) override;
  void require(int label, std::span<RequiredPoint> points) override;
  bool run(long& budget) override;
  void remove(int label) override;

  std::vector<ReachedVertex>& reached(int label) override { return labels_[label].vertices; }
  const std::vector<ReachedVertex>& reached(int label) const override {
    return labels_[label].vertices;
  }
  std::vector<int> outdated(std::span<const int> /*changedVertices*/) override { return {}; }
  void appendReaching(int /*vertex*/, std::vector<int>& /*labels*/) override {}
  void appendLabelsInside(int face, std::vector<int>& labels) const override;
  double distance(int label, const SurfacePoint& p,
                  const std::array<double, 3>& atCorners) const override;
  Eigen::Vector2d direction(int label, int index) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const override;

 private:
  /// Windows of a label at a halfedge, in a list of those of all labels there.
  struct Entry {
    int label;
    int firstBlock;
    int next;
  };
  void addEntries(int label, size_t firstCrossed);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  const NearestBounds& bounds_;
  const SpreadTo startTo_;
  WindowSweep sweep_;
  std::vector<LabelWindows> labels_;
  std::vector<int> firstEntry_;  ///< per halfedge, -1
  std::vector<Entry> entries_;
  std::vector<int> freeEntries_;
  // The label at hand.
  int label_ = -1;
  size_t crossedBefore_ = 0;
};

}  // namespace gvd::exact
