// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/grouping.h"
#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/bounds_lowering.h"
#include "distance/edge_bounds.h"
#include "distance/given_sites.h"
#include "distance/known_labels.h"
#include "distance/label_change.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/reached_loop.h"
#include "distance/reaching_labels.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if distances that `propagate` gave are those of another mesh.
void requireMesh(const TriangleMesh& mesh, const DistanceField& distances);

/// The distances of sites that are inserted, removed and moved. The first change inserts all sites
/// that there are to begin with. Of sites at one place, only one takes part (`GivenSites`). A
/// change has three stages:
///
/// 1. *Bounds* (`EdgeBounds`): the length of the shortest path along edges is an upper bound on the
///    distance of the nearest site at every vertex.
/// 2. *Spread* (`BoundsLowering`, `LabelSpread`): each label in turn spreads from its site and
///    lowers the bounds: with the exact metric while it is nearer than they are, with DGPC as far
///    as the edge bounds allow. Other labels limit how far a label spreads, not the distances it
///    finds. So after a change, new labels start, and labels that have reached vertices of removed
///    ones resume from where they stopped.
/// 3. *Known labels* (`KnownLabels`): adds the distances that a diagram needs at vertices owned by
///    other labels.
class SiteDistances final : public DistanceField {
 public:
  /// Begins to insert sites, labelled by their index; face -1 is a label without a site. Throws as
  /// `change` does.
  SiteDistances(const TriangleMesh& mesh, Metric metric, std::span<const SurfacePoint> sites);

  /// Begins a change of some labels, each named once. The previous change must be done. Throws
  /// `Error(kInvalidPoint)`, and changes nothing, if a site is not on the mesh.
  void change(std::span<const SiteChange> changes);
  /// Works on at most `budget` units, about a microsecond each; true when the change is done.
  bool step(long& budget);
  double progress() const;

  /// The faces and labels that the last change may have altered. Elsewhere the same labels are
  /// known at the same vertices, with the same distances.
  const IndexSet& changedFaces() const { return known_.changedFaces(); }
  const std::vector<int>& changedLabels() const { return known_.changedLabels(); }

  /// The sites as they were given, also those that take no part.
  const SiteSet& sites() const { return given_.all(); }
  const TriangleMesh& mesh() const { return mesh_; }
  /// Whether a `DynamicDiagram` changes these distances: then no other one may.
  bool isTaken() const { return isTaken_; }
  void markTaken() { isTaken_ = true; }

  std::span<const LabelledDistance> at(int vertex) const override { return known_.lists()[vertex]; }
  using DistanceField::nearest;
  LabelledDistance nearest(const SurfacePoint& given, long& budget) const override;
  double distance(int label, const SurfacePoint& p) const override;
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& given) const override;

 private:
  class DistancesAtPoints;
  void findLeaving();
  bool forget(long& budget);
  void forgetAt(int label, const ReachedVertex& r);
  void removeSite(int label);
  void insertSite(const SiteChange& change);
  bool findOutdated(SlicedLoop& loop, long& budget);
  void placeStarted(int label);
  void orderLabels();
  bool isKnownAround(int label, const SurfacePoint& p) const;

  const TriangleMesh& mesh_;
  bool isTaken_ = false;
  GivenSites given_;
  SiteSet sites_;  ///< those that take part
  EdgeBounds edgeBounds_;
  NearestBounds bounds_;
  std::unique_ptr<LabelSpread> spread_;
  LabelChange change_;  ///< the current one
  ReachingLabels reaching_;
  BoundsLowering lowering_;
  KnownLabels known_;

  // The current change.
  SlicedSequence sequence_, forgetting_;
  ReachedLoop reachedLoop_;
  std::vector<int> forgotten_;         ///< labels that leave, then those that start again
  IndexSet forgottenAt_;               ///< vertices where a label was forgotten
  IndexSet resumed_{0}, outdated_{0};  ///< labels
  std::vector<KeyedItem> startedPlaces_;
};

}  // namespace gvd
