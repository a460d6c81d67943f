// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
// Jindong Chen, Yijie Han. Shortest Paths on a Polyhedron. 1990
// Chunxu Xu, Tuanfeng Wang, Yong-Jin Liu, Ligang Liu, Ying He. Fast Wavefront Propagation (FWP) for
// Computing Exact Geodesic Distances on Meshes. 2015
// Micha Sharir, Amir Schorr. On Shortest Paths in Polyhedral Spaces. 1986
// Yipeng Qin, Xiaoguang Han, Hongchuan Yu, Yizhou Yu, Jianjun Zhang. Fast and Exact Discrete
// Geodesic Computation Based on Triangle-Oriented Wavefront Propagation. 2016
#include "distance/exact/window_sweep.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/prefetch.h"
#include "distance/site_frame.h"
#include "distance/straight_line.h"
#include "mesh/surface_geometry.h"

namespace gvd::exact {
namespace {

constexpr double kPi = std::numbers::pi;

/// Buckets of the queue per short edge: wide enough for most windows of a halfedge to cross
/// in one batch, narrow enough for few to cross before the distances that trim them are known.
constexpr double kBucketsPerEdge = 1.5;

/// A label that crosses more halfedges per vertex than this winds around a spike or a tube. Over a
/// scanned surface, one label crosses 3.5 per vertex.
constexpr size_t kMostCrossingsPerVertex = 30;
/// The average number of faces that each window of such a label may be followed back across: enough
/// for spikes and tubes of a few faces. Following every window around a vertex of a thousand faces
/// would take a hundred times as long as spreading.
constexpr long kFollowedPerWindow = 16;
/// Ties at distances beyond this many bounding diagonals may be missed.
constexpr double kFarthestTie = 8;
/// The rounding error of distances in space, in bounding diagonals: a few 2^-53.
constexpr double kPlaceRounding = 0x1p-50;
/// A line followed back ends at its virtual source up to rounding: a share of the line's length.
constexpr double kLineRounding = 1e-9;

/// Whether the straight lines of a window have already crossed the face that they are about to
/// enter. Then none of them is a shortest path, since there is a shorter way within the face
/// (Sharir & Schorr 1986). All lines of a window have crossed the same faces, so it is enough to
/// follow the middle one backwards. Lowers `mayFollow` by the number of faces visited.
bool entersFaceAgain(const TriangleMesh& mesh, const Window& w, int h, long& mayFollow) {
  StraightLine line{h, (w.begin + w.end) / 2, {w.x, w.y}};
  const double atSource = kLineRounding * line.length();
  for (int crossed = 0; crossed < mesh.faceCount(); ++crossed) {
    --mayFollow;
    if (!line.enterFace(mesh) || line.length() < atSource) return false;
    if (line.halfedge / 3 == h / 3) return true;
    if (!line.crossFace(mesh)) return false;
  }
  return true;
}

}  // namespace

WindowSweep::WindowSweep(const TriangleMesh& mesh, NearestBounds& bounds)
    : mesh_(mesh),
      bounds_(bounds),
      bucketsPerUnit_(kBucketsPerEdge / mesh.shortEdgeLength()),
      leastGrazing_(0x1p-50 * longestEdge(mesh)),
      leeway_(kDistanceTolerance * kFarthestTie * mesh.boundingDiagonal()),
      fan_(mesh),
      required_(kPlaceRounding * mesh.boundingDiagonal()),
      vertices_(mesh.vertexCount()),
      windows_(mesh.halfedgeCount()) {
  for (int v = 0; v < mesh.vertexCount(); ++v) vertices_[v].isSaddle = isSaddle(mesh, v);
  if (!mesh.needles().empty()) isNeedle_.resize(mesh.faceCount(), false);
  for (const int f : mesh.needles()) isNeedle_[f] = true;
}

// --- One label ---------------------------------------------------------------------------------

void WindowSweep::begin(int label, SpreadTo to, LabelState& state) {
  label_ = label;
  to_ = to;
  state_ = &state;
  lowersBounds_ = true;
  isWinding_ = false;
  mayFollow_ = 0;
  ++epoch_;
  required_.clear();
  points_.clear();
  reached_.clear();
  crossedCount_ = 0;
  waiting_.clear();
  waitingSources_.clear();
}

void WindowSweep::start(int label, const SurfacePoint& site, SpreadTo to, LabelState& state) {
  begin(label, to, state);
  startAt(site);
}

void WindowSweep::resume(int label, LabelState& state) {
  begin(label, SpreadTo::kOwned, state);
  load();
  for (const WaitingWindow& w : std::exchange(state.waiting, {})) {
    Window window = w.window;
    add(window, portalTo(w.halfedge));
  }
  for (const int v : std::exchange(state.waitingSources, {})) queueSource(v);
}

bool WindowSweep::run(long& budget) {
  for (; bucket_ < buckets_.size(); ++bucket_, cursor_ = 0) {
    while (cursor_ < buckets_[bucket_].size()) {
      if (budget-- <= 0) return false;
      const int item = buckets_[bucket_][cursor_++];
      if (item >= 0)
        crossFace(item);
      else
        becomeSource(-1 - item);
    }
    buckets_[bucket_].clear();
  }
  bucket_ = 0;
  store();
  return true;
}

/// Loads the label's distances at vertices into the working memory.
void WindowSweep::load() {
  for (size_t i = 0; i < state_->vertices.size(); ++i) {
    const ReachedVertex& r = state_->vertices[i];
    reached_.push_back(r.vertex);
    vertices_[r.vertex] = {r.distance, state_->pieces[i],           epoch_, -1, r.isFinal,
                           false,      vertices_[r.vertex].isSaddle};
  }
}

/// Stores the label's distances, waiting windows and waiting sources in its state.
void WindowSweep::store() {
  // Allocates exactly, because a label is stored only once or twice.
  state_->vertices.reserve(reached_.size());
  state_->pieces.reserve(reached_.size());
  state_->waiting.reserve(state_->waiting.size() + waiting_.size());
  state_->vertices.resize(reached_.size());
  state_->pieces.resize(reached_.size());
  for (size_t i = 0; i < reached_.size(); ++i) {
    const Vertex& own = vertices_[reached_[i]];
    state_->vertices[i] = {reached_[i], own.isFinal || own.required >= 0, own.distance};
    state_->pieces[i] = own.piece;
  }
  state_->waiting.insert(state_->waiting.end(), waiting_.begin(), waiting_.end());
  state_->waitingSources.insert(state_->waitingSources.end(), waitingSources_.begin(),
                                waitingSources_.end());
}

// --- The site and the vertices -----------------------------------------------------------------

void WindowSweep::startAt(const SurfacePoint& site) {
  site_ = site;
  const Incidence place = incidenceOf(site.bary);
  if (place.corner >= 0) {
    offer(mesh_.face(site.face).vertices[place.corner], 0, {0, 0, 0, -1});
    return;
  }
  double angle = 0;  // of side i in the site's frame
  for (int i = 0; i < 3; ++i) {
    startAtSide(site, i, angle, i == place.side);
    if (i == place.side && mesh_.face(site.face).twins[i] >= 0) startAcross(site, i, angle + kPi);
    angle += kPi - mesh_.cornerAngle(3 * site.face + cornerAfter(i));
  }
}

/// Offers the apex of side i of the site's face its distance and, unless the site is on the side,
/// starts a window through the side. `angle` is that of the side in the site's frame.
void WindowSweep::startAtSide(const SurfacePoint& site, int i, double angle, bool isOnSide) {
  const TriangleMesh::Face& face = mesh_.face(site.face);
  const Eigen::Vector2d s = layOut(face, i, site.bary);
  const Eigen::Vector2d toApex = apexOf(face, i) - s;
  const double below = toApex.y() > 0 ? s.x() - toApex.x() * (s.y() / toApex.y()) : s.x();
  offer(face.vertices[cornerBefore(i)], wayToCorner(face, site.bary, cornerBefore(i)).norm(),
        {std::clamp(below, 0.0, face.lengths[i]), 0, angle, 3 * site.face + i});
  if (isOnSide || face.twins[i] < 0) return;
  Window window = {.begin = 0,
                   .end = face.lengths[i],
                   .x = face.lengths[i] - s.x(),
                   .y = -s.y(),
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
  Vertex& own = vertices_[v];
  if (own.epoch != epoch_) reach(v);
  if (!(rankOf({distance, piece.course}) < rankOf({own.distance, own.piece.course}))) return;
  own.distance = distance;
  own.piece = piece;
  if (to_ == SpreadTo::kSites) {
    shorten(distance + known_->atMost(v));
    return;  // the rest of the path is known
  }
  if (own.required >= 0) required_.shorten(own.required, distance);
  if (lowersBounds_) bounds_.lower(v, label_, distance);
  if (own.isSaddle || piece.arrival < 0) queueSource(v);
}

void WindowSweep::reach(int v) {
  vertices_[v] = {kInfinity, {0, 0, 0, -1}, epoch_, -1, false, false, vertices_[v].isSaddle};
  reached_.push_back(v);
}

/// The angle at which the path to a vertex leaves the site.
double WindowSweep::directionAt(int v) const {
  const LastPiece& piece = vertices_[v].piece;
  if (piece.sourceDistance > 0 || piece.arrival < 0) return piece.direction;
  const TriangleMesh::Face& face = mesh_.face(piece.arrival / 3);
  const int i = piece.arrival % 3;
  const Eigen::Vector2d apex = apexOf(face, i);
  return piece.direction + std::atan2(apex.y(), apex.x() - piece.crossing);
}

// --- The queue ---------------------------------------------------------------------------------

void WindowSweep::push(int item, double key) {
  const size_t b = std::max(bucket_, static_cast<size_t>(key * bucketsPerUnit_));
  if (b >= buckets_.size()) buckets_.resize(b + 1);
  buckets_[b].push_back(item);
}

void WindowSweep::queueSource(int v) {
  if (std::exchange(vertices_[v].isQueued, true)) return;
  push(-1 - v, vertices_[v].distance);
  prefetchFan(mesh_, v);
}

/// Queues a halfedge when its first windows arrive. If neither end has a distance, because windows
/// that graze the ends were cut off, the halfedge comes at once.
void WindowSweep::queueBatch(int halfedge, double key) {
  push(halfedge, key < kInfinity ? key : 0);
  prefetch(mesh_.face(halfedge / 3));
}

// --- Virtual sources ---------------------------------------------------------------------------

void WindowSweep::becomeSource(int v) {
  Vertex& own = vertices_[v];
  own.isQueued = false;
  if (!maySpreadFrom(v)) {
    waitingSources_.push_back(v);
    return;
  }
  const auto sides = fan_.sides(v, own.piece.arrival, own.piece.crossing);
  if (sides.empty()) return;
  const bool isSite = own.piece.arrival < 0;
  double direction =
      isSite ? angleOfOutgoing(mesh_, site_, sides.front().outgoing) : directionAt(v);
  for (const OppositeSide& side : sides) {
    emit(v, side, direction, isSite);
    if (isSite) direction += mesh_.cornerAngle(side.outgoing);  // the sides of a site go all around
  }
}

bool WindowSweep::maySpreadFrom(int v) {
  const Vertex& own = vertices_[v];
  const double nearest = bounds_[v].distance;
  if (to_ == SpreadTo::kEverywhere || own.distance <= nearest + leeway_) return true;
  if (to_ != SpreadTo::kRequired) return false;
  const std::span<const int> itself(&own.required, own.required < 0 ? 0 : 1);
  return required_.canGain(placeOf(v), 0, own.distance, own.distance - nearest, itself);
}

/// Spreads a virtual source into a face around it: offers the corners their distances and starts a
/// window through the opposite side. `direction` is the angle at which the path to the vertex
/// leaves the site or, if the site is the vertex, the angle of the outgoing halfedge.
void WindowSweep::emit(int v, const OppositeSide& side, double direction, bool isSite) {
  const double distance = vertices_[v].distance;
  const int o = side.outgoing, f = o / 3, i = o % 3;
  const int j = cornerAfter(i), k = cornerBefore(i);
  const TriangleMesh::Face& face = mesh_.face(f);
  const double length = face.lengths[j];
  if (!points_.empty()) offerToPointsFrom(v, i, f);
  if (side.from <= grazing(length))
    offer(face.vertices[j], distance + face.lengths[i],
          {face.lengths[k], distance, isSite ? direction - kPi + mesh_.cornerAngle(o) : direction,
           3 * f + k});
  if (side.to >= length - grazing(length))
    offer(face.vertices[k], distance + face.lengths[k], {0, distance, direction, o});
  if (face.twins[j] < 0) return;
  Window window = {.begin = length - side.to,
                   .end = length - side.from,
                   .x = length - face.lengths[i] * face.cosines[j],
                   .y = -face.lengths[i] * face.sines[j],
                   .sourceDistance = distance,
                   .direction = isSite ? direction - mesh_.cornerAngle(3 * f + j) : direction};
  add(window, portal(face.twins[j], length, endAt(face.vertices[k]), endAt(face.vertices[j])));
}

void WindowSweep::add(Window& w, const Portal& portal) {
  const bool isFirst = windows_.isEmpty(portal.halfedge);
  keep(w, portal);
  if (isFirst && !windows_.isEmpty(portal.halfedge))
    queueBatch(portal.halfedge, std::min({portal.own.atTail, portal.own.atTip, w.least()}));
}

// --- Crossing a face ---------------------------------------------------------------------------

void WindowSweep::crossFace(int h) {
  if (to_ == SpreadTo::kRequired && !isBatchNeeded(h)) return;
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3, j = cornerAfter(i), k = cornerBefore(i);
  const int left = face.twins[k], right = face.twins[j];
  if (left >= 0) windows_.prefetch(left);
  if (right >= 0) windows_.prefetch(right);
  WindowLists::Chunk* const list = windows_.take(h);
  isWinding_ = ++crossedCount_ > kMostCrossingsPerVertex * reached_.size();
  offerToApex(h, list);
  if (to_ == SpreadTo::kSites) offerSites(h, list);
  if (!points_.empty() && to_ != SpreadTo::kRequired)
    WindowLists::visit(list, [&](const Window& w) { offerToPoints(w, h); });
  const End tail = endAt(face.vertices[i]), tip = endAt(face.vertices[j]),
            apex = endAt(face.vertices[k]);
  if (left >= 0) crossSide<Side::kLeft>(h, list, portal(left, face.lengths[k], tail, apex));
  if (right >= 0) crossSide<Side::kRight>(h, list, portal(right, face.lengths[j], apex, tip));
  windows_.free(list);
}

void WindowSweep::offerToApex(int h, const WindowLists::Chunk* list) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  const Eigen::Vector2d p = apexOf(face, i);
  const double grazed = grazing(face.lengths[i]);
  const int apex = face.vertices[cornerBefore(i)];
  crossings_.clear();
  WindowLists::visit(list, [&](const Window& w) {
    const double crossing = w.crossing(p.x(), p.y());
    crossings_.push_back(crossing);
    if (!(crossing >= w.begin - grazed && crossing <= w.end + grazed)) return;
    const PathLength path = w.path(p.x(), p.y());
    offer(apex, path.length, {crossing, w.sourceDistance, w.direction, h, path.course});
  });
}

inline WindowSweep::End WindowSweep::endAt(int v) const {
  if (to_ == SpreadTo::kSites) return {v, distanceAt(v), mostUpTo(v)};
  return {v, distanceAt(v), bounds_[v].distance + leeway_};
}

inline WindowSweep::Portal WindowSweep::portal(int h, double length, const End& tail,
                                               const End& tip) const {
  return {h,
          length,
          {tail.own, tip.own},
          {tail.limit, tip.limit},
          (to_ == SpreadTo::kOwned || to_ == SpreadTo::kSites) &&
              (tail.limit < tail.own || tip.limit < tip.own)};
}

WindowSweep::Portal WindowSweep::portalTo(int h) const {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  return portal(h, face.lengths[i], endAt(face.vertices[i]), endAt(face.vertices[cornerAfter(i)]));
}

/// Trims a window and adds it to its halfedge. The window is dropped if the label's own paths over
/// the ends of the halfedge are shorter everywhere on it; if those of other labels are, the label
/// stops there. Inlined to keep the window in registers between two steps.
[[gnu::always_inline]] inline void WindowSweep::keep(Window& w, const Portal& portal) {
  w.y = std::min(w.y, -0x1p-52 * portal.length);
  trim(w, portal.length, portal.own);
  if (!(w.begin < w.end)) return;
  if (isWinding_ && (mayFollow_ += kFollowedPerWindow) > 0 &&
      entersFaceAgain(mesh_, w, portal.halfedge, mayFollow_))
    return;
  if (windsAroundNeedle(w, portal.halfedge)) return;
  if (portal.isContested) {
    Window owned = w;
    trim(owned, portal.length, portal.limit);
    if (!(owned.begin < owned.end)) {
      if (to_ == SpreadTo::kOwned) waiting_.push_back({w, portal.halfedge});
      return;
    }
    if (to_ == SpreadTo::kSites) w = owned;
  }
  windows_.add(portal.halfedge, w);
}

/// Whether a window is about to enter a needle that its lines have already crossed. Around a spike
/// of needles, a line ties with lines that wind around it fewer times; the number of turns would
/// depend on rounding and on when another label stops the window.
inline bool WindowSweep::windsAroundNeedle(const Window& w, int h) const {
  if (isNeedle_.empty() || !isNeedle_[h / 3]) return false;
  long unlimited = std::numeric_limits<long>::max();
  return entersFaceAgain(mesh_, w, h, unlimited);
}

/// Whether a window sees the apex but has a longer distance there than the label. Does not apply if
/// the apex is beside the window, however little: all lines then pass it on the same side.
inline bool WindowSweep::isDominated(const Window& w, double crossing, int h,
                                     double apexDistance) const {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  const double length = face.lengths[i];
  if (!(crossing >= w.begin && crossing <= w.end)) return false;
  const Eigen::Vector2d p = apexOf(face, i);
  return w.distance(p.x(), p.y()) > apexDistance + kDistanceTolerance * (apexDistance + length);
}

/// Carries the batch at a halfedge through the face's side to the left or right of the apex.
template <Side kSide>
void WindowSweep::crossSide(int h, const WindowLists::Chunk* list, const Portal& portal) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  constexpr bool kLeft = kSide == Side::kLeft;
  const int i = h % 3;
  // Of the windows of one halfedge that see the apex, only the one nearest to it has children on
  // both sides ("one angle, one split", Chen & Han 1990). If a path that turns on the halfedge is
  // the shortest one to the apex, only lines that cross its last piece are longer.
  const Vertex& apex = vertices_[face.vertices[cornerBefore(i)]];
  const bool isApexFromHere = apex.epoch == epoch_ && apex.piece.arrival == h;

  const bool isFirst = windows_.isEmpty(portal.halfedge);
  const double* nextCrossing = crossings_.data();
  WindowLists::visit(list, [&](const Window& w) {
    const double crossing = *nextCrossing++;
    if (kLeft ? !(crossing > w.begin) : !(crossing < w.end)) return;
    Window part = w;
    if (isApexFromHere && (crossing < apex.piece.crossing) != kLeft &&
        isDominated(w, crossing, h, apex.distance)) {
      if (apex.piece.course != Course::kBent) return;
      (kLeft ? part.end : part.begin) = apex.piece.crossing;
      if (!(part.begin < part.end)) return;
    }
    Window beyond = windowBeyond<kSide>(part, face, i, crossing);
    keep(beyond, portal);
  });
  if (isFirst && !windows_.isEmpty(portal.halfedge))
    queueBatch(portal.halfedge, std::min(portal.own.atTail, portal.own.atTip));
}

}  // namespace gvd::exact
