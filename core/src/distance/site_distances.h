// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "base/index_set.h"
#include "distance/edge_bounds.h"
#include "distance/face_owners.h"
#include "distance/label_lists.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// What is to become of one label.
struct SiteChange {
  int label;
  SurfacePoint site;  ///< face -1: the label has no site any more
};

/// The distances of sites that come, go and move. A first diagram is one change, in which all sites
/// come.
///
/// 1. *Bounds*: paths along edges limit the distance of the nearest site at every vertex.
/// 2. *Spread*: one label after another spreads from its site, to where it is not nearer than the
///    bounds, and lowers these. What a label finds does not depend on the others; they only stop
///    it. So after a change, new labels start, and those beside labels that have gone go on from where
///    they stopped.
/// 3. *Owners*: the labels that own corners of a face, or have their site in it.
/// 4. *Required distances*: each of them goes on to the corners of the face that it does not own.
/// 5. *Lists* of the labels known at each vertex.
/// 6. *Closure*: in a diagram distances are interpolated within a face. A label that is nearest
///    somewhere on an edge by that must be known in the faces on both sides, too (back to 4).
class SiteDistances final : public DistanceField {
 public:
  SiteDistances(const TriangleMesh& mesh, Metric metric, Spread spread = Spread::kAsNeeded);

  /// Begins a change of some labels, each named once. The one before must be done.
  void change(std::span<const SiteChange> changes);
  /// Works on at most `budget` units; true when the change is done.
  bool step(long budget);
  double progress() const;

  /// The faces and the labels that the last change may have altered: all others are known at the
  /// same vertices as before, with the same distances.
  const std::vector<int>& changedFaces() const { return changedFaces_.list(); }
  const std::vector<int>& changedLabels() const { return changedLabels_; }

  const SiteSet& sites() const { return sites_; }

  std::span<const LabelledDistance> at(int vertex) const override { return lists_[vertex]; }
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const override;

 private:
  /// The parts of a change, in order; the last three again while any distance is missing.
  enum class Stage {
    kBounds,
    kStart,
    kSpread,
    kFinal,
    kAffected,
    kCorners,
    kTies,
    kRequire,
    kCollect,
    kLists,
    kExtend,
    kClosure,
    kDone
  };

  void forget(int label);
  bool runStage(long& budget);
  Stage nextStage();
  template <class Work>
  bool forEach(size_t count, long& budget, Work work);

  void lowerBounds();
  bool spread(long& budget);
  bool markFinal(long& budget);
  void findAffected();
  void resetInterpolatedAround();
  bool findOwnersOfCorners(long& budget);
  bool findTies(long& budget);
  bool require(long& budget);
  void sortRequirements();
  void collectLists();
  bool listLabels(long& budget);
  void list(int label, int reachedIndex);
  void extendLists();
  bool close(long& budget);
  void requireAcross(int halfedge);
  bool ownsPartOfEdge(int label, int halfedge) const;
  bool isKnownAround(int vertex, int label) const;
  bool hasStarted(int label) const { return hasStarted_[label]; }
  std::array<double, 3> distancesAtCorners(int face, int label) const;
  bool areAllNew() const { return sites_.count() == static_cast<int>(started_.size()); }

  const TriangleMesh& mesh_;
  const bool isUnbounded_;
  SiteSet sites_;
  EdgeBounds edgeBounds_;
  NearestBounds bounds_;
  std::unique_ptr<LabelSpread> spread_;
  FaceOwners owners_;
  LabelLists lists_;

  // The change at hand.
  Stage stage_ = Stage::kDone;
  size_t cursor_ = 0;
  bool isLabelBegun_ = false;
  bool isFirstRound_ = true;  ///< of the last stages
  std::vector<int> started_, resumed_;
  std::vector<char> hasStarted_;         ///< per label
  std::vector<int> resetVertices_;       ///< those that labels which have gone owned
  IndexSet affectedFaces_;               ///< those of which the owners may have changed
  IndexSet changedVertices_;             ///< those at which the lists may have changed
  IndexSet changedFaces_;                ///< those around them
  std::vector<int> changedLabels_;
  struct Tie {
    int vertex, label;
  };
  std::vector<Tie> ties_;                ///< labels that are as near as the owner of a vertex
  std::vector<int> openFaces_;           ///< those to look at for the closure
  std::vector<int> listed_;              ///< labels of the changed vertices
  std::vector<Requirement> requirements_;  ///< by label
  std::vector<int> requiredFaces_;
};

}  // namespace gvd
