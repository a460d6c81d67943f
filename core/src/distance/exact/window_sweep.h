// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bucket_queue.h"
#include "distance/exact/fan_behind.h"
#include "distance/exact/label_state.h"
#include "distance/exact/label_vertices.h"
#include "distance/exact/required_distances.h"
#include "distance/exact/required_points.h"
#include "distance/exact/revisit_filter.h"
#include "distance/exact/site_search.h"
#include "distance/exact/window_lists.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Spreads the windows of one label after another. The working memory has room for the whole mesh,
/// but a label touches only the part that it crosses, which stays in the cache.
///
/// Windows wait in batches at their halfedge. A batch crosses its face at once: first all windows
/// offer their distances to the apex, then their children are trimmed by the label's distances at
/// the ends of the sides that they leave through. Halfedges and virtual sources are queued by
/// distance in buckets of two thirds of a short edge (Xu et al. 2015, Fast Wavefront Propagation).
/// Within a bucket they come in the order of queueing: a virtual source whose distance falls after
/// it has spread is queued again.
///
/// A window waits at its halfedge if another label is nearer on all of it. By the triangle
/// inequality that label is also nearer on every path that goes on from the window, so the waiting
/// label owns nothing beyond. The window goes on when distances beyond it are required, or when the
/// other label is removed.
///
/// The same windows, spread from a point up to vertices whose distances are known, find the nearest
/// site of the point and the path to it (`search`).
class WindowSweep {
 public:
  /// Reads `bounds`, and lowers them to the distances that labels find.
  WindowSweep(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds);
  /// Allocates the working memory, in slices; true when it is there. Before anything else.
  bool prepare(long& budget);

  /// Begins to spread a new label, while no other label is nearer.
  void start(int label, LabelState& state);
  /// Begins a new label whose windows all wait at the faces around its site.
  void startWaiting(int label, LabelState& state);
  /// Begins to spread a label on from its waiting windows, because bounds have risen.
  void resume(int label, LabelState& state);
  /// Begins to spread a label on to all corners of some faces, whose distances are at most
  /// `atMost`. Returns how many quick rounds it took.
  long require(int label, LabelState& state, std::span<const int> faces, double atMost = kInfinity);
  /// Begins to spread a new label, to find its distances at points in faces that it crosses. Does
  /// not lower bounds.
  void start(int label, LabelState& state, std::span<const RequiredPoint> points);
  /// Begins to spread a label on to some points. Does not lower bounds. If there is a single point,
  /// the windows of its faces wait there when `step` is done, for `pathToSite`.
  void require(int label, LabelState& state, std::span<const RequiredPoint> points);
  /// The distance at one of the points; valid until the next label begins.
  double distanceAtPoint(int index) const {
    return required_.distance(index + 1);  // 0 is `RequiredDistances::kNone`
  }
  /// Spreads windows from a point that is no vertex, to find the sites nearest to it. A path
  /// through a place on an edge is as long as the window's distance there plus the site's. The
  /// latter is at least the site's distance at an end of the edge minus the way from that end.
  /// Windows whose paths must be longer than a known path are cut off, so only a strip of few faces
  /// around the shortest path remains. Does not lower bounds. Returns what a label of this point
  /// has reached; the windows that see a site wait at the site's face. Lowers the budget by the
  /// units that it takes, whatever is left.
  LabelState search(const SurfacePoint& p, const SearchBounds& bounds, long& budget);
  /// The sites that the last search has found.
  const SiteSearch& searched() const { return search_; }
  /// Works for `budget` units and lowers it by their number; true when the label is done and its
  /// state is stored.
  bool step(long& budget);
  /// Forgets the last label, whose state has been changed since: it has to be loaded again.
  void forget() { label_ = -1; }
  /// The index in the label's state of a vertex that it has reached.
  int indexOf(int vertex) const { return vertices_[vertex].index; }
  /// The distance of the current label's wavefront, to the width of a bucket.
  double front() const { return queue_.front(); }

 private:
  /// How far a label spreads.
  enum class SpreadTo {
    kOwned,     ///< while no other label is nearer
    kRequired,  ///< while a required distance can still become shorter
    kSites,     ///< from a point, while the path to a site can still become shorter
  };

  using Vertex = LabelVertices::Vertex;
  using Paths = RequiredDistances::Paths;
  /// A vertex as an end of portals: the distance of the current label, and the limit up to which
  /// the label spreads on.
  struct End {
    double own, limit;
  };
  /// The straight line of a window to the apex of its face.
  struct LineToApex {
    double crossing;  ///< where it crosses the halfedge
    double length;    ///< of the path along it; -infinity at or beyond the window's ends
  };
  /// A side through which windows leave a face, as a halfedge of the face beyond.
  struct Portal {
    int halfedge;
    double length;
    EdgeDistances own, limit;
    bool isLimited;  ///< whether the label's distance exceeds the limit at an end
  };

  // window_sweep.cpp: labels, the queue, and where windows begin.
  void begin(int label, SpreadTo to, LabelState& state);
  void dropLeftovers();
  size_t beginToRequire(int label, LabelState& state);
  void store();
  void startAt(const SurfacePoint& site);
  void startAtSide(const SurfacePoint& site, int i, double angle, bool isOnSide);
  void startAcross(const SurfacePoint& site, int side, double angle);
  void offer(int vertex, double distance, const LastPiece& piece);
  double directionAt(int vertex) const;
  void queueSource(int vertex);
  void queueBatch(int halfedge, double key);
  void prefetchTurn(int item) const;
  void becomeSource(int vertex);
  bool maySpreadFrom(int vertex);
  void emit(int vertex, const OppositeSide& side, double direction);

  // window_sweep_crossing.cpp: windows that arrive at a halfedge and cross its face.
  /// Returns the number of windows of the batch.
  long crossFace(int halfedge);
  void offerToApex(int halfedge, std::span<const Window> windows);
  template <Side kSide>
  void crossSide(int halfedge, std::span<const Window> windows, const Portal& portal);
  End endAt(int vertex) const;
  Portal portal(int halfedge, double length, const End& tail, const End& tip) const;
  Portal portalTo(int halfedge) const;
  bool trimAtPortal(Window& w, const Portal& portal);
  void add(Window& w, const Portal& portal);

  // window_sweep_requirements.cpp: required distances, and the windows that go on because of them.
  void requireCorners(int face, double atMost);
  bool hasRequiredCorner(int face) const;
  void offerAlongSides(int face);
  void offerToCorners(const Window& w, int halfedge);
  template <class Visit>
  void visitAwake(Visit visit) const;
  template <class AnyWindow>
  std::optional<Paths> pathsThrough(int halfedge, std::span<const AnyWindow> windows,
                                    double mostExcess) const;
  bool canGain(int halfedge, const std::optional<Paths>& paths) const;
  void continueNeeded();
  bool offerAndGoOn(int halfedge);

  // window_sweep_search.cpp: sites near a point.
  void offerSites(int halfedge, std::span<const Window> windows);

  /// How far past the end of a window on a halfedge of some length a vertex may be seen
  /// (`kGrazing`).
  double grazing(double length) const { return std::max(kGrazing * length, leastGrazing_); }

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  NearestBounds& bounds_;
  const double leastGrazing_;  ///< by which lines round that have crossed the longest edge
  /// A label spreads on while it is farther than another one by at most this. Two labels that tie
  /// at a distance d may differ here by `kDistanceTolerance` · d, because the difference does not
  /// fall along a path. Neither may stop the other here, or the set of labels that tie at d would
  /// depend on which of them spread first.
  const double tieMargin_;
  FanBehind fan_;
  RevisitFilter revisits_;

  // The current label.
  int label_ = -1;
  SpreadTo to_ = SpreadTo::kOwned;
  bool isUnderWay_ = false;  ///< until its state is stored
  LabelState* state_ = nullptr;
  RequiredDistances required_;
  RequiredPoints points_;
  SiteSearch search_;  ///< if the label is a point that searches

  // Working memory.
  LabelVertices vertices_;
  WindowLists windows_;
  Waiting waiting_;                 ///< where the label has stopped
  std::vector<LineToApex> toApex_;  ///< of each window of the current batch
  std::vector<Window> children_;    ///< of the current batch, through one side
  BucketQueue queue_;               ///< halfedges, and vertices v as -1 - v
};

}  // namespace gvd::exact
