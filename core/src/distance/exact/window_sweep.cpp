// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
// Chunxu Xu, Tuanfeng Wang, Yong-Jin Liu, Ligang Liu, Ying He. Fast Wavefront Propagation (FWP) for
// Computing Exact Geodesic Distances on Meshes. 2015
#include "distance/exact/window_sweep.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/prefetch.h"
#include "base/sliced_loop.h"
#include "distance/site_frame.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"
#include "mesh/prefetch_around.h"

namespace gvd::exact {
namespace {

constexpr double kPi = std::numbers::pi;

/// Buckets of the queue per short edge: wide enough for most windows of a halfedge to cross
/// in one batch, narrow enough for few to cross before the distances that trim them are known.
constexpr double kBucketsPerEdge = 1.5;

/// How much a line may round that has crossed the longest edge, as a share of the edge: eight times
/// 2^-53.
constexpr double kRoundingOfLines = 0x1p-50;

/// Ties at distances beyond this many bounding diagonals may be missed.
constexpr double kFarthestTie = 8;

}  // namespace

WindowSweep::WindowSweep(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      leastGrazing_(kRoundingOfLines * mesh.longestEdge()),
      tieMargin_(kDistanceTolerance * kFarthestTie * mesh.boundingDiagonal()),
      fan_(mesh, leastGrazing_),
      revisits_(mesh),
      required_(mesh),
      points_(mesh, required_),
      search_(bounds.ties(), sites),
      vertices_(mesh),
      queue_(kBucketsPerEdge / mesh.shortEdgeLength()) {}

bool WindowSweep::prepare(long& budget) {
  return vertices_.prepare(budget) && windows_.addLists(mesh_.halfedgeCount(), budget);
}

// --- One label ---------------------------------------------------------------------------------

void WindowSweep::begin(int label, SpreadTo to, LabelState& state) {
  if (std::exchange(isUnderWay_, true)) dropLeftovers();
  label_ = label;
  to_ = to;
  state_ = &state;
  revisits_.begin(to == SpreadTo::kSites);
  vertices_.clear();
  required_.clear();
  points_.clear();
  waiting_.clear();
}

/// Drops what an exception has left in the working memory, as when memory runs out in a query: the
/// next label would spread the windows of the last one.
void WindowSweep::dropLeftovers() {
  for (int h = 0; h < mesh_.halfedgeCount(); ++h) windows_.free(windows_.take(h));
  while (queue_.advance()) queue_.take();
}

void WindowSweep::start(int label, LabelState& state) {
  begin(label, SpreadTo::kOwned, state);
  startAt(sites_[label]);
}

/// As long as nothing is required, no window of a label that spreads to required distances goes on.
void WindowSweep::startWaiting(int label, LabelState& state) {
  begin(label, SpreadTo::kRequired, state);
  startAt(sites_[label]);
}

void WindowSweep::resume(int label, LabelState& state) {
  begin(label, SpreadTo::kOwned, state);
  vertices_.load(state);
  const Waiting waiting = std::exchange(state.waiting, {});
  for (WaitingWindow w : waiting.windows) add(w.window, portalTo(w.halfedge));
  for (const int v : waiting.sources) queueSource(v);
}

bool WindowSweep::step(long& budget) {
  while (queue_.advance()) {
    if (budget <= 0) return false;
    for (const int next : queue_.toPrefetch()) prefetchTurn(next);
    const int item = queue_.take();
    long crossed = 0;
    if (item >= 0)
      crossed = crossFace(item);
    else
      becomeSource(-1 - item);
    budget -= 1 + (crossed + revisits_.takeCrossedBack()) / kQuickRounds;
  }
  store();
  return true;
}

/// Begins to spread a label on to required places. If distances of the same label were required at
/// vertices last, all of it is still in the working memory, and windows may sleep on: had bounds
/// risen where they wait, the label would have been resumed since. Returns how many vertices it has
/// loaded.
size_t WindowSweep::beginToRequire(int label, LabelState& state) {
  const bool isLoaded = to_ == SpreadTo::kRequired && label_ == label && state_ == &state &&
                        points_.isEmpty() && !isUnderWay_;
  if (isLoaded) {
    required_.beginNext();
    waiting_.clear();
  } else {
    begin(label, SpreadTo::kRequired, state);
    vertices_.load(state);
    state.waiting.asleep = 0;
  }
  isUnderWay_ = true;
  return isLoaded ? 0 : vertices_.count();
}

/// Stores in the label's state its distances and where it waits.
void WindowSweep::store() {
  vertices_.store(*state_);
  state_->waiting.append(waiting_);
  isUnderWay_ = false;
}

// --- The site and the vertices -----------------------------------------------------------------

void WindowSweep::startAt(const SurfacePoint& site) {
  const Incidence incidence = incidenceOf(site.bary);
  if (incidence.corner >= 0) {
    offer(mesh_.face(site.face).vertices[incidence.corner], 0, {});
    return;
  }
  double angle = 0;  // of side i in the site's frame
  for (int i = 0; i < 3; ++i) {
    startAtSide(site, i, angle, i == incidence.side);
    if (i == incidence.side && mesh_.face(site.face).twins[i] >= 0)
      startAcross(site, i, angle + kPi);
    angle += kPi - mesh_.cornerAngle(3 * site.face + cornerAfter(i));
  }
}

/// Offers the apex of side i of the site's face its distance and, unless the site is on the side,
/// starts a window through the side. `angle` is that of the side in the site's frame.
void WindowSweep::startAtSide(const SurfacePoint& site, int i, double angle, bool isOnSide) {
  const TriangleMesh::Face& face = mesh_.face(site.face);
  const auto to = [&](int corner) { return wayToCorner(face, i, site.bary, corner); };
  const Eigen::Vector2d toTail = to(i), toTip = to(cornerAfter(i)), toApex = to(cornerBefore(i));
  const Eigen::Vector2d apex = apexOf(face, i);
  const double fromFoot = toApex.y() > 0 ? -toApex.x() * (apex.y() / toApex.y()) : -toApex.x();
  offer(face.vertices[cornerBefore(i)], distanceToCorner(face, site.bary, cornerBefore(i)),
        {std::clamp(fromFoot, -apex.x(), face.lengths[i] - apex.x()), 0, angle, 3 * site.face + i});
  if (isOnSide || face.twins[i] < 0) return;
  Window window = {.begin = 0,
                   .end = face.lengths[i],
                   .x = toTip.x(),
                   .y = toTip.y(),
                   .fromTip = -toTail.x(),
                   .sourceDistance = 0,
                   .direction = angle + kPi};
  add(window, portal(face.twins[i], face.lengths[i], endAt(face.vertices[cornerAfter(i)]),
                     endAt(face.vertices[i])));
}

/// Starts a site on a side in the face beyond the side. `angle` is that of the twin.
void WindowSweep::startAcross(const SurfacePoint& site, int side, double angle) {
  const SurfacePoint across = acrossEdge(mesh_, site, 3 * site.face + side);
  int i = mesh_.face(site.face).twins[side] % 3;
  for (int turn = 0; turn < 3; ++turn, i = cornerAfter(i)) {
    startAtSide(across, i, angle, turn == 0);
    angle += kPi - mesh_.cornerAngle(3 * across.face + cornerAfter(i));
  }
}

void WindowSweep::offer(int v, double distance, const LastPiece& piece) {
  Vertex& own = vertices_.touched(v);
  if (!(rankOf({distance, piece.kind}) < rankOf({own.distance, own.piece.kind}))) return;
  own.distance = distance;
  own.piece = piece;
  if (to_ == SpreadTo::kSites) {
    search_.offerVertex(v, distance);
    return;  // the rest of the path is known
  }
  if (own.isRequired()) required_.lower(own.required, distance);
  if (points_.isEmpty()) bounds_.lower(v, label_, distance);
  if (own.isSaddle || piece.isAtSite()) queueSource(v);
}

/// The angle at which the path to a vertex leaves the site.
double WindowSweep::directionAt(int v) const {
  const LastPiece& piece = vertices_[v].piece;
  if (!piece.isFromSite() || piece.isAtSite()) return piece.direction;
  const TriangleMesh::Face& face = mesh_.face(piece.arrival / 3);
  const int i = piece.arrival % 3;
  return piece.direction + std::atan2(apexOf(face, i).y(), -piece.fromFoot);
}

// --- The queue ---------------------------------------------------------------------------------

void WindowSweep::queueSource(int v) {
  if (std::exchange(vertices_[v].isQueued, true)) return;
  queue_.add(-1 - v, queue_.bucketOf(vertices_[v].distance));
  prefetch(mesh_.fan(v).front());
}

/// Queues a halfedge when its first windows arrive. If neither end has a distance, because windows
/// that graze the ends were cut off, the halfedge comes at once.
void WindowSweep::queueBatch(int halfedge, double key) {
  queue_.add(halfedge, queue_.bucketOf(key < kInfinity ? key : 0));
  prefetch(mesh_.face(halfedge / 3));
}

/// Fetches into the cache what a turn begins with; its face or fan was fetched when it was queued.
void WindowSweep::prefetchTurn(int item) const {
  if (item < 0) return prefetchFacesAround(mesh_, -1 - item);
  const TriangleMesh::Face& face = mesh_.face(item / 3);
  const int i = item % 3;
  prefetchInBatch(face);
  prefetchInBatch(vertices_[face.vertices[cornerBefore(i)]]);
  for (const int side : {cornerBefore(i), cornerAfter(i)})
    if (face.twins[side] >= 0) windows_.prefetch(face.twins[side]);
}

// --- Virtual sources ---------------------------------------------------------------------------

void WindowSweep::becomeSource(int v) {
  Vertex& own = vertices_[v];
  own.isQueued = false;
  const auto sidesSeen = [&] { return fan_.sides(v, own.piece.arrival, own.piece.fromFoot); };
  if (!maySpreadFrom(v)) {
    // A boundary may have thousands of vertices that see no side. If they waited, each distance
    // that is required would take a look at all of them. Inner vertices see some side.
    if (!mesh_.onBoundary(v) || !sidesSeen().empty()) waiting_.sources.push_back(v);
    return;
  }
  const auto sides = sidesSeen();
  if (sides.empty()) return;
  const bool isSite = own.piece.isAtSite();
  double direction =
      isSite ? angleOfOutgoing(mesh_, sites_[label_], sides.front().outgoing) : directionAt(v);
  for (const OppositeSide& side : sides) {
    emit(v, side, direction);
    if (isSite) direction += mesh_.cornerAngle(side.outgoing);  // the sides of a site go all around
  }
}

bool WindowSweep::maySpreadFrom(int v) {
  const Vertex& own = vertices_[v];
  const double nearest = bounds_[v].distance;
  if (own.distance <= nearest + tieMargin_) return true;
  if (to_ != SpreadTo::kRequired || own.distance - nearest >= required_.mostExcess()) return false;
  return required_.canGain(
      required_.paths(required_.placeOf(v), 0, own.distance, own.distance - nearest),
      [&](auto ignore) { ignore(own.required); });
}

/// Spreads a virtual source into a face around it: offers the corners their distances and starts a
/// window through the opposite side. `direction` is the angle at which the path to the vertex
/// leaves the site or, if the site is the vertex, the angle of the outgoing halfedge.
void WindowSweep::emit(int v, const OppositeSide& side, double direction) {
  const double distance = vertices_[v].distance;
  const bool isSite = vertices_[v].piece.isAtSite();
  const int o = side.outgoing, f = o / 3, i = o % 3;
  const int j = cornerAfter(i), k = cornerBefore(i);
  const TriangleMesh::Face& face = mesh_.face(f);
  const double length = face.lengths[j];
  if (!points_.isEmpty()) points_.offerFrom(i, f, distance);
  if (side.from <= grazing(length))
    offer(face.vertices[j], distance + face.lengths[i],
          {face.lengths[i] * face.cosines[i], distance,
           isSite ? direction - kPi + mesh_.cornerAngle(o) : direction, 3 * f + k});
  if (side.to >= length - grazing(length))
    offer(face.vertices[k], distance + face.lengths[k],
          {-face.lengths[k] * face.cosines[i], distance, direction, o});
  if (face.twins[j] < 0) return;
  Window window = {.begin = length - side.to,
                   .end = length - side.from,
                   .x = face.lengths[k] * face.cosines[k],
                   .y = -face.lengths[i] * face.sines[j],
                   .fromTip = face.lengths[i] * face.cosines[j],
                   .sourceDistance = distance,
                   .direction = isSite ? direction - mesh_.cornerAngle(3 * f + j) : direction};
  add(window, portal(face.twins[j], length, endAt(face.vertices[k]), endAt(face.vertices[j])));
}

}  // namespace gvd::exact
