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
  // From the vertex's first halfedge, on which the angles of all faces there are counted, back to
  // the site's face, and on to the one asked for.
  int h = mesh.outgoing(vertex);
  for (; TriangleMesh::faceOf(h) != site.face; h = mesh.rotate(h)) angle -= mesh.cornerAngle(h);
  for (h = mesh.outgoing(vertex); h != halfedge; h = mesh.rotate(h)) angle += mesh.cornerAngle(h);
  return angle;
}

}  // namespace gvd
