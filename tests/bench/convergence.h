// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accuracy.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// How diagrams converge as mixed faces are split: measures the share of the area that they give to
/// a site other than the nearest by exact distances.
class DetailStudy {
 public:
  /// Draws the points, most of them in mixed faces; all diagrams are measured at the same points.
  DetailStudy(const TriangleMesh& mesh, std::vector<SurfacePoint> sites, std::uint64_t seed);

  /// The mislabelled share of the area; entry n is of the diagram with detail n, from 0 to `most`.
  std::vector<double> mislabelled(Metric metric, int most) const;

 private:
  /// Uniform points in a part of the surface.
  struct Stratum {
    double share;  ///< of the area
    std::vector<SurfacePoint> points;
    std::vector<int> labels;  ///< true labels
  };
  void addStratum(const DistanceField& truth, std::span<const double> areas, int count,
                  std::uint64_t seed);

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<Stratum> strata_;
};

/// A mesh inscribed in the unit sphere. The true distances are arcs of great circles, to which
/// distances on the mesh converge as it is refined.
struct SphereCase {
  TriangleMesh mesh;
  std::vector<SurfacePoint> sites;   ///< in the same directions at every refinement
  std::vector<SurfacePoint> points;  ///< uniform by area
  std::vector<TrueNearest> nearest;  ///< of every point
};

/// An icosahedron whose faces are split in four `subdivisions` times.
SphereCase sphereCase(int subdivisions, int siteCount, int pointCount, std::uint64_t seed);

}  // namespace gvd::bench
