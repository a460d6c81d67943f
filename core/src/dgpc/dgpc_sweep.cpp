// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
#include "dgpc/dgpc_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/index_set.h"
#include "base/prefetch.h"
#include "base/tolerances.h"
#include "dgpc/straight_walk.h"
#include "distance/edge_share.h"
#include "distance/site_frame.h"
#include "mesh/surface_geometry.h"

namespace gvd {

using Eigen::Vector2d;

DgpcSweep::DgpcSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread)
    : mesh_(mesh),
      sites_(sites.begin(), sites.end()),
      owner_(mesh.vertexCount(), -1),
      meetsShadows_(sites.size()),
      isEntangled_(sites.size()),
      spread_(spread),
      limits_(mesh.vertexCount()),
      isSharp_(mesh.vertexCount()),
      queue_(mesh.meanEdgeLength()) {
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    limits_[v] = limitsViews(mesh, v);
    isSharp_[v] = castsShadow(mesh, v);
  }
  entries_.reserve(2 * owner_.size());
  entries_.resize(owner_.size());
  views_.reserve(2 * owner_.size());
  views_.resize(owner_.size());
  for (int label = 0; label < static_cast<int>(sites_.size()); ++label) seed(label);
}

bool DgpcSweep::step(long budget) {
  do {
    budget = drain(budget);
    if (!queue_.empty()) return false;
  } while (reachTheUnseen());
  return true;
}

/// Settles at most so many entries; returns how many are left of them.
long DgpcSweep::drain(long budget) {
  for (; budget > 0 && !queue_.empty(); --budget) {
    const QueueItem item = queue_.pop();
    prefetchUpcoming();
    if (item.distance != entries_[item.entry].distance) continue;
    clock_ = std::max(clock_, item.distance);
    settle(item.entry);
  }
  return budget;
}

/// Settling an entry waits for memory more than for anything else, so what the next ones need is
/// asked for ahead: first what they know, and of the very next, of which that has been asked for
/// before, the faces that its view is carried on to.
void DgpcSweep::prefetchUpcoming() const {
  const auto upcoming = queue_.upcoming();
  for (const QueueItem& item : upcoming) {
    prefetch(entries_[item.entry]);
    prefetch(views_[item.entry]);
    if (item.halfedge >= 0) prefetch(mesh_.twins()[item.halfedge]);
  }
  if (upcoming.empty() || upcoming[0].halfedge < 0) return;
  prefetchFan(mesh_, upcoming[0].halfedge, [&](int v) { prefetch(entries_[v]); });
}

double DgpcSweep::progress() const {
  return queue_.empty()
             ? 1.0
             : std::min(1.0, static_cast<double>(reachedVertices_) / mesh_.vertexCount());
}

std::unique_ptr<DgpcField> DgpcSweep::take() {
  std::vector<LabelledDistance> nearest(mesh_.vertexCount());
  for (int v = 0; v < mesh_.vertexCount(); ++v) {
    const int entry = nearestEntry(v);
    if (entry < 0) continue;
    nearest[v] = {entries_[entry].label, entries_[entry].distance};
    if (entry != v) views_[v] = views_[entry];
  }
  views_.resize(mesh_.vertexCount());
  return std::make_unique<DgpcField>(mesh_, std::move(sites_), std::move(nearest),
                                     std::move(views_));
}

DgpcSweep::Nearest DgpcSweep::nearest(int vertex) const {
  const int entry = nearestEntry(vertex);
  if (entry < 0) return {};
  return {{entries_[entry].label, entries_[entry].distance}, views_[entry]};
}

// --- Entries ---

int DgpcSweep::find(int vertex, int label) const {
  int e = vertex;
  while (e >= 0 && entries_[e].label != label) e = entries_[e].next;
  return e;
}

double DgpcSweep::distanceAt(int vertex, int label) const {
  const int e = find(vertex, label);
  return e < 0 ? kInfinity : entries_[e].distance;
}

/// The distance of the nearest label.
double DgpcSweep::leastAt(int vertex) const { return distanceAt(vertex, owner_[vertex]); }

/// Of the nearest label, of those that tie the lowest.
int DgpcSweep::nearestEntry(int vertex) const {
  if (owner_[vertex] < 0) return -1;
  const double tie = leastAt(vertex) * (1 + kDistanceTolerance);
  int nearest = -1;
  for (int e = vertex; e >= 0; e = entries_[e].next)
    if (entries_[e].distance <= tie && (nearest < 0 || entries_[e].label < entries_[nearest].label))
      nearest = e;
  return nearest;
}

int DgpcSweep::add(int vertex, int label) {
  Entry& first = entries_[vertex];
  if (first.label < 0) {
    first.label = label;
    return vertex;
  }
  int entry = static_cast<int>(entries_.size());
  if (released_.empty()) {
    entries_.emplace_back();
    views_.emplace_back();
    vertices_.emplace_back();
  } else {
    entry = released_.back();
    released_.pop_back();
  }
  const int next = std::exchange(entries_[vertex].next, entry);
  entries_[entry] = {kInfinity, label, next};
  vertices_[entry - mesh_.vertexCount()] = vertex;
  return entry;
}

int DgpcSweep::vertexOf(int entry) const {
  return entry < mesh_.vertexCount() ? entry : vertices_[entry - mesh_.vertexCount()];
}

/// Takes a path for a label to a vertex if it is shorter than what is known by more than
/// rounding; `view` is only asked for then.
template <class MakeView>
void DgpcSweep::offer(int vertex, int label, double distance, MakeView view) {
  int entry = find(vertex, label);
  if (entry < 0) entry = add(vertex, label);
  Entry& e = entries_[entry];
  if (!(distance < e.distance * (1 - kDistanceTolerance))) return;
  if (isSharp_[vertex]) meetsShadows_[label] = isEntangled_[label] = true;
  if (distance < clock_) late_.push_back(entry);
  if (notesAccepted_) accepted_.push_back(entry);
  e.distance = distance;
  views_[entry] = view();
  if (owner_[vertex] != label && distance < leastAt(vertex)) {
    if (owner_[vertex] < 0) ++reachedVertices_;
    owner_[vertex] = label;
  }
  queue(entry);
}

void DgpcSweep::queue(int entry) {
  const Entry& e = entries_[entry];
  queue_.push({e.distance, entry, e.label, views_[entry].halfedge});
}

/// Makes room for so many labels, without sites.
void DgpcSweep::addLabels(int count) {
  sites_.resize(count);
  meetsShadows_.resize(count);
  isEntangled_.resize(count);
}

/// For a sweep after one that is done.
void DgpcSweep::startAnew() {
  queue_.restart();
  clock_ = 0;
}

/// The corners of a site's face see it directly. A site on an edge is seen from the other face
/// through these views, and one at a vertex along the edges there.
void DgpcSweep::seed(int label) {
  const SurfacePoint& site = sites_[label];
  for (int i = 0; i < 3; ++i) {
    const double distance = distanceOfCorner(mesh_, site, i);
    offer(mesh_.tail(3 * site.face + i), label, distance,
          [&] { return distance > 0 ? viewOfCorner(mesh_, site, i) : View(); });
  }
}

// --- Spreading ---

void DgpcSweep::settle(int entry) {
  Origin from{.view = views_[entry],
              .path = {0, 0},
              .vertex = vertexOf(entry),
              .label = entries_[entry].label,
              .distance = entries_[entry].distance,
              .isLimit = false};
  if (const int owner = owner_[from.vertex];
      owner != from.label && isLeastAt(from.vertex, from.distance))
    isEntangled_[from.label] = isEntangled_[owner] = true;
  if (from.view.halfedge < 0) {
    spreadFromSite(from.vertex, from.label);
    return;
  }
  from.path = from.view.path(mesh_);
  from.isLimit = limits_[from.vertex];
  // Between the sides, paths bend; the left one sees to that, up to the boundary both.
  const bool isBend = from.isLimit && mayBend(from.vertex, from.distance);
  const bool isOnBoundary = isBend && mesh_.onBoundary(from.vertex);
  const int behindRight =
      carry<Side::kRight>(from, isOnBoundary, isOnBoundary ? kToBoundary : kToFirstBehind);
  carry<Side::kLeft>(from, isBend, isBend ? behindRight : kToFirstBehind);
}

void DgpcSweep::spreadFromSite(int vertex, int label) {
  const double first = angleOfOutgoing(mesh_, sites_[label], mesh_.outgoing(vertex));
  visitSpokes(mesh_, vertex, [&](const Spoke& spoke) {
    offer(spoke.neighbour, label, spoke.length, [&] { return viewAlong(mesh_, spoke, first); });
  });
}

/// A path that bends at a vertex goes on there as any other label's path would, so only the
/// nearest label's can be of use.
bool DgpcSweep::mayBend(int vertex, double distance) const {
  return spread_ == Spread::kEverywhere || isLeastAt(vertex, distance);
}

/// Whether no label is nearer to a vertex, ties aside.
bool DgpcSweep::isLeastAt(int vertex, double distance) const {
  return distance <= leastAt(vertex) * (1 + kDistanceTolerance);
}

/// Whether another label is ahead of this one for good: at both ends of an edge it is nearer, or
/// as near and the lower one. What crosses this edge then owns nothing behind it.
bool DgpcSweep::isHidden(const Origin& from, int outer, const Vector2d& toOuter) const {
  const int v = from.vertex, nearV = owner_[v], nearOuter = owner_[outer];
  const double atOuter = from.view.offset + toOuter.norm();
  if (nearV != from.label && isAhead(nearV, leastAt(v), from.label, from.distance) &&
      isAhead(nearV, distanceAt(outer, nearV), from.label, atOuter))
    return true;
  return nearOuter >= 0 && nearOuter != from.label && nearOuter != nearV &&
         isAhead(nearOuter, leastAt(outer), from.label, atOuter) &&
         isAhead(nearOuter, distanceAt(v, nearOuter), from.label, from.distance);
}

/// Whether a label goes on over an edge.
bool DgpcSweep::mayCross(const Origin& from, int outer, const Vector2d& toOuter) const {
  if (spread_ == Spread::kEverywhere) return true;
  return (owner_[from.vertex] == from.label && owner_[outer] == from.label) ||
         !isHidden(from, outer, toOuter);
}

/// Whether a label's distance at a vertex cannot be improved by a path that is straight over the
/// given way, up to the given distance before it.
bool DgpcSweep::isFutile(int vertex, int label, const Vector2d& way, double before) const {
  const Entry& first = entries_[vertex];
  const double known = first.distance - before;
  return first.label == label && way.squaredNorm() >= known * std::abs(known);
}

/// Carries a view on to the vertices around its own, on one side, up to `last` (walkFan). Those
/// that are left behind are reached by bending.
template <Side side>
int DgpcSweep::carry(const Origin& from, bool isBend, int last) {
  const Vector2d zero(0, 0);
  const View& view = from.view;
  Sight<side> sight(view);
  return walkFan<side>(mesh_, view, from.path, last, [&](const FanFace& face) {
    if (face.place == FanFace::Place::kBefore) return;
    const int at = mesh_.tail(TriangleMesh::previous(face.halfedge));
    if (face.place == FanFace::Place::kBehind) {
      if (isBend) bend<side>(from, face, at);
      return;
    }
    const Vector2d toOuter = from.path + face.outer, toApex = from.path + face.apex;
    const int outer = outerEnd<side>(face, mesh_);
    if (limits_[outer]) sight.limit(toOuter);
    if (isFutile(at, from.label, toApex, view.offset) || !mayCross(from, outer, toOuter)) return;
    const Vector2d& bound = sight.bound();
    if (sight.reaches(toApex)) {
      offerIfClear<side>(from, face, at, view.offset + toApex.norm(), [&] {
        View next = viewThrough<side>(mesh_, view, from.path, face);
        limit<side>(next, from, face, zero, bound);
        return next;
      });
    } else if (sight.reachesAround(face, from.path, toApex)) {
      offer(at, from.label, view.offset + bound.norm() + (toApex - bound).norm(), [&] {
        View next = viewFromBend<side>(mesh_, view, from.path, face, bound);
        limit<side>(next, from, face, bound, limits_[outer] ? Vector2d(toOuter - bound) : zero);
        return next;
      });
    } else if (isBend) {
      bend<side>(from, face, at);
    }
  });
}

/// Limits a view through a face of the fan by what has limited the fan's own view on the inner
/// side and by the fan's vertex, and by what limits it on the outer side. The view's source is at
/// `shift` of the fan's.
template <Side side>
void DgpcSweep::limit(View& view, const Origin& from, const FanFace& face, const Vector2d& shift,
                      const Vector2d& outerBound) const {
  constexpr bool kLeft = side == Side::kLeft;
  const Vector2d zero(0, 0), axis = axisOf<side>(face);
  const Vector2d& limit = kLeft ? from.view.right : from.view.left;
  Vector2d innerBound = zero;
  if (from.isLimit)
    innerBound = from.path - shift;
  else if (limit != zero)
    innerBound = limit - shift;
  view.left = turnedBackBy(kLeft ? outerBound : innerBound, axis);
  view.right = turnedBackBy(kLeft ? innerBound : outerBound, axis);
}

/// Offers a view, or, if it leads elsewhere, the path around the vertex it is carried on from.
template <Side side, class MakeView>
void DgpcSweep::offerIfClear(const Origin& from, const FanFace& face, int at, double distance,
                             MakeView view) {
  if (from.view.isBent() || !meetsShadows_[from.label] || !isImproved(at, from.label, distance) ||
      isClear(view(), from.label))
    offer(at, from.label, distance, view);
  else if (mayBend(from.vertex, from.distance))
    bend<side>(from, face, at);
}

bool DgpcSweep::isImproved(int vertex, int label, double distance) const {
  return distance < distanceAt(vertex, label) * (1 - kDistanceTolerance);
}

/// Whether the straight line from the vertex of a view that does not bend leads to the site, on the
/// surface. A line of sight may leave the faces that it was unfolded through, and what is enclosed
/// between it and them may hide the site: a saddle or a hole that no fan on the way has met.
bool DgpcSweep::isClear(const View& view, int label) const {
  constexpr double kNear = 0.1;  // of the line: slight curvature may lead it beside the site
  const SurfacePoint& site = sites_[label];
  const Vector2d way = -view.path(mesh_);
  const double slack = kNear * way.norm();
  const auto isCornerOfSite = [&](int vertex, const Vector2d& place) {
    for (int i = 0; i < 3; ++i)
      if (mesh_.tail(3 * site.face + i) == vertex)
        return std::abs((place - way).norm() - distanceOfCorner(mesh_, site, i)) <= slack;
    return false;
  };
  const int h = view.halfedge;
  const Vector2d toTail = -apexOf(mesh_, h), toTip = toTail + Vector2d(mesh_.length(h), 0);
  if (isCornerOfSite(mesh_.tail(h), toTail) || isCornerOfSite(mesh_.tip(h), toTip)) return true;
  return walkStraight(mesh_, h, way, AtVertex::kPass,
                      [&](int entry, const Vector2d& apex) {
                        return isCornerOfSite(mesh_.tail(TriangleMesh::previous(entry)), apex);
                      })
      .has_value();
}

template <Side side>
void DgpcSweep::bend(const Origin& from, const FanFace& face, int at) {
  offer(at, from.label, from.distance + face.apex.norm(),
        [&] { return viewFromBend<side>(mesh_, from.view, from.path, face, from.path); });
}

/// Views end at what hides them. Should a vertex be out of sight from all sides, the path along
/// the edge from its nearest neighbour reaches it.
bool DgpcSweep::reachTheUnseen() {
  if (reachedVertices_ == mesh_.vertexCount()) return false;
  std::vector<int> nextToUnseen;
  for (int v = 0; v < mesh_.vertexCount(); ++v) {
    if (owner_[v] >= 0) continue;
    mesh_.visitNeighbours(v, [&](int neighbour) {
      if (owner_[neighbour] >= 0) nextToUnseen.push_back(neighbour);
    });
  }
  makeSet(nextToUnseen);
  std::vector<std::pair<int, Spoke>> edges;
  for (const int v : nextToUnseen) {
    visitSpokes(mesh_, v, [&](const Spoke& spoke) {
      if (owner_[spoke.neighbour] < 0) edges.emplace_back(v, spoke);
    });
  }
  for (const auto& [v, spoke] : edges) {
    const int entry = find(v, owner_[v]);
    const double distance = entries_[entry].distance;
    isEntangled_[owner_[v]] = true;
    const View via = viewOverEnd(mesh_, spoke.halfedge, spoke.isFromTail, distance,
                                 views_[entry].departure(mesh_, distance));
    offer(spoke.neighbour, owner_[v], distance + spoke.length, [&] { return via; });
  }
  return !edges.empty();
}

}  // namespace gvd
