// SPDX-License-Identifier: MIT
#include "path_straightening.h"

#include <algorithm>
#include <utility>

#include "plane.h"
#include "surface_geometry.h"
#include "unfolding.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

constexpr int kAtSite = -1;

/// Places in one frame that are nearer to each other than this, as a share of an edge there, are
/// the same vertex: rounding along a path stays far below, and edges are longer.
constexpr double kSamePlace = 1e-6;

}  // namespace

std::optional<LocalGeodesic> PathStraightener::straighten(int label, int vertex) {
  if (!followViews(label, vertex)) return std::nullopt;
  return strip_.straighten(vertex, field_.sites()[label]);
}

/// Makes the strip that the path from a vertex back to the site runs through, as the views tell it;
/// along edges where they tell nothing. False if there is no way.
bool PathStraightener::followViews(int label, int vertex) {
  const SurfacePoint& site = field_.sites()[label];
  bool hasStarted = false;
  const auto goOn = [&](int at, int face) {
    if (std::exchange(hasStarted, true)) return strip_.turn(at, face);
    strip_.start(face);
    return true;
  };
  for (int at = vertex;;) {
    std::optional<int> source;
    const bool isOwner = field_.nearest(at).label == label;
    if (!isOwner && at != vertex) return false;
    if (isOwner) {
      const View& view = field_.view(at);
      if (view.halfedge < 0) return hasStarted;
      source = lookBack(view, site);
      if (source) {
        if (!goOn(at, TriangleMesh::faceOf(view.halfedge))) return false;
        for (const int h : seenThrough_) strip_.goThrough(h);
      }
    }
    if (!source) {
      const int edge = stepToOwner(label, at);
      if (edge < 0 || !goOn(at, TriangleMesh::faceOf(edge))) return false;
      source = mesh_.tail(edge) == at ? mesh_.tip(edge) : mesh_.tail(edge);
    }
    if (*source == kAtSite) return true;
    const double distance = field_.nearest(*source).distance;
    if (isOwner && !(distance < field_.nearest(at).distance)) return false;
    at = *source;
  }
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

/// Notes the halfedges through which a straight line leads from the vertex of a view to the view's
/// source. Returns the vertex there, or kAtSite in the face of the site; nothing if the line does
/// not come there, for views may be carried on beside a vertex that the line passes on the other
/// side.
std::optional<int> PathStraightener::lookBack(const View& view, const SurfacePoint& site) {
  seenThrough_.clear();
  int h = view.halfedge;
  const TriangleMesh::Layout& l = mesh_.layout(h);
  const Vector2d from(l.x, l.y), line = view.source - from;
  Vector2d left(l.length, 0), right(0, 0);  // on the way
  const int siteVertex = vertexAt(mesh_, site);
  const bool isVertex = view.isBent || siteVertex >= 0;
  const auto isSource = [&](const Vector2d& place, double edge) {
    return isVertex && (place - view.source).squaredNorm() <= kSamePlace * kSamePlace * edge * edge;
  };
  if (!(line.squaredNorm() > 0)) return std::nullopt;
  if (isSource(right, l.length)) return mesh_.tail(h);
  if (isSource(left, l.length)) return mesh_.tip(h);
  if (!isVertex && TriangleMesh::faceOf(h) == site.face) return kAtSite;

  // Where the line leaves beside the halfedge, it does so through a face around the vertex.
  while (cross(right - from, line) < 0) {
    const int over = TriangleMesh::previous(h), entry = mesh_.twin(over);
    if (entry < 0 || TriangleMesh::faceOf(entry) == TriangleMesh::faceOf(view.halfedge)) return std::nullopt;
    seenThrough_.push_back(over);
    left = std::exchange(right, apexBeside(mesh_, entry, right, from));
    h = TriangleMesh::previous(entry);
  }
  while (cross(line, left - from) < 0) {
    const int over = TriangleMesh::next(h), entry = mesh_.twin(over);
    if (entry < 0 || TriangleMesh::faceOf(entry) == TriangleMesh::faceOf(view.halfedge)) return std::nullopt;
    seenThrough_.push_back(over);
    right = std::exchange(left, apexBeside(mesh_, entry, from, left));
    h = TriangleMesh::next(entry);
  }
  for (int steps = 0; steps < mesh_.faceCount(); ++steps) {
    const int entry = mesh_.twin(h);
    if (entry < 0) return std::nullopt;
    seenThrough_.push_back(h);
    const Vector2d apex = apexBeside(mesh_, entry, left, right);
    const int atApex = mesh_.tail(TriangleMesh::previous(entry));
    if (isSource(apex, mesh_.length(entry)) || (!view.isBent && atApex == siteVertex))
      return atApex;
    if (!isVertex && TriangleMesh::faceOf(entry) == site.face) return kAtSite;
    const double ahead = std::min((left - from).dot(line), (right - from).dot(line));
    if (ahead > line.squaredNorm()) return std::nullopt;
    const bool isApexLeft = cross(line, apex - from) > 0;
    (isApexLeft ? left : right) = apex;
    h = isApexLeft ? TriangleMesh::next(entry) : TriangleMesh::previous(entry);
  }
  return std::nullopt;
}

}  // namespace gvd
