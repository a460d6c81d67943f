// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

// Directions at a site are told in the site's frame (DistanceField::direction): the x axis is the
// first side of its face, and around a vertex the faces are unfolded counterclockwise.

/// The first side of a face, a unit vector in the frame of its side i (TriangleMesh::Layout).
Eigen::Vector2d firstSide(const TriangleMesh& mesh, int face, int i);

/// The angle of a halfedge that leaves the vertex a site lies on.
double angleOfOutgoing(const TriangleMesh& mesh, const SurfacePoint& site, int halfedge);

}  // namespace gvd
