// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/dgpc/unfolding_path.h"

#include <cmath>
#include <optional>

#include "distance/dgpc/unfolding_sweep.h"
#include "mesh/face_layout.h"
#include "mesh/representations.h"

namespace gvd::dgpc {

using Eigen::Vector2d;

std::vector<SurfacePoint> UnfoldingPath::from(const SurfacePoint& p) {
  points_.add(p);
  if (const int vertex = vertexAt(mesh_, p); vertex >= 0) bound_ = distanceAt_(vertex);
  while (!points_.endAtSite()) {
    const size_t size = points_.size();
    if (goStraight()) continue;
    points_.shrinkTo(size);
    if (!goOverVertex()) return {};
  }
  return points_.take();
}

/// Goes on up to a nearer vertex, or to a face that has the site. False if neither is met.
bool UnfoldingPath::goStraight() {
  Step step;
  for (int crossed = 0; crossed <= mesh_.faceCount(); ++crossed) {
    const Step next = best();
    if (next.distance < step.distance) {
      step = next;
    } else {  // Distances disagree here: straight on.
      StraightLine& line = step.line;
      if (line.halfedge < 0) return false;
      step.distance = line.length();
      if (!line.enterFace(mesh_) || !line.crossFace(mesh_)) return false;
      step.to = pointOnHalfedge(mesh_, line.halfedge, line.along);
    }
    points_.add(step.to);
    const int vertex = vertexAt(mesh_, step.to);
    if (vertex >= 0 && distanceAt_(vertex) < bound_) {
      bound_ = distanceAt_(vertex);
      return true;
    }
    if (points_.isBesideSite(step.to)) return true;
  }
  return false;
}

/// The step with the least distance from the last point: to a corner, or across a side.
UnfoldingPath::Step UnfoldingPath::best() const {
  const CornerOnPath over = bestCorner(mesh_, points_.last(), bound_, distanceAt_);
  Step best{over.length, over.corner, {}};
  visitRepresentations(mesh_, points_.last(), [&](const SurfacePoint& place) {
    for (int i = 0; i < 3; ++i) offerSide(place, i, best);
  });
  return best;
}

bool UnfoldingPath::goOverVertex() {
  const CornerOnPath over = bestCorner(mesh_, points_.last(), bound_, distanceAt_);
  if (over.vertex < 0) return false;
  points_.add(over.corner);
  bound_ = distanceAt_(over.vertex);
  return true;
}

/// The virtual source behind a side that the point is not on, if the point is seen through the
/// side.
void UnfoldingPath::offerSide(const SurfacePoint& place, int side, Step& best) const {
  const TriangleMesh::Face& face = mesh_.face(place.face);
  if (place.bary[cornerBefore(side)] == 0 || face.twins[side] < 0) return;
  const double atTail = distanceAt_(face.vertices[side]);
  const double atTip = distanceAt_(face.vertices[cornerAfter(side)]);
  const std::optional<Vector2d> source = virtualSource(face.lengths[side], atTail, atTip);
  if (!source) return;
  const Vector2d p = layOut(face, side, place.bary), way = p - *source;
  const double along = source->x() - way.x() * (source->y() / way.y());
  const double slack = kUnfoldingRounding * face.lengths[side];
  if (!(along >= -slack && along <= face.lengths[side] + slack)) return;
  const double distance = way.norm();
  if (!(distance < best.distance)) return;
  const int h = 3 * place.face + side;
  best = {distance, pointOnHalfedge(mesh_, h, along), {h, along, *source}};
}

}  // namespace gvd::dgpc
