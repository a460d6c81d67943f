// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

// A face laid out in the plane. Side i runs from corner i to the next one. The coordinates of side
// i: the origin is corner i, the x axis runs along the side, the face lies at y >= 0.

/// The corner across from side i, its *apex*, in the coordinates of that side.
inline Eigen::Vector2d apexOf(const TriangleMesh::Face& face, int i) {
  return face.lengths[cornerBefore(i)] * Eigen::Vector2d(face.cosines[i], face.sines[i]);
}

/// A point in the coordinates of side i. Linear, so it also takes differences of points.
inline Eigen::Vector2d layOut(const TriangleMesh::Face& face, int i, const Eigen::Vector3d& bary) {
  const Eigen::Vector2d alongSide(bary[cornerAfter(i)] * face.lengths[i], 0);
  return alongSide + bary[cornerBefore(i)] * apexOf(face, i);
}

/// The vector from a point to a corner, in the coordinates of side i: from the point's shares of
/// the two other corners, so that it is as precise beside the corner as far from it.
inline Eigen::Vector2d wayToCorner(const TriangleMesh::Face& face, int i,
                                   const Eigen::Vector3d& bary, int corner) {
  Eigen::Vector3d way = -bary;
  way[corner] = bary[cornerAfter(corner)] + bary[cornerBefore(corner)];
  return layOut(face, i, way);
}

/// The distance from a point to a corner. All callers must use this one formula: in a thin face
/// another one would round differently, and an edge bound below the label's distance would keep
/// every label from the vertex.
inline double distanceToCorner(const TriangleMesh::Face& face, const Eigen::Vector3d& bary,
                               int corner) {
  return wayToCorner(face, 0, bary, corner).norm();
}

}  // namespace gvd
