// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "distance/edge_bounds.h"
#include "distance/known_labels.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// What is to become of one label.
struct SiteChange {
  int label;
  std::optional<SurfacePoint> site;  ///< none: the label has no site any more
};

/// The changes by which all of these sites come, the labels in their order; face -1 is a label
/// without a site.
std::vector<SiteChange> arrivals(std::span<const SurfacePoint> sites);

/// The distances of sites that come, go and move. A first diagram is one change, in which all sites
/// come.
///
/// 1. *Bounds*: paths along edges limit the distance of the nearest site at every vertex.
/// 2. *Spread*: one label after another spreads from its site, to where it is not nearer than the
///    bounds, and lowers these. What a label finds does not depend on the others; they only stop
///    it. So after a change, new labels start, and those beside labels that have gone go on from
///    where they stopped.
/// 3. `KnownLabels`: distances that a diagram needs beyond those.
class SiteDistances final : public DistanceField {
 public:
  SiteDistances(const TriangleMesh& mesh, Metric metric, Spread spread = Spread::kAsNeeded);

  /// Begins a change of some labels, each named once. The one before must be done. Throws
  /// `Error(kInvalidPoint)`, and changes nothing, if a site is not on the mesh.
  void change(std::span<const SiteChange> changes);
  /// Works on at most `budget` units, about a microsecond each; true when the change is done.
  bool step(long budget);
  double progress() const;

  /// The faces and the labels that the last change may have altered: all others are known at the
  /// same vertices as before, with the same distances.
  const std::vector<int>& changedFaces() const { return known_.changedFaces(); }
  const std::vector<int>& changedLabels() const { return known_.changedLabels(); }

  const SiteSet& sites() const { return sites_; }

  std::span<const LabelledDistance> at(int vertex) const override { return known_[vertex]; }
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::span<const LabelledPoint> points) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const override;

 private:
  class PointDistances;
  enum class Stage { kBounds, kSpread, kKnown, kDone };
  struct LabelInFace {
    int label, face;
  };

  void forget(std::span<const int> labels);
  void lowerBounds();
  void lowerBy(int label);
  bool spread(long& budget);
  bool requireMissed();
  LabelInFace nearestAround(int vertex) const;
  bool isKnownAround(int label, const SurfacePoint& p) const;

  const TriangleMesh& mesh_;
  SiteSet sites_;
  EdgeBounds edgeBounds_;
  NearestBounds bounds_;
  std::unique_ptr<LabelSpread> spread_;
  KnownLabels known_;

  // The change at hand.
  Stage stage_ = Stage::kDone;
  std::vector<int> started_, resumed_;  ///< labels that spread
  /// A label's turn to spread: from its site, on from where it was, or on to all corners of faces.
  struct Turn {
    int label;
    enum { kStart, kResume, kRequire } how;
    std::vector<int> faces;
  };
  std::vector<Turn> turns_;
  size_t next_ = 0;  ///< of these
  bool isLabelBegun_ = false;
  std::vector<int> bounded_;        ///< vertices limited by paths along edges alone
  std::vector<int> resetVertices_;  ///< those of which the owners have left or are beyond bounds
};

}  // namespace gvd
