// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/dgpc/unfolding_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "distance/dgpc/unfolding_spread.h"
#include "distance/face_layout.h"
#include "mesh/surface_geometry.h"

namespace gvd::dgpc {

using Eigen::Vector2d;

UnfoldingPath::UnfoldingPath(const TriangleMesh& mesh, const SurfacePoint& site,
                             std::span<const ReachedVertex> reached)
    : mesh_(mesh), points_(mesh, site), distances_(mesh.vertexCount(), kInfinity) {
  for (const ReachedVertex& r : reached) distances_[r.vertex] = r.distance;
}

std::vector<SurfacePoint> UnfoldingPath::from(const SurfacePoint& p) {
  points_.add(p);
  const int start = vertexAt(mesh_, p);
  if (start >= 0) bound_ = distances_[start];
  while (!points_.endAtSite()) {
    const size_t size = points_.size();
    if (goStraight()) continue;
    points_.shrinkTo(size);
    if (goOverVertex()) continue;
    // A required distance may be less than all around it. Only the first vertex can have one.
    if (size > 1 || start < 0 || distances_[start] == kInfinity) return {};
    distances_[start] = bound_ = kInfinity;
  }
  return points_.take();
}

/// Goes on up to a nearer vertex, or to a face that has the site. False if neither is met.
bool UnfoldingPath::goStraight() {
  double before = kInfinity;
  for (int crossed = 0; crossed <= mesh_.faceCount(); ++crossed) {
    const Step step = best(true);
    if (!(step.distance < before)) return false;
    before = step.distance;
    points_.add(step.to);
    const int vertex = vertexAt(mesh_, step.to);
    if (vertex >= 0 && distances_[vertex] < bound_) {
      bound_ = distances_[vertex];
      return true;
    }
    bool isBeside = false;
    visitPlaces(mesh_, step.to,
                [&](const SurfacePoint& place) { isBeside |= points_.hasSite(place.face); });
    if (isBeside) return true;
  }
  return false;
}

bool UnfoldingPath::goOverVertex() {
  const Step step = best(false);
  if (step.distance == kInfinity) return false;
  points_.add(step.to);
  bound_ = distances_[vertexAt(mesh_, step.to)];
  return true;
}

/// The next step by which the last point is nearest: to a corner, or across a side.
UnfoldingPath::Step UnfoldingPath::best(bool mayCross) const {
  Step best;
  visitPlaces(mesh_, points_.last(), [&](const SurfacePoint& place) {
    for (int i = 0; i < 3; ++i) offerCorner(place, i, best);
    for (int i = 0; i < 3 && mayCross; ++i) offerSide(place, i, best);
  });
  return best;
}

void UnfoldingPath::offerCorner(const SurfacePoint& place, int corner, Step& best) const {
  const TriangleMesh::Face& face = mesh_.face(place.face);
  const double distance = distances_[face.vertices[corner]];
  if (!(distance < bound_) || place.bary[corner] == 1) return;
  const Eigen::Vector3d there = Eigen::Vector3d::Unit(corner);
  const double length = distance + layOut(face, 0, there - place.bary).norm();
  if (length < best.distance) best = {length, {place.face, there}};
}

/// The virtual source behind a side that the point is not on, if the point is seen through the side.
void UnfoldingPath::offerSide(const SurfacePoint& place, int side, Step& best) const {
  const TriangleMesh::Face& face = mesh_.face(place.face);
  if (place.bary[cornerBefore(side)] == 0 || face.twins[side] < 0) return;
  const double atTail = distances_[face.vertices[side]];
  const double atTip = distances_[face.vertices[cornerAfter(side)]];
  const std::optional<Vector2d> source = virtualSource(face.lengths[side], atTail, atTip);
  if (!source) return;
  const Vector2d p = layOut(face, side, place.bary), way = p - *source;
  const double along = source->x() - way.x() * (source->y() / way.y());
  const double slack = kUnfoldingRounding * face.lengths[side];
  if (!(along >= -slack && along <= face.lengths[side] + slack)) return;
  const double distance = way.norm();
  if (distance < best.distance)
    best = {distance, pointOnHalfedge(mesh_, 3 * place.face + side, along)};
}

// --- The path of a label -----------------------------------------------------------------------

std::vector<SurfacePoint> UnfoldingSpread::path(int label, const SurfacePoint& p) const {
  return UnfoldingPath(mesh_, sites_[label], labels_[label].vertices).from(p);
}

}  // namespace gvd::dgpc
