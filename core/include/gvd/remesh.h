// SPDX-License-Identifier: MIT
/// \file
/// How good the dual of a tessellation is as a remesh of the surface.
#pragma once

#include <memory>

#include "gvd/polygon_mesh.h"
#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// How good a remesh is. The triangles are those that `triangulate` makes of its polygons.
struct RemeshQuality {
  int triangles = 0;
  /// Least angle of all triangles, and the mean of each one's least angle, in degrees: 60 at best.
  double minAngle = 0, meanMinAngle = 0;
  /// The least and largest number of neighbours of an inner vertex: 6 at best. Zero if there is
  /// none.
  int minValence = 0, maxValence = 0;
  double regularShare = 0;  ///< the share of inner vertices with 6 neighbours
  /// The largest distance of a point of one surface from the other, both ways, in the mesh's units.
  double hausdorff = 0;
};

/// Measures `remesh`, which must be a manifold, against the surface that it was made of. Without
/// triangles it has the default values, and an infinite distance.
///
/// The distance is measured at samples, so it is never more than the true one: at the vertices and
/// the centres of the faces of the surface, and at points of the remesh that are about as dense.
/// O(n log n) for n faces and samples.
RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh);

/// The same in steps, including making the remesh. The surface must outlive the work.
std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing);

}  // namespace gvd
