// SPDX-License-Identifier: MIT
#include "distance/site_frame.h"

#include <numbers>

#include "mesh/face_layout.h"

namespace gvd {

using Eigen::Vector2d;

Vector2d firstSide(const TriangleMesh& mesh, int face, int i) {
  const TriangleMesh::Face& f = mesh.face(face);
  if (i == 1) return -apexOf(f, i) / f.lengths[0];
  if (i == 2) return (apexOf(f, i) - Vector2d(f.lengths[i], 0)) / f.lengths[0];
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
