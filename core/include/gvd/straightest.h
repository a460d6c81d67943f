// SPDX-License-Identifier: MIT
/// \file
/// Walks straight ahead on a surface: the exponential map, by which tessellations move their sites.
#pragma once

#include <Eigen/Core>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// What a straightest geodesic does where it meets the mesh boundary.
enum class AtBoundary {
  kStop,   ///< it ends there
  kSlide,  ///< it goes on along the boundary, shortened to its component in that direction; where
           ///< the boundary turns away, it leaves the boundary again
};

/// The end of a straightest geodesic.
struct StraightestGeodesic {
  SurfacePoint end;
  /// The x axis of the start, carried along the geodesic in parallel, in the frame of the end: a
  /// unit vector. A tangent vector (a, b) at the start is a · frame + b · (frame turned left by
  /// 90°) at the end.
  Eigen::Vector2d frame = {1, 0};
  double length = 0;         ///< the length walked, less than asked for if stopped at a boundary
  bool metBoundary = false;  ///< whether it has been stopped or turned there
};

/// The exponential map: walks from `start` straight on by the vector `move`, in the mesh's units.
/// The frame of a point is that of its face: the x axis is the first side of the face, the y axis
/// lies to its left (as for `DistanceField::direction`). Around a start on an edge or vertex, faces
/// are unfolded counterclockwise; around a vertex, beginning with `TriangleMesh::outgoing`. Where
/// the angles around a vertex add up to less than 2π, a direction in the gap leaves along
/// `outgoing`; where they add up to more, the directions beyond 2π cannot be named.
///
/// Through a face and across an edge the geodesic is a straight line; at an inner vertex it leaves
/// equal angles on both sides, whatever the angle sum, and the frame keeps its angle to it. A
/// geodesic that passes a vertex closer than 1e-12 of an edge hits it, and one that starts on an
/// edge at an angle below 1e-12 to it runs along it. A move whose squared length is zero or not
/// finite stays at the start. Throws `Error(kInvalidPoint)` if the start is not on the mesh.
///
/// O(faces crossed). It ends early if rounding keeps it in place, and after 65536 crossings plus 16
/// per halfedge of the mesh, as when winding around a spike.
/// Source: Konrad Polthier, Markus Schmies. Straightest Geodesics on Polyhedral Surfaces. 1998.
StraightestGeodesic walkStraight(const TriangleMesh& mesh, const SurfacePoint& start,
                                 const Eigen::Vector2d& move,
                                 AtBoundary atBoundary = AtBoundary::kStop);

}  // namespace gvd
