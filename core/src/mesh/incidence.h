// SPDX-License-Identifier: MIT
//
// The vertex or edge that a point lies on, and the faces that have it: it can be given in each.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "mesh/face_layout.h"

namespace gvd {

/// The corner or side of its face that a point lies on, -1 if on none; on a corner, no side.
struct Incidence {
  int corner = -1;
  int side = -1;
};

/// By the coordinates that are zero, as `cleanBarycentric` leaves them.
inline Incidence incidenceOf(const Eigen::Vector3d& bary) {
  Incidence incidence;
  for (int i = 0; i < 3; ++i) {
    const bool first = bary[cornerAfter(i)] == 0, second = bary[cornerBefore(i)] == 0;
    if (first && second) return {i, -1};
    if (second) incidence.side = i;
  }
  return incidence;
}

/// The vertex that a point lies on, -1 if on none.
inline int vertexAt(const TriangleMesh& mesh, const SurfacePoint& p) {
  const int corner = incidenceOf(p.bary).corner;
  return corner < 0 ? -1 : mesh.tail(3 * p.face + corner);
}

/// The coordinates of a point in a face. The point may be given in another face that shares the
/// edge or vertex it lies on; what it has of other corners is rounding, and left out.
inline Eigen::Vector3d baryInFace(const TriangleMesh& mesh, const SurfacePoint& p, int face) {
  if (p.face == face) return p.bary;
  const std::array<int, 3>& from = mesh.face(p.face).vertices;
  const std::array<int, 3>& to = mesh.face(face).vertices;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (from[j] == to[i]) bary[i] = p.bary[j];
  const double sum = bary.sum();
  return sum > 0 ? Eigen::Vector3d(bary / sum) : Eigen::Vector3d(Eigen::Vector3d::Unit(0));
}

/// A vertex, given in one of the faces around it.
inline SurfacePoint pointAtVertex(const TriangleMesh& mesh, int vertex) {
  const int h = mesh.outgoing(vertex);
  return {TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

/// A point of halfedge `h`, given in the halfedge's face, in the face of its twin.
inline SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[cornerAfter(h % 3)];
  q.bary[cornerAfter(twin % 3)] = p.bary[h % 3];
  return q;
}

/// Calls `visit` with a point as it is in every face that has it.
template <class Visit>
void visitRepresentations(const TriangleMesh& mesh, const SurfacePoint& p, Visit visit) {
  const Incidence incidence = incidenceOf(p.bary);
  if (incidence.corner >= 0) {
    for (const int h : mesh.fan(mesh.tail(3 * p.face + incidence.corner)))
      visit(SurfacePoint{TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)});
    return;
  }
  visit(p);
  const int h = 3 * p.face + incidence.side;
  if (incidence.side >= 0 && mesh.twin(h) >= 0) visit(acrossEdge(mesh, p, h));
}

/// A point as it is in a face; none if the face does not have it.
inline std::optional<SurfacePoint> pointInFace(const TriangleMesh& mesh, const SurfacePoint& p,
                                               int face) {
  std::optional<SurfacePoint> found;
  if (const int vertex = vertexAt(mesh, p); vertex >= 0) {  // of any number of faces
    for (int i = 0; i < 3; ++i)
      if (mesh.face(face).vertices[i] == vertex) found = {face, Eigen::Vector3d::Unit(i)};
    return found;
  }
  visitRepresentations(mesh, p, [&](const SurfacePoint& place) {
    if (place.face == face) found = place;
  });
  return found;
}

/// Calls visit(vertex, length, corner) with each corner of the faces that have a point: the length
/// of the way to it, and the corner as a point.
template <class Visit>
void visitCornersAround(const TriangleMesh& mesh, const SurfacePoint& p, Visit visit) {
  visitRepresentations(mesh, p, [&](const SurfacePoint& place) {
    const TriangleMesh::Face& face = mesh.face(place.face);
    for (int i = 0; i < 3; ++i)
      visit(face.vertices[i], distanceToCorner(face, place.bary, i),
            SurfacePoint{place.face, Eigen::Vector3d::Unit(i)});
  });
}

}  // namespace gvd
