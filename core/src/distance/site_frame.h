// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

// Directions at a site are given in the site's frame (DistanceField::direction): the x axis is the
// first side of its face, and around a vertex the faces are unfolded counterclockwise.

/// The unit vector along the first side of a face, in the coordinates of its side i
/// (`face_layout.h`).
Eigen::Vector2d firstSide(const TriangleMesh& mesh, int face, int i);

/// The angle of a halfedge that leaves the vertex a site lies on.
double angleOfOutgoing(const TriangleMesh& mesh, const SurfacePoint& site, int halfedge);

}  // namespace gvd
