// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd {

// Points and pieces of paths along the surface, for both metrics.

/// A point of a halfedge, so far from its tail, named in the halfedge's face. A point closer to an
/// end than `kVertexSnap` is placed on the vertex.
SurfacePoint pointOnHalfedge(const TriangleMesh& mesh, int halfedge, double along);

/// The length of the straight piece between two points of one face; infinity if no face has both.
double lengthBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

/// A path to a site, or a new search for the shortest one if the path is longer than `most`, or
/// none.
std::vector<SurfacePoint> pathOrShortest(const TriangleMesh& mesh, std::vector<SurfacePoint> path,
                                         double most, const SurfacePoint& from,
                                         const SurfacePoint& site);

/// An upper bound on the distance of a point: the length of the shortest path over a corner of the
/// face that it is given in. `distanceAt(vertex)` is the distance of a corner.
template <class DistanceAt>
double distanceOverCorners(const TriangleMesh& mesh, const SurfacePoint& p, DistanceAt distanceAt) {
  const TriangleMesh::Face& face = mesh.face(p.face);
  double least = kInfinity;
  for (int i = 0; i < 3; ++i)
    least = std::min(least, distanceAt(face.vertices[i]) + distanceToCorner(face, p.bary, i));
  return least;
}

/// A corner of the faces that have a point, and the length of the path from the point over it.
struct CornerOnPath {
  int vertex = -1;
  SurfacePoint corner;
  double length = kInfinity;
};

/// The corner over which the path from a point to a site is shortest, among vertices nearer to the
/// site than `bound`; vertex -1 if there is none. `distanceAt(vertex)` is the site's distance.
template <class DistanceAt>
CornerOnPath bestCorner(const TriangleMesh& mesh, const SurfacePoint& p, double bound,
                        DistanceAt distanceAt) {
  CornerOnPath best;
  visitCornersAround(mesh, p, [&](int vertex, double way, const SurfacePoint& corner) {
    const double length = distanceAt(vertex) + way;
    if (distanceAt(vertex) < bound && length < best.length) best = {vertex, corner, length};
  });
  return best;
}

/// Collects the points of a path that ends at a site. A point at the same place as the previous one
/// is left out.
class PathPoints {
 public:
  PathPoints(const TriangleMesh& mesh, SurfacePoint site) : mesh_(mesh), site_(std::move(site)) {}

  void add(const SurfacePoint& p);
  const SurfacePoint& last() const { return points_.back(); }
  /// Ends the path at the site if the last point and the site share a face: the straight line in it
  /// is the shortest way.
  bool endAtSite();
  /// Whether a point and the site have a face in common.
  bool isBesideSite(const SurfacePoint& p) const;

  size_t size() const { return points_.size(); }
  /// Takes back all points but the first ones.
  void shrinkTo(size_t size) { points_.resize(size); }
  std::vector<SurfacePoint> take() { return std::move(points_); }

 private:
  const TriangleMesh& mesh_;
  const SurfacePoint site_;
  std::vector<SurfacePoint> points_;
};

}  // namespace gvd
