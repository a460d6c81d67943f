// SPDX-License-Identifier: MIT
#include "dgpc/path_straightening.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/plane.h"
#include "base/tolerances.h"
#include "dgpc/straight_walk.h"
#include "distance/site_frame.h"
#include "mesh/surface_geometry.h"
#include "mesh/unfolding.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr int kAtSite = -1;

/// Places in one frame that are nearer to each other than this, as a share of an edge there, are
/// the same vertex: rounding along a path stays far below, and edges are longer.
constexpr double kSamePlace = 1e-6;

/// So many halfedges may be kept, of all ways together. They can be found again.
constexpr size_t kMostKept = 1 << 22;

}  // namespace

std::optional<LocalGeodesic> PathStraightener::straighten(int label, int vertex, const View& view) {
  if (label != label_ || crossed_.size() > kMostKept) forget();
  label_ = label;
  int way = kNone;
  if (field_.nearest(vertex).label == label) {
    way = wayFrom(vertex);
  } else {
    way = findAhead(vertex, view);
    if (!isNoLonger(way, view)) way = findNear(vertex, view, way);
  }
  return way == kNone ? std::nullopt : std::optional(ways_[way].path);
}

void PathStraightener::forget() {
  for (const int v : found_) wayOf_[v] = kNotFound;
  found_.clear();
  ways_.clear();
  crossed_.clear();
}

/// First finds those of the neighbours that it follows, the last one first: there may be many.
int PathStraightener::wayFrom(int vertex) {
  const auto note = [&](int at, int way) {
    wayOf_[at] = way;
    found_.push_back(at);
  };
  std::vector<std::pair<int, int>> waiting;  // with what has been found ahead
  for (int at = vertex; wayOf_[at] == kNotFound;) {
    const View& view = field_.view(at);
    const int ahead = findAhead(at, view);
    if (isNoLonger(ahead, view)) {
      note(at, ahead);
      break;
    }
    waiting.emplace_back(at, ahead);
    const int edge = stepToOwner(at);
    if (edge < 0) break;
    at = otherEnd(edge, at);
  }
  for (; !waiting.empty(); waiting.pop_back()) {
    const auto [at, ahead] = waiting.back();
    note(at, findNear(at, field_.view(at), ahead));
  }
  return wayOf_[vertex];
}

int PathStraightener::keepStraight(int vertex, const LocalGeodesic& path, int face,
                                   const Vector2d& line) {
  ways_.push_back({path, vertex, 0, face, 0, 0, kNone, line});
  return static_cast<int>(ways_.size()) - 1;
}

/// Keeps the path of the strip, of which the end is where another way begins, or the site.
int PathStraightener::keepPieces(const LocalGeodesic& path, int next) {
  const auto& pieces = strip_.pieces();
  LocalGeodesic rest = next == kNone ? LocalGeodesic{0, path.departure} : ways_[next].path;
  for (size_t i = pieces.size(); i-- > 0;) {
    const FaceStrip::Piece& piece = pieces[i];
    const size_t begin = crossed_.size();
    crossed_.insert(crossed_.end(), piece.crossed.begin(), piece.crossed.end());
    rest.length += piece.length;
    rest.bends = next != kNone;
    ways_.push_back({rest, piece.vertex, piece.angle, piece.firstFace, begin, crossed_.size(), next,
                     Vector2d(0, 0)});
    next = static_cast<int>(ways_.size()) - 1;
  }
  return next;
}

/// A way that is longer than the path of a view leads around something else, or the view shows what
/// is not so.
bool PathStraightener::isNoLonger(int way, const View& view) const {
  return way != kNone && ways_[way].path.length <= view.distance(mesh_) * (1 + kDistanceTolerance);
}

/// Whether a site is in the face of a halfedge, or on a corner of it.
bool PathStraightener::isInFace(const SurfacePoint& site, int halfedge) const {
  const int vertex = vertexAt(mesh_, site), face = TriangleMesh::faceOf(halfedge);
  if (vertex < 0) return face == site.face;
  return mesh_.tail(3 * face) == vertex || mesh_.tail(3 * face + 1) == vertex ||
         mesh_.tail(3 * face + 2) == vertex;
}

/// Whether a walk has come to a site: to its face, or, if it is a vertex, to that.
auto PathStraightener::isAt(const SurfacePoint& site) const {
  return [&mesh = mesh_, vertex = vertexAt(mesh_, site), face = site.face](int entry,
                                                                           const Vector2d&) {
    return vertex >= 0 ? mesh.tail(TriangleMesh::previous(entry)) == vertex
                       : TriangleMesh::faceOf(entry) == face;
  };
}

/// Looks straight ahead: to the site that a view shows, or, if it bends, would show if it did not.
int PathStraightener::findAhead(int vertex, const View& view) {
  if (view.halfedge < 0 || !std::isfinite(view.detour)) return kNone;
  const Vector2d path = view.path(mesh_);
  if (!view.isBent() && isInFace(goal(), view.halfedge)) {
    return keepStraight(vertex, {path.norm(), view.departure(mesh_, path.norm())},
                        TriangleMesh::faceOf(view.halfedge), {0, 0});
  }
  return aim(vertex, view.halfedge, view.isBent() ? Vector2d(view.toSite - path) : Vector2d(-path));
}

/// What follows from a neighbour's way, or from a view; what has been found ahead if that is
/// shorter.
int PathStraightener::findNear(int vertex, const View& view, int ahead) {
  int near = followNeighbour(vertex);
  if (near == kNone) near = followView(vertex, view);
  if (ahead == kNone || near == kNone) return std::max(ahead, near);
  return ways_[near].path.length < ways_[ahead].path.length ? near : ahead;
}

/// A straight line to the site from the apex of a halfedge: where the given one, in the halfedge's
/// frame, leads beside the site, it is drawn anew to where the site is seen from there.
int PathStraightener::aim(int vertex, int halfedge, Vector2d line) {
  constexpr int kMostAims = 4;
  const SurfacePoint& site = goal();
  const int siteVertex = vertexAt(mesh_, site), face = TriangleMesh::faceOf(halfedge);
  if (face == site.face) return kNone;
  for (int i = 0; i < kMostAims; ++i) {
    const auto end = walkStraight(mesh_, halfedge, line, AtVertex::kStop, isAt(site));
    if (!end) return kNone;
    const int k = end->entry % 3;
    line = siteVertex >= 0
               ? end->apex
               : Vector2d(site.bary[k] * end->left + site.bary[(k + 1) % 3] * end->right +
                          site.bary[(k + 2) % 3] * end->apex);
    if (isGrazing(end->leftBound, line) || isGrazing(end->rightBound, line)) return kNone;
    if (!end->isInSight(line)) continue;
    const Vector2d along = (end->right - end->left) / mesh_.length(end->entry);
    const Vector2d departure = inSiteFrame(mesh_, site, end->entry, turnedBackBy(-line, along));
    return keepStraight(vertex, {line.norm(), departure}, face, line);
  }
  return kNone;
}

/// Over an edge to a neighbour of the label's own, and on as that one's way does.
int PathStraightener::followNeighbour(int vertex) {
  const int edge = stepToOwner(vertex);
  if (edge < 0) return kNone;
  const int neighbour = otherEnd(edge, vertex), face = TriangleMesh::faceOf(edge);
  if (neighbour == vertexAt(mesh_, goal())) {
    strip_.start(face);
    return pullTight(vertex, kNone);
  }
  const int along = wayFrom(neighbour);
  strip_.start(face);
  return along != kNone && goAlong(along) ? pullTight(vertex, along) : kNone;
}

/// The same as far as a view shows the way, and on from where its path bends last.
int PathStraightener::followView(int vertex, const View& view) {
  const auto source = lookBack(view, goal());
  if (!source) return kNone;
  const std::vector<int> walkedThrough = walkedThrough_;
  const int face = TriangleMesh::faceOf(view.halfedge);
  if (!view.isBent()) {
    strip_.start(face, walkedThrough);
    return pullTight(vertex, kNone);
  }
  const LabelledDistance &here = field_.nearest(vertex), &there = field_.nearest(*source);
  if (there.label != label_ || (here.label == label_ && !(there.distance < here.distance)))
    return kNone;
  const int along = wayFrom(*source);
  strip_.start(face, walkedThrough);
  return along != kNone && goAlong(along) ? pullTight(vertex, along) : kNone;
}

/// Leads the strip on along the piece that a way begins with, from the vertex where it begins, of
/// which the last face has a corner.
bool PathStraightener::goAlong(int way) {
  const Way& w = ways_[way];
  if (!strip_.turn(w.vertex, w.firstFace)) return false;
  for (size_t i = w.begin; i < w.end; ++i) strip_.goThrough(crossed_[i]);
  if (w.line == Vector2d(0, 0)) return true;
  int halfedge = 3 * w.firstFace;
  while (mesh_.tail(TriangleMesh::previous(halfedge)) != w.vertex) ++halfedge;
  return walkStraight(
             mesh_, halfedge, w.line, AtVertex::kPass,
             [&](int through) { strip_.goThrough(through); }, isAt(goal()))
      .has_value();
}

/// Keeps the geodesic that follows from the strip, and from the way whose first piece it ends with.
/// What comes after that piece stays as it is, unless the path is shorter beside it.
int PathStraightener::pullTight(int vertex, int along) {
  for (;;) {
    const int next = along == kNone ? kNone : ways_[along].next;
    const auto path =
        strip_.straighten(vertex, next == kNone ? goal() : pointAt(ways_[next].vertex));
    if (!path) return kNone;
    if (next == kNone || isTight(next, strip_.angleAtEnd())) return keepPieces(*path, next);
    if (!goAlong(next)) return kNone;
    along = next;
  }
}

/// Whether a path that comes to the beginning of a way at an angle there and goes on with it is no
/// shorter on either side of the vertex: no angle between them is less than π.
bool PathStraightener::isTight(int bend, double angle) const {
  constexpr double kRounding = 1e-12;
  const int vertex = ways_[bend].vertex;
  const double between = std::abs(angle - ways_[bend].angle);
  if (mesh_.onBoundary(vertex)) return between >= pi - kRounding;
  const double all = mesh_.angleSum(vertex), onOneSide = std::fmod(between, all);
  return std::min(onOneSide, all - onOneSide) >= pi - kRounding;
}

SurfacePoint PathStraightener::pointAt(int vertex) const {
  const int h = mesh_.outgoing(vertex);
  return {TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

/// A halfedge between a vertex and the neighbour over which the label comes to it the shortest way,
/// of those that it owns and that are nearer to the site; -1 if there is none.
int PathStraightener::stepToOwner(int vertex) const {
  const bool isOwner = field_.nearest(vertex).label == label_;
  const double distance = isOwner ? field_.nearest(vertex).distance : kInfinity;
  double least = kInfinity;
  int step = -1;
  const auto consider = [&](int halfedge, int neighbour) {
    const LabelledDistance& there = field_.nearest(neighbour);
    const double over = there.distance + mesh_.length(halfedge);
    if (there.label != label_ || !(there.distance < distance) || !(over < least)) return;
    least = over;
    step = halfedge;
  };
  const int first = mesh_.outgoing(vertex);
  int h = first;
  do {
    const int back = TriangleMesh::previous(h);
    consider(h, mesh_.tip(h));
    if (mesh_.twin(back) < 0) consider(back, mesh_.tail(back));
    h = mesh_.rotate(h);
  } while (h >= 0 && h != first);
  return step;
}

int PathStraightener::otherEnd(int halfedge, int vertex) const {
  return mesh_.tail(halfedge) == vertex ? mesh_.tip(halfedge) : mesh_.tail(halfedge);
}

/// Walks from the vertex of a view to the view's source. Returns the vertex there, or kAtSite in
/// the face of the site; nothing if the line does not lead there, for views may be carried on
/// beside a vertex that the line passes on the other side.
std::optional<int> PathStraightener::lookBack(const View& view, const SurfacePoint& site) {
  if (view.halfedge < 0) return std::nullopt;
  const int h = view.halfedge, siteVertex = vertexAt(mesh_, site);
  const Vector2d from = apexOf(mesh_, h);
  const bool isVertex = view.isBent() || siteVertex >= 0;
  const auto isSource = [&](const Vector2d& place, double edge) {
    return isVertex && (place - view.source).squaredNorm() <= kSamePlace * kSamePlace * edge * edge;
  };
  walkedThrough_.clear();
  if (isSource({0, 0}, mesh_.length(h))) return mesh_.tail(h);
  if (isSource({mesh_.length(h), 0}, mesh_.length(h))) return mesh_.tip(h);
  if (!isVertex && TriangleMesh::faceOf(h) == site.face) return kAtSite;
  const auto end = walkStraight(
      mesh_, h, -view.path(mesh_), AtVertex::kPass,
      [&](int through) { walkedThrough_.push_back(through); },
      [&](int entry, const Vector2d& apex) {
        if (!isVertex) return TriangleMesh::faceOf(entry) == site.face;
        return isSource(apex + from, mesh_.length(entry)) ||
               (!view.isBent() && mesh_.tail(TriangleMesh::previous(entry)) == siteVertex);
      });
  if (!end) return std::nullopt;
  return isVertex ? mesh_.tail(TriangleMesh::previous(end->entry)) : kAtSite;
}

}  // namespace gvd
