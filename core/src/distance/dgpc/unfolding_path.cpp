// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/dgpc/unfolding_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

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
  if (const int vertex = vertexAt(mesh_, p); vertex >= 0) bound_ = distances_[vertex];
  while (!points_.endAtSite()) {
    const size_t size = points_.size();
    if (goStraight()) continue;
    points_.shrinkTo(size);
    if (!goOverVertex() && !goAlongEdges()) return {};
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
    if (vertex >= 0 && distances_[vertex] < bound_) {
      bound_ = distances_[vertex];
      return true;
    }
    if (points_.isBesideSite(step.to)) return true;
  }
  return false;
}

/// The step with the least distance from the last point: to a corner, or across a side.
UnfoldingPath::Step UnfoldingPath::best() const {
  Step best = nearestCorner();
  visitPlaces(mesh_, points_.last(), [&](const SurfacePoint& place) {
    for (int i = 0; i < 3; ++i) offerSide(place, i, best);
  });
  return best;
}

bool UnfoldingPath::goOverVertex() {
  const Step step = nearestCorner();
  if (step.distance == kInfinity) return false;
  points_.add(step.to);
  bound_ = distances_[vertexAt(mesh_, step.to)];
  return true;
}

/// Goes along the fewest edges to a vertex that is nearer to the site, or beside it. Needed because
/// an unfolded distance may be a local minimum.
bool UnfoldingPath::goAlongEdges() {
  std::unordered_map<int, int> cameFrom;  // vertex by vertex; -1: from the last point
  std::vector<int> queue;
  const auto meet = [&](int vertex, int from) {
    if (cameFrom.try_emplace(vertex, from).second) queue.push_back(vertex);
  };
  visitPlaces(mesh_, points_.last(), [&](const SurfacePoint& place) {
    for (const int vertex : mesh_.face(place.face).vertices) meet(vertex, -1);
  });
  for (size_t i = 0; i < queue.size(); ++i) {
    int vertex = queue[i];
    if (distances_[vertex] < bound_ || points_.isBesideSite(pointAtVertex(mesh_, vertex))) {
      bound_ = std::min(bound_, distances_[vertex]);
      std::vector<int> vertices;
      for (; vertex >= 0; vertex = cameFrom[vertex]) vertices.push_back(vertex);
      for (; !vertices.empty(); vertices.pop_back())
        points_.add(pointAtVertex(mesh_, vertices.back()));
      return true;
    }
    mesh_.visitNeighbours(vertex, [&](int neighbour) { meet(neighbour, vertex); });
  }
  return false;
}

/// The corner of the last point's faces over which the path on from there is shortest.
UnfoldingPath::Step UnfoldingPath::nearestCorner() const {
  Step best;
  visitPlaces(mesh_, points_.last(), [&](const SurfacePoint& place) {
    const TriangleMesh::Face& face = mesh_.face(place.face);
    for (int i = 0; i < 3; ++i) {
      const double distance = distances_[face.vertices[i]];
      if (!(distance < bound_) || place.bary[i] == 1) continue;
      const Eigen::Vector3d corner = Eigen::Vector3d::Unit(i);
      const double length = distance + layOut(face, 0, corner - place.bary).norm();
      if (length < best.distance) best = {length, {place.face, corner}, {}};
    }
  });
  return best;
}

/// The virtual source behind a side that the point is not on, if the point is seen through the
/// side.
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
  if (!(distance < best.distance)) return;
  const int h = 3 * place.face + side;
  best = {distance, pointOnHalfedge(mesh_, h, along), {h, along, *source}};
}

// --- The path of a label -----------------------------------------------------------------------

std::vector<SurfacePoint> UnfoldingSpread::path(int label, const SurfacePoint& p) {
  return UnfoldingPath(mesh_, sites_[label], labels_[label].vertices).from(p);
}

}  // namespace gvd::dgpc
