// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "distance/exact/fan_behind.h"
#include "distance/exact/label_state.h"
#include "distance/exact/required_places.h"
#include "distance/exact/window_lists.h"
#include "distance/face_layout.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// A point, no vertex, at which the distance of a label is required.
struct RequiredPoint {
  SurfacePoint point;
  double distance;  ///< of the label, as far as it is known
  double nearest;   ///< that of the nearest label
};

/// How far a label spreads.
enum class SpreadTo {
  kOwned,       ///< as far as no other label is nearer
  kRequired,    ///< as far as a required distance can still become less
  kSites,       ///< from a point back, as far as the path to a site can still become shorter
  kEverywhere,  ///< over the whole component
};

/// What is known of the labels to which the shortest path from a point may lead.
class KnownDistances {
 public:
  virtual ~KnownDistances() = default;
  /// None of the labels is nearer to the vertex than this.
  virtual double atLeast(int vertex) const = 0;
  /// The length of a path of one of the labels to the vertex, infinity if none is known.
  virtual double atMost(int vertex) const = 0;
  /// Whether the label is one of them.
  virtual bool isAbout(int label) const = 0;
};

/// Spreads the windows of one label after another. The working memory has room for the whole mesh,
/// but a label touches what it passes only, so that it stays in the cache.
///
/// Windows wait in batches at their halfedge. A batch crosses its face at once: first all windows
/// offer their distances to the apex, then their children are trimmed by the label's distances at
/// the ends of the sides that they leave through. Halfedges and virtual sources are queued by
/// distance in buckets of half a mean edge (Xu et al. 2015, Fast Wavefront Propagation); what comes
/// in the wrong order is corrected.
///
/// A window on all of which another label is nearer is kept waiting. A label that is farther than
/// another one at some point of a path is farther along all the rest of the path, so the label owns
/// nothing beyond such a window. It goes on from there when its distances beyond are required, or
/// when the other label has left.
///
/// The same windows, spread from a point up to vertices whose distances are known, find the nearest
/// site of the point and the path to it (`search`).
class WindowSweep {
 public:
  /// `bounds` are read, and lowered by what the labels find.
  WindowSweep(const TriangleMesh& mesh, NearestBounds& bounds);

  /// Begins with a label that has not spread yet.
  void start(int label, const SurfacePoint& site, SpreadTo to, LabelState& state);
  /// Begins with a label that is to go on where bounds have risen.
  void resume(int label, LabelState& state);
  /// Begins with a label that is to reach all corners of some faces.
  void require(int label, LabelState& state, std::span<const int> faces);
  /// Begins with a label that has not spread yet, to find its distances at points on the way.
  /// Bounds remain as they are.
  void start(int label, const SurfacePoint& site, SpreadTo to, LabelState& state,
             std::span<const RequiredPoint> points);
  /// Begins with a label that is to go on to some points. Bounds remain as they are. Of a single
  /// point, the windows at its faces wait there in the end.
  void require(int label, LabelState& state, std::span<const RequiredPoint> points);
  /// The distance at one of these points; for use before the next label begins.
  double distanceAtPoint(int index) const { return pointDistances_[index]; }
  /// Begins with a point, which lies on no vertex, instead of a site, to find the way back to the
  /// sites that it is nearest to. Through any place of an edge, the path is as long as a window's
  /// distance there and that of the site, which is not less than its distance at an end of the edge
  /// less the way from there. What is longer than a path that is known is cut off, and a strip of
  /// few faces around the shortest path remains. Bounds remain as they are. Done when it returns;
  /// then windows through which there are sites wait at the faces of these.
  void search(const SurfacePoint& p, const KnownDistances& known, const SiteSet& sites,
              LabelState& state);
  /// The length of the shortest path that the search has found, infinity if there is none.
  double shortest() const { return shortest_; }
  /// The sites in faces, with their distances from the point, that the search has come to.
  std::span<const LabelledDistance> foundSites() const { return foundSites_; }
  /// Works on at most `budget` batches and lowers it by their number; true when the label is done,
  /// and what it has come to is in its state.
  bool run(long& budget);
  /// The distance that the wavefront of the label at hand has come to, up to a bucket of the queue.
  double front() const { return static_cast<double>(bucket_) / bucketsPerUnit_; }

 private:
  /// What the label at hand knows at a vertex.
  struct alignas(64) Vertex {
    double distance;
    LastPiece piece;
    int epoch = 0;  ///< of the label that this is about
    int required;   ///< index in `required_`, -1
    bool isFinal, isQueued;
    bool isSaddle;  ///< of the mesh, whatever the label
  };
  /// A required point in a face. Points on an edge are in the faces on both sides.
  struct PointInFace {
    int face;
    Eigen::Vector3d bary;
    int index;  ///< in `pointDistances_` and `required_`
  };
  /// A vertex as an end of portals: the distance of the label at hand, and up to which it goes on.
  struct End {
    int vertex;
    double own, nearest;
  };
  /// A side that windows leave a face through, as a halfedge of the face beyond.
  struct Portal {
    int halfedge;
    double length;
    EdgeDistances own, nearest;
    bool isContested;  ///< whether another label is nearer at an end
  };

  void begin(int label, SpreadTo to, LabelState& state);
  void load();
  void store();

  void startAt(const SurfacePoint& site);
  void startAtSide(const SurfacePoint& site, int i, double angle, bool isOnSide);
  void startAcross(const SurfacePoint& site, int side, double angle);
  void offer(int vertex, double distance, const LastPiece& piece);
  void reach(int vertex);
  double directionAt(int vertex) const;

  void push(int item, double key);
  void queueSource(int vertex);
  void queueBatch(int halfedge, double key);

  void becomeSource(int vertex);
  bool maySpreadFrom(int vertex);
  void emit(int vertex, const OppositeSide& side, double direction, bool isSite);
  void add(Window& w, const Portal& portal);

  void crossFace(int halfedge);
  void offerToApex(int halfedge, const WindowLists::Chunk* list);
  template <Side kSide>
  void crossSide(int halfedge, const WindowLists::Chunk* list, const Portal& portal);
  End endAt(int vertex) const;
  Portal portal(int halfedge, double length, const End& tail, const End& tip) const;
  Portal portalTo(int halfedge) const;
  bool isBeaten(const Window& w, double crossing, int halfedge, double apexDistance) const;
  void keep(Window& w, const Portal& portal);
  bool windsAroundNeedle(const Window& w, int halfedge) const;

  /// A place in space, as seen from a vertex of the mesh: those of a mesh far from the origin would
  /// be rounded by more than the mesh is large.
  Eigen::Vector3d placeOf(int vertex) const { return mesh_.position(vertex) - mesh_.position(0); }
  void requireCorners(int face);
  void addPoints(std::span<const RequiredPoint> points);
  void addPoint(const SurfacePoint& point, int index);
  std::span<const PointInFace> pointsIn(int face) const;
  void offerToPoint(int index, double distance);
  void offerToPoints(const Window& w, int halfedge);
  void offerToPointsFrom(int vertex, int corner, int face);
  double mostUpTo(int vertex) const;
  void shorten(double length);
  bool isSearchedFor(const FaceSite& site) const;
  void offerSites(int halfedge, const WindowLists::Chunk* list);

  bool isRequired(int vertex) const;
  bool hasRequiredCorner(int face) const;
  void offerRequired(int vertex, double distance, const LastPiece& piece);
  void offerAlongSides(int face);
  void offerToCorners(const Window& w, int halfedge);
  template <class Visit>
  void visitWaiting(Visit visit) const;
  template <class Windows>
  bool canGain(int halfedge, const Windows& windows);
  void continueNeeded();
  bool isBatchNeeded(int halfedge);

  double distanceAt(int v) const {
    return vertices_[v].epoch == epoch_ ? vertices_[v].distance : kInfinity;
  }

  const TriangleMesh& mesh_;
  NearestBounds& bounds_;
  const double bucketsPerUnit_;
  /// By how much a label may be farther than another one and still go on. Along a path, the
  /// difference of two labels' distances does not fall, but the distances grow, and ties are told
  /// by a relative tolerance: what is a difference here may be a tie farther on. Labels that will
  /// tie there have to come there, whichever of them spreads first.
  const double leeway_;
  FanBehind fan_;
  std::vector<char> isNeedle_;  ///< per face; empty if none is

  // The label at hand.
  int label_ = -1;
  SpreadTo to_ = SpreadTo::kOwned;
  LabelState* state_ = nullptr;
  bool lowersBounds_ = true;
  bool isWinding_ = false;  ///< whether windows are dropped that enter a face again
  long mayFollow_ = 0;      ///< how many more faces windows may be followed back across to tell
  SurfacePoint site_;
  RequiredPlaces required_;
  double mostExcess_ = 0;            ///< of them, when the label began to go on
  std::vector<PointInFace> points_;  ///< by face
  std::vector<double> pointDistances_;
  std::vector<int> inFace_;  ///< those of `required_` in the face at hand

  // The search at hand.
  const KnownDistances* known_ = nullptr;
  const SiteSet* sites_ = nullptr;
  double shortest_ = kInfinity;
  std::vector<LabelledDistance> foundSites_;

  // Working memory, of which a label leaves nothing behind but vertices of an old epoch.
  int epoch_ = 0;
  std::vector<Vertex> vertices_;
  WindowLists windows_;
  std::vector<int> reached_;
  size_t crossedCount_ = 0;             ///< of faces, each as often as it was crossed
  std::vector<WaitingWindow> waiting_;  ///< where the label has stopped
  std::vector<int> waitingSources_;
  std::vector<double> crossings_;          ///< of the batch at hand, with the line to the apex
  std::vector<std::vector<int>> buckets_;  ///< halfedges, and vertices v as -1 - v
  size_t bucket_ = 0, cursor_ = 0;
};

}  // namespace gvd::exact
