// SPDX-License-Identifier: MIT
#include "distance/site_frame.h"

#include <numbers>

namespace gvd {

using Eigen::Vector2d;

Vector2d firstSide(const TriangleMesh& mesh, int face, int i) {
  const TriangleMesh::Layout l = mesh.layout(3 * face + i);
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
  // Angles around the vertex are counted from its first halfedge: subtract those up to the site's
  // face, then add those up to `halfedge`.
  int h = mesh.outgoing(vertex);
  for (; TriangleMesh::faceOf(h) != site.face; h = mesh.rotate(h)) angle -= mesh.cornerAngle(h);
  for (h = mesh.outgoing(vertex); h != halfedge; h = mesh.rotate(h)) angle += mesh.cornerAngle(h);
  return angle;
}

}  // namespace gvd
