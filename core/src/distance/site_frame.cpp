// SPDX-License-Identifier: MIT
#include "distance/site_frame.h"

#include <cmath>
#include <numbers>

#include "base/plane.h"
#include "mesh/surface_geometry.h"

namespace gvd {

using Eigen::Vector2d;

Vector2d firstSide(const TriangleMesh& mesh, int face, int i) {
  const TriangleMesh::Layout& l = mesh.layout(3 * face + i);
  const double inverse = 2 * mesh.layout(3 * face).inverse;
  if (i == 1) return Vector2d(-l.x, -l.y) * inverse;
  if (i == 2) return Vector2d(l.x - l.length, l.y) * inverse;
  return {1, 0};
}

double angleOfOutgoing(const TriangleMesh& mesh, const SurfacePoint& site, int halfedge) {
  const int vertex = mesh.tail(halfedge);
  int corner = 0;
  double angle = 0;
  while (mesh.tail(3 * site.face + corner) != vertex)
    angle += std::numbers::pi - mesh.cornerAngle(3 * site.face + ++corner);
  // From the vertex's first halfedge, on which the angles of all faces there are counted, back to
  // the site's face, and on to the one asked for.
  int h = mesh.outgoing(vertex);
  for (; TriangleMesh::faceOf(h) != site.face; h = mesh.rotate(h)) angle -= mesh.cornerAngle(h);
  for (h = mesh.outgoing(vertex); h != halfedge; h = mesh.rotate(h)) angle += mesh.cornerAngle(h);
  return angle;
}

Vector2d inSiteFrame(const TriangleMesh& mesh, const SurfacePoint& site, int halfedge,
                     const Vector2d& direction) {
  if (!(direction.squaredNorm() > 0)) return {1, 0};
  if (vertexAt(mesh, site) < 0)
    return turnedBackBy(direction, firstSide(mesh, site.face, halfedge % 3)).normalized();
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  const Vector2d toTail(-l.x, -l.y);
  return unitVector(angleOfOutgoing(mesh, site, TriangleMesh::previous(halfedge)) +
                    std::atan2(cross(toTail, direction), toTail.dot(direction)));
}

}  // namespace gvd
