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

/// How diagrams come closer to the true one as mixed faces are split: the share of the area that
/// they give to another site than the one that is nearest by exact distances.
class DetailStudy {
 public:
  /// Draws points, the same for all diagrams: most of them in faces with several regions.
  DetailStudy(const TriangleMesh& mesh, std::vector<SurfacePoint> sites, std::uint64_t seed);

  /// Entry n is that of the diagram with detail n, from 0 to `most`.
  std::vector<double> mislabelled(Metric metric, int most) const;

 private:
  /// Points uniform in a part of the surface.
  struct Stratum {
    double share;  ///< of the area
    std::vector<SurfacePoint> points;
    std::vector<int> labels;  ///< the true ones
  };
  void addStratum(const DistanceField& truth, std::span<const double> areas, int count,
                  std::uint64_t seed);

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<Stratum> strata_;
};

/// A mesh inscribed in the unit sphere, where distances are known: arcs of great circles. They are
/// what distances on the mesh come closer to as it is refined.
struct SphereCase {
  TriangleMesh mesh;
  std::vector<SurfacePoint> sites;   ///< in the same directions at every refinement
  std::vector<SurfacePoint> points;  ///< uniform by area
  std::vector<TrueNearest> nearest;  ///< of every point
};

/// An icosahedron, every face of which is split in four `subdivisions` times.
SphereCase sphereCase(int subdivisions, int siteCount, int pointCount, std::uint64_t seed);

}  // namespace gvd::bench
