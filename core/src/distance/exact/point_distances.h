// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "distance/exact/window_sweep.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"

namespace gvd::exact {

/// Caches the first distance found for a label at a point. After the label has spread on, the same
/// path may come from other windows and round differently; but when part of a dynamic diagram is
/// traced again, it must match the rest to the last bit.
class FoundDistances {
 public:
  /// Infinity if not found yet.
  double find(const LabelledPoint& p) const;
  void add(const LabelledPoint& p, double distance);
  /// Forgets all of a label.
  void remove(int label);

 private:
  struct Order {
    bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
      return std::tie(a.face, a.bary[0], a.bary[1], a.bary[2]) <
             std::tie(b.face, b.bary[0], b.bary[1], b.bary[2]);
    }
  };
  /// Per label, by point; on an edge, in one face only (`unique`).
  std::vector<std::map<SurfacePoint, double, Order>> ofLabel_;
};

/// The distances of labels at many points that are no vertices. Windows that have crossed faces are
/// not kept, so each label spreads once more with its points: first as far as it is nearest, then
/// on to its points where another label is nearer.
class PointDistances final : public SlicedWork<std::vector<double>> {
 public:
  /// The labels must be known around the points. `bounds` are final. Working memory for the whole
  /// mesh is taken from `spare`, or allocated if that is null, and left there by `result`.
  PointDistances(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                 FoundDistances& found, std::unique_ptr<WindowSweep>& spare,
                 std::vector<LabelledPoint> points);

  bool advance(long budget) override;
  double share() const override;
  std::vector<double> result() override;

 private:
  void sortOut(int index);
  bool spread(long& budget);
  bool spreadOne(long& budget);
  void addRequired(int open);
  void keep(int open, double distance);
  double nearestAtLeast(const SurfacePoint& p) const;

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  NearestBounds& bounds_;
  FoundDistances& found_;
  /// All points, later only the *open* ones, whose distances have not been found before.
  std::vector<LabelledPoint> points_;
  std::unique_ptr<WindowSweep>& spare_;
  std::unique_ptr<WindowSweep> sweep_;  ///< null while no point is open
  SlicedSequence sequence_;
  std::vector<double> distances_;
  std::vector<int> open_;  ///< the open points' indices in `distances_`
  Grouping byLabel_;       ///< the open points' indices in `points_`
  size_t doneCount_ = 0;   ///< of these

  // The current label, and what it is required at: all of its open points.
  int label_ = 0;
  SlicedSequence turn_;
  LabelState state_;
  std::vector<RequiredPoint> required_;
};

}  // namespace gvd::exact
