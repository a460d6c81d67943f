// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/dgpc/unfolding_sweep.h"

#include <utility>

#include "base/tolerances.h"
#include "distance/site_frame.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"
#include "mesh/prefetch_around.h"

namespace gvd::dgpc {

using Eigen::Vector2d;

void UnfoldingSweep::start(const SurfacePoint& site, std::optional<double> reach) {
  reach_ = reach;
  for (const int v : reached_) vertices_[v].distance = vertices_[v].improvesBelow = kInfinity;
  reached_.clear();
  const TriangleMesh::Face& face = mesh_.face(site.face);
  const Incidence incidence = incidenceOf(site.bary);
  if (incidence.corner >= 0) {
    const int vertex = face.vertices[incidence.corner];
    const std::span<const int> fan = mesh_.fan(vertex);
    offer(vertex, 0, {1, 0});
    double angle = angleOfOutgoing(mesh_, site, fan.front());
    for (const int h : fan) {
      offer(mesh_.tip(h), mesh_.length(h), unitVector(angle));
      angle += mesh_.cornerAngle(h);
    }
    if (const int last = TriangleMesh::previous(fan.back()); mesh_.twin(last) < 0)
      offer(mesh_.tail(last), mesh_.length(last), unitVector(angle));
    return;
  }
  const int side = incidence.side, twin = side >= 0 ? face.twins[side] : -1;
  // Where a site stops, distances depend on the order in which vertices spread. So the faces come
  // in one order, whichever of them names the site.
  const bool isBeyondFirst = twin >= 0 && TriangleMesh::faceOf(twin) < site.face;
  if (isBeyondFirst) startAcross(site, side);
  startInFace(site, {1, 0});
  if (twin >= 0 && !isBeyondFirst) startAcross(site, side);
}

/// Starts a site on a side in the face beyond the side.
void UnfoldingSweep::startAcross(const SurfacePoint& site, int side) {
  const TriangleMesh::Face& face = mesh_.face(site.face);
  // The direction of the side in the site's frame. In the face beyond, the side runs the other way,
  // and the first side of that face is turned from it by `firstSide`.
  const Vector2d along =
      layOut(face, 0, Eigen::Vector3d::Unit(cornerAfter(side)) - Eigen::Vector3d::Unit(side)) /
      face.lengths[side];
  const int twin = face.twins[side];
  startInFace(acrossEdge(mesh_, site, 3 * site.face + side),
              turnedBy(-along, firstSide(mesh_, TriangleMesh::faceOf(twin), twin % 3)));
}

/// Gives the corners of a face their distances from a site in it. `firstSide` is the direction of
/// the face's first side in the site's frame.
void UnfoldingSweep::startInFace(const SurfacePoint& site, const Vector2d& firstSide) {
  const TriangleMesh::Face& face = mesh_.face(site.face);
  for (int i = 0; i < 3; ++i) {
    const Vector2d way = wayToCorner(face, 0, site.bary, i);
    const double length = way.norm();
    offer(face.vertices[i], length, turnedBy(way / length, firstSide));
  }
}

bool UnfoldingSweep::step(long& budget) {
  while (queue_.advance()) {
    if (budget <= 0) return false;
    if (const auto later = queue_.ahead(2 * kPrefetchAhead)) prefetchFan(mesh_, *later);
    for (const int next : queue_.toPrefetch())
      if (vertices_[next].isQueued) prefetchFacesAround(mesh_, next);
    const int v = queue_.take();
    if (!std::exchange(vertices_[v].isQueued, false)) continue;
    --budget;
    passOn(v);
  }
  return true;
}

void UnfoldingSweep::improve(int v, double distance, const Vector2d& direction) {
  Vertex& own = vertices_[v];
  if (own.distance < kInfinity) {
    ++own.improvements;
  } else {
    own.improvements = 0;
    reached_.push_back(v);
  }
  own.distance = distance;
  own.improvesBelow =
      distance * (1 - kDistanceTolerance * static_cast<double>(1LL << own.improvements));
  own.direction = direction;
  own.isQueued = distance <= reach_.value_or(own.reach);
  if (!own.isQueued) return;
  // Older entries of the vertex may remain in the queue: `step` acts on the first that it meets.
  queue_.add(v, queue_.bucketOf(distance));
}

/// Offers the apex of a side its distance from the virtual source behind the side, if the source
/// sees the apex through the side. Where the site has not reached both ends, there is no source.
/// Inlined, because most sides are done with after the first test.
[[gnu::always_inline]] inline void UnfoldingSweep::unfoldAcross(int h) {
  const TriangleMesh::Face& face = mesh_.face(TriangleMesh::faceOf(h));
  const int side = h % 3;
  const int tail = face.vertices[side], tip = face.vertices[cornerAfter(side)];
  const int apex = face.vertices[cornerBefore(side)];
  const Vertex &atTail = vertices_[tail], &atTip = vertices_[tip];
  const double most = vertices_[apex].improvesBelow;
  if (const auto unfolding = unfold(face, side, atTail.distance, atTip.distance, most))
    offer(apex, unfolding->toApex.norm(), directionToApex(*unfolding, atTail, atTip));
}

/// Passes on the distance of a vertex: across the sides that end at it in the faces around it, and
/// along its edges, which comes last because a path across a side is shorter, if there is one. The
/// sides come as a wavefront crosses them, once around each way from the nearest neighbour: an apex
/// that is given its distance across one side is an end of the next.
void UnfoldingSweep::passOn(int v) {
  const Vertex& own = vertices_[v];
  const std::span<const int> fan = mesh_.fan(v);
  const int size = static_cast<int>(fan.size());
  const int nearest = nearestNeighbour(fan);
  const auto outgoing = [&](int k) { return fan[k < size ? k : k - size]; };
  for (int k = nearest; k < nearest + size; ++k) unfoldAcross(outgoing(k));
  for (int k = nearest + size - 1; k >= nearest; --k)
    unfoldAcross(TriangleMesh::previous(outgoing(k)));
  for (const int h : fan) offer(mesh_.tip(h), own.distance + mesh_.length(h), own.direction);
  const int last = TriangleMesh::previous(fan.back());
  offer(mesh_.tail(last), own.distance + mesh_.length(last), own.direction);
}

/// The place in a fan of the halfedge that leads to the vertex nearest to the site.
int UnfoldingSweep::nearestNeighbour(std::span<const int> fan) const {
  int nearest = 0;
  double least = kInfinity;
  for (int k = 0; k < static_cast<int>(fan.size()); ++k)
    if (const double distance = vertices_[mesh_.tip(fan[k])].distance; distance < least) {
      least = distance;
      nearest = k;
    }
  return nearest;
}

/// The direction of the path to an apex: interpolated between the directions of the side's ends,
/// each turned by the angle between that end and the apex as seen from the virtual source.
Vector2d UnfoldingSweep::directionToApex(const Unfolding& u, const Vertex& tail,
                                         const Vertex& tip) {
  const auto turned = [&](const Vertex& end, const Vector2d& toEnd) -> Vector2d {
    return turnedBy(end.direction, turnedBackBy(u.toApex, toEnd)) / end.distance;
  };
  // A source at an end has no direction there.
  if (tail.distance == 0) return turned(tip, u.toTip).normalized();
  if (tip.distance == 0) return turned(tail, u.toTail).normalized();
  const double besideTail = cross(u.toApex, u.toTail), besideTip = cross(u.toTip, u.toApex);
  const double sum = besideTail + besideTip;
  const double share = sum > 0 ? std::clamp(besideTail / sum, 0.0, 1.0) : 0.5;
  const Vector2d mean = (1 - share) * turned(tail, u.toTail) + share * turned(tip, u.toTip);
  return mean.squaredNorm() > 0 ? mean.normalized() : turned(tail, u.toTail).normalized();
}

}  // namespace gvd::dgpc
