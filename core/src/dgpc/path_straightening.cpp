// SPDX-License-Identifier: MIT
#include "dgpc/path_straightening.h"

#include <cmath>
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

constexpr int kAtSite = -1;

/// Places in one frame that are nearer to each other than this, as a share of an edge there, are
/// the same vertex: rounding along a path stays far below, and edges are longer.
constexpr double kSamePlace = 1e-6;

}  // namespace

std::optional<LocalGeodesic> PathStraightener::straighten(int label, int vertex, const View& view) {
  const SurfacePoint& site = field_.sites()[label];
  // Most paths that bend may as well be straight, and to find that out takes less.
  std::optional<LocalGeodesic> straight;
  if (std::isfinite(view.detour))
    straight = aim(view.halfedge, view.toSite - view.path(mesh_), site);
  if (straight && straight->length <= view.distance(mesh_) * (1 + kDistanceTolerance))
    return straight;
  // A straight line that is longer leads around something else, or the view shows what is not so.
  if (!followViews(label, vertex, view)) return straight;
  const auto near = strip_.straighten(vertex, site);
  return straight && !(near && near->length < straight->length) ? straight : near;
}

/// A straight line to the site from the apex of a halfedge: where the given one, in the halfedge's
/// frame, leads beside the site, it is drawn anew to where the site is seen from there.
std::optional<LocalGeodesic> PathStraightener::aim(int halfedge, Vector2d line,
                                                   const SurfacePoint& site) {
  constexpr int kMostAims = 4;
  const int siteVertex = vertexAt(mesh_, site);
  if (TriangleMesh::faceOf(halfedge) == site.face) return std::nullopt;
  const auto isAtSite = [&](int entry, const Vector2d&) {
    return siteVertex >= 0 ? mesh_.tail(TriangleMesh::previous(entry)) == siteVertex
                           : TriangleMesh::faceOf(entry) == site.face;
  };
  for (int i = 0; i < kMostAims; ++i) {
    const auto end = walkStraight(mesh_, halfedge, line, AtVertex::kStop, isAtSite);
    if (!end) return std::nullopt;
    const int k = end->entry % 3;
    line = siteVertex >= 0
               ? end->apex
               : Vector2d(site.bary[k] * end->left + site.bary[(k + 1) % 3] * end->right +
                          site.bary[(k + 2) % 3] * end->apex);
    if (isGrazing(end->leftBound, line) || isGrazing(end->rightBound, line)) return std::nullopt;
    if (!end->isInSight(line)) continue;
    const Vector2d along = (end->right - end->left) / mesh_.length(end->entry);
    return LocalGeodesic{line.norm(),
                         inSiteFrame(mesh_, site, end->entry, turnedBackBy(-line, along))};
  }
  return std::nullopt;
}

/// Makes the strip that the path from a vertex back to the site runs through, as the views tell it;
/// along edges where they tell nothing. False if there is no way.
bool PathStraightener::followViews(int label, int vertex, const View& first) {
  const SurfacePoint& site = field_.sites()[label];
  const View* view = &first;
  bool hasStarted = false;
  const auto goOn = [&](int at, int face) {
    if (std::exchange(hasStarted, true)) return strip_.turn(at, face);
    strip_.start(face);
    return true;
  };
  for (int at = vertex; view->halfedge >= 0;) {
    std::optional<int> source = lookBack(*view, site);
    if (source) {
      if (!goOn(at, TriangleMesh::faceOf(view->halfedge))) return false;
      for (const int h : walkedThrough_) strip_.goThrough(h);
    } else {
      const int edge = stepToOwner(label, at);
      if (edge < 0 || !goOn(at, TriangleMesh::faceOf(edge))) return false;
      source = mesh_.tail(edge) == at ? mesh_.tip(edge) : mesh_.tail(edge);
    }
    if (*source == kAtSite) return true;
    const LabelledDistance &here = field_.nearest(at), &there = field_.nearest(*source);
    const bool isNearer = here.label != label || there.distance < here.distance;
    if (there.label != label || !isNearer) return false;
    at = *source;
    view = &field_.view(at);
  }
  return hasStarted;
}

/// A halfedge between a vertex and the neighbour over which a label comes to it the shortest way,
/// of those that the label owns and that are nearer to the site; -1 if there is none.
int PathStraightener::stepToOwner(int label, int vertex) const {
  const bool isOwner = field_.nearest(vertex).label == label;
  const double distance = isOwner ? field_.nearest(vertex).distance : kInfinity;
  double least = kInfinity;
  int step = -1;
  const auto consider = [&](int halfedge, int neighbour) {
    const LabelledDistance& there = field_.nearest(neighbour);
    const double over = there.distance + mesh_.length(halfedge);
    if (there.label != label || !(there.distance < distance) || !(over < least)) return;
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

/// Walks from the vertex of a view to the view's source. Returns the vertex there, or kAtSite in
/// the face of the site; nothing if the line does not lead there, for views may be carried on
/// beside a vertex that the line passes on the other side.
std::optional<int> PathStraightener::lookBack(const View& view, const SurfacePoint& site) {
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
