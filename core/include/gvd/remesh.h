// SPDX-License-Identifier: MIT
/// \file
/// Remeshing: the valid dual of a centroidal tessellation, and how good it is as a mesh.
#pragma once

#include <memory>
#include <span>

#include "gvd/cvt.h"
#include "gvd/dual.h"
#include "gvd/polygon_mesh.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

struct RemeshOptions {
  CvtOptions tessellation = {};
  int maxAdded = 1000;  ///< how many sites may be added; not negative
};

/// Sites whose dual (`dualMesh`) is an isotropic remesh of the surface, or with a density an
/// adaptive one: tessellates, adds sites until the dual is valid (`repair`), and tessellates again,
/// because the sites just added are not at centroids yet; at most three times. A round that
/// needs more than half as many sites as the one before is undone, and is the last: moving all
/// sites can break the dual in other places, so rounds could add sites for ever. In the end the
/// sites that were added last are settled: they move towards their centroids as long as the dual
/// stays valid and its least angle grows.
///
/// Deterministic. Takes as long as three tessellations, and a few diagrams besides. Throws as `Cvt`
/// and `repair` do, `Error(kTooFewSites)` if the first round needs more than `maxAdded` sites.
RepairedSites remesh(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const RemeshOptions& options = {});
/// The same in steps; the mesh must outlive them.
std::unique_ptr<SlicedWork<RepairedSites>> startRemesh(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       const RemeshOptions& options = {});

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
/// The Hausdorff distance is that of a point, so it is never more than the true one, and at most a
/// hundredth less, unless it is so small that the search for it is ended: after 4096 points and
/// four for each square of the shorter mean edge of the two surfaces. O(n log n) for n triangles
/// and such points. Source: Min Tang, Minkyoung Lee, Young Kim. Interactive Hausdorff Distance
/// Computation for General Polygonal Models. 2009.
RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh);

/// The same in steps, including making the remesh. The surface must outlive the work.
std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing);

}  // namespace gvd
