// SPDX-License-Identifier: MIT
#include "dgpc_view.h"

#include <cmath>
#include <numbers>

#include "surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// The direction of the first side of a face in the frame of its side i.
Vector2d firstSide(const TriangleMesh& mesh, int face, int i) {
  const TriangleMesh::Layout& l = mesh.layout(3 * face + i);
  const double inverse = 2 * mesh.layout(3 * face).inverse;
  if (i == 1) return Vector2d(-l.x, -l.y) * inverse;
  if (i == 2) return Vector2d(l.x - l.length, l.y) * inverse;
  return {1, 0};
}

}  // namespace

View View::inFrame(int otherHalfedge, const Vector2d& origin, const Vector2d& axis) const {
  View other;
  other.source = turned(source - origin, axis);
  other.left = turned(left, axis);
  other.right = turned(right, axis);
  other.heading = isBent ? heading : turned(heading, axis);
  other.offset = offset;
  other.halfedge = otherHalfedge;
  other.isBent = isBent;
  return other;
}

bool limitsViews(const TriangleMesh& mesh, int vertex) {
  constexpr double kFlat = 2 * std::numbers::pi * (1 + 1e-12);  // of the sum of rounded angles
  return mesh.onBoundary(vertex) || mesh.angleSum(vertex) > kFlat;
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

double angleOfFirstSpoke(const TriangleMesh& mesh, const SurfacePoint& site, int vertex) {
  int corner = 0;
  double angle = 0;
  while (mesh.tail(3 * site.face + corner) != vertex)
    angle += std::numbers::pi - mesh.cornerAngle(3 * site.face + ++corner);
  for (int h = mesh.outgoing(vertex); TriangleMesh::faceOf(h) != site.face; h = mesh.rotate(h))
    angle -= mesh.cornerAngle(h);
  return angle;
}

View viewAlong(const TriangleMesh& mesh, const Spoke& spoke, double angleOfFirst) {
  const double angle = angleOfFirst + spoke.angle;
  View view = viewFromBend(mesh, spoke.halfedge, spoke.isFromTail, 0, {1, 0});
  view.isBent = false;
  view.heading = turned(view.path(mesh) / spoke.length, {std::cos(angle), std::sin(angle)});
  return view;
}

View viewFromBend(const TriangleMesh& mesh, int halfedge, bool isFromTail, double offset,
                  const Vector2d& departure) {
  View view;
  if (!isFromTail) view.source = {mesh.length(halfedge), 0};
  view.heading = departure;
  view.offset = offset;
  view.halfedge = halfedge;
  view.isBent = true;
  return view;
}

}  // namespace gvd
