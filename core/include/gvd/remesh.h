// SPDX-License-Identifier: MIT
#pragma once

#include "gvd/polygon_mesh.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// How good a remesh is: of the triangles of a polygon mesh (`triangulate`).
struct RemeshQuality {
  int triangles = 0;
  /// Least angle of all triangles, and the mean of each one's least angle, in degrees: 60 at best.
  double minAngle = 0, meanMinAngle = 0;
  /// The number of neighbours of a vertex, of those inside: 6 at best. Zero if none is inside.
  int minValence = 0, maxValence = 0;
  double regularShare = 0;  ///< of the vertices inside, those with 6 neighbours
  /// The largest distance of a point of one surface from the other, both ways, in the mesh's units.
  double hausdorff = 0;
};

/// `remesh` is a manifold; one without triangles has the quality of the default values, but an
/// infinite distance.
///
/// The distance is that of samples, so never more than the true one: the vertices and the middles
/// of the faces of the surface, and points of the remesh about as dense. O(n log n) for n faces,
/// and as many samples.
RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh);

}  // namespace gvd
