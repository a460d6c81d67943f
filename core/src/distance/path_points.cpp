// SPDX-License-Identifier: MIT
#include "distance/path_points.h"

#include <algorithm>

#include "base/tolerances.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd {

SurfacePoint pointOnHalfedge(const TriangleMesh& mesh, int halfedge, double along) {
  const int i = halfedge % 3;
  double share = along / mesh.length(halfedge);
  if (!(share > kVertexSnap)) share = 0;
  if (!(share < 1 - kVertexSnap)) share = 1;
  SurfacePoint p{TriangleMesh::faceOf(halfedge), Eigen::Vector3d::Zero()};
  p.bary[i] = 1 - share;
  p.bary[cornerAfter(i)] = share;
  return p;
}

double lengthBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  double least = kInfinity;
  visitRepresentations(mesh, a, [&](const SurfacePoint& from) {
    if (const auto to = pointInFace(mesh, b, from.face))
      least = std::min(least, layOut(mesh.face(from.face), 0, to->bary - from.bary).norm());
  });
  return least;
}

std::vector<SurfacePoint> pathOrShortest(const TriangleMesh& mesh, std::vector<SurfacePoint> path,
                                         double most, const SurfacePoint& from,
                                         const SurfacePoint& site) {
  if (!path.empty() && lengthOf(mesh, path) <= most) return path;
  return shortestPath(mesh, from, site);
}

void PathPoints::add(const SurfacePoint& p) {
  if (points_.empty() || lengthBetween(mesh_, points_.back(), p) > 0) points_.push_back(p);
}

bool PathPoints::endAtSite() {
  if (!isBesideSite(last())) return false;
  // The path ends with the site as given, not with a point at the same place named in another face.
  if (points_.size() > 1 && lengthBetween(mesh_, last(), site_) == 0) points_.pop_back();
  add(site_);
  return true;
}

bool PathPoints::isBesideSite(const SurfacePoint& p) const {
  bool isBeside = false;
  visitRepresentations(mesh_, p, [&](const SurfacePoint& place) {
    isBeside |= pointInFace(mesh_, site_, place.face).has_value();
  });
  return isBeside;
}

}  // namespace gvd
