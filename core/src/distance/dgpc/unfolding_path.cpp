// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/dgpc/unfolding_path.h"

#include <optional>

#include "distance/dgpc/unfolding_sweep.h"
#include "distance/path_points.h"
#include "distance/straight_line.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd::dgpc {
namespace {

using Eigen::Vector2d;

class UnfoldingPath {
 public:
  UnfoldingPath(const TriangleMesh& mesh, const SurfacePoint& site,
                const std::function<double(int vertex)>& distanceAt)
      : mesh_(mesh), points_(mesh, site), distanceAt_(distanceAt) {}

  std::vector<SurfacePoint> from(const SurfacePoint& p) {
    points_.add(p);
    if (const int vertex = vertexAt(mesh_, p); vertex >= 0) bound_ = distanceAt_(vertex);
    while (!points_.endAtSite()) {
      const size_t size = points_.size();
      if (goStraight()) continue;
      points_.shrinkTo(size);
      const CornerOnPath over = bestCorner(mesh_, points_.last(), bound_, distanceAt_);
      if (over.vertex < 0) return {};
      points_.add(over.corner);
      bound_ = distanceAt_(over.vertex);
    }
    return points_.take();
  }

 private:
  /// The next point, and the distance of the current point from the site by way of it.
  struct Step {
    double distance = kInfinity;
    SurfacePoint to;
    StraightLine line;  ///< the rest of the way, if the step crosses a side
  };

  /// Goes on up to a nearer vertex, or to a face that has the site. False if neither is met.
  bool goStraight() {
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
  Step best() const {
    const CornerOnPath over = bestCorner(mesh_, points_.last(), bound_, distanceAt_);
    Step best{over.length, over.corner, {}};
    visitRepresentations(mesh_, points_.last(), [&](const SurfacePoint& place) {
      for (int i = 0; i < 3; ++i) offerSide(place, i, best);
    });
    return best;
  }

  /// The virtual source behind a side that the point is not on, if the point is seen through the
  /// side.
  void offerSide(const SurfacePoint& place, int side, Step& best) const {
    const TriangleMesh::Face& face = mesh_.face(place.face);
    if (place.bary[cornerBefore(side)] == 0 || face.twins[side] < 0) return;
    const std::optional<Vector2d> source =
        virtualSource(face.lengths[side], distanceAt_(face.vertices[side]),
                      distanceAt_(face.vertices[cornerAfter(side)]));
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

  const TriangleMesh& mesh_;
  PathPoints points_;
  const std::function<double(int vertex)>& distanceAt_;
  double bound_ = kInfinity;  ///< the distance at the last vertex of the path
};

}  // namespace

std::vector<SurfacePoint> pathByUnfolding(const TriangleMesh& mesh, const SurfacePoint& site,
                                          const std::function<double(int vertex)>& distanceAt,
                                          const SurfacePoint& p) {
  return UnfoldingPath(mesh, site, distanceAt).from(p);
}

}  // namespace gvd::dgpc
