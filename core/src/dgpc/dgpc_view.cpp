// SPDX-License-Identifier: MIT
#include "dgpc/dgpc_view.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "distance/site_frame.h"
#include "mesh/surface_geometry.h"

namespace gvd {
using Eigen::Vector2d;
namespace {

/// How the apex of a halfedge's face sees an end of the halfedge.
View viewOfEnd(const TriangleMesh& mesh, int halfedge, bool isTail) {
  View view;
  if (!isTail) view.source = {mesh.length(halfedge), 0};
  view.halfedge = halfedge;
  return view;
}

}  // namespace

View View::inFrame(int otherHalfedge, const Vector2d& origin, const Vector2d& axis) const {
  View other;
  other.source = turnedBackBy(source - origin, axis);
  other.left = turnedBackBy(left, axis);
  other.right = turnedBackBy(right, axis);
  other.heading = isBent() ? heading : turnedBackBy(heading, axis);
  other.toSite = isBent() ? turnedBackBy(toSite, axis) : toSite;
  other.offset = offset;
  other.halfedge = otherHalfedge;
  other.detour = detour;
  return other;
}

bool castsShadow(const TriangleMesh& mesh, int vertex) {
  constexpr double kSharp = 0.2;  // radians
  const double straight = (mesh.onBoundary(vertex) ? 1 : 2) * std::numbers::pi;
  return mesh.angleSum(vertex) > straight + kSharp;
}

double distanceOfCorner(const TriangleMesh& mesh, const SurfacePoint& site, int corner) {
  return std::sqrt(
      squaredDistance(site.bary, Eigen::Vector3d::Unit(corner), squaredSides(mesh, site.face)));
}

View viewOfCorner(const TriangleMesh& mesh, const SurfacePoint& site, int corner) {
  const int i = (corner + 1) % 3, h = 3 * site.face + i;
  const TriangleMesh::Layout& l = mesh.layout(h);
  const double toTip = site.bary[(corner + 2) % 3], toApex = site.bary[corner];
  View view;
  view.source = {toTip * l.length + toApex * l.x, toApex * l.y};
  view.heading = firstSide(mesh, site.face, i);
  view.halfedge = h;
  return view;
}

View viewAlong(const TriangleMesh& mesh, const Spoke& spoke, double angleOfFirst) {
  const double angle = angleOfFirst + spoke.angle;
  View view = viewOfEnd(mesh, spoke.halfedge, spoke.isFromTail);
  view.heading = turnedBackBy(view.path(mesh) / spoke.length, unitVector(angle));
  return view;
}

View viewOverEnd(const TriangleMesh& mesh, int halfedge, bool isFromTail, double offset,
                 const Vector2d& departure) {
  View view = viewOfEnd(mesh, halfedge, isFromTail);
  view.heading = departure;
  view.offset = offset;
  view.detour = std::numeric_limits<float>::infinity();
  return view;
}

}  // namespace gvd
