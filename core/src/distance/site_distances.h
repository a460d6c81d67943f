// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/index_set.h"
#include "distance/edge_bounds.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "distance/small_lists.h"
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
/// 3. *Owners*: the labels that own any point of a closed face.
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
  std::vector<double> times = std::vector<double>(8);

  std::span<const LabelledDistance> at(int vertex) const override { return lists_[vertex]; }
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;

 private:
  enum class Stage { kBounds, kSpread, kOwners, kRequire, kLists, kClosure, kDone };
  /// A label that owns part of a face, or is known at its corners to close the interpolation.
  struct FaceLabel {
    int label;
    bool isByClosure;
  };
  struct Requirement {
    int label, face;
  };

  void forget(int label);
  void findBounds();
  bool spread(long& budget);
  void findOwners();
  bool require(long& budget);
  void listLabels();
  bool close();

  bool isOwnerOfAll(int face, int label) const;
  void addOwner(int face, int label);
  bool has(int face, int label) const;
  bool ownsPartOfEdge(int label, int halfedge) const;

  const TriangleMesh& mesh_;
  const bool isUnbounded_;
  SiteSet sites_;
  EdgeBounds edgeBounds_;
  NearestBounds bounds_;
  std::unique_ptr<LabelSpread> spread_;
  SmallLists<FaceLabel> faceLabels_;  ///< empty: the owner of the corners owns all of the face
  SmallLists<LabelledDistance> lists_;
  SmallLists<int> records_;  ///< indices in LabelSpread::reached, as lists_

  // The change at hand.
  Stage stage_ = Stage::kDone;
  std::vector<int> started_, resumed_;
  size_t cursor_ = 0;
  bool isRunning_ = false;
  std::vector<int> resetVertices_;
  IndexSet affectedFaces_, affectedVertices_, changedFaces_;
  std::vector<int> changedLabels_;
  std::vector<Requirement> requirements_;
};

}  // namespace gvd
