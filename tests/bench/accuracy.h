// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// The true nearest site of a point, by exact polyhedral distances.
struct TrueNearest {
  int label = -1;  ///< -1: no site reaches the point
  double distance = kInfinity;
  double second = kInfinity;  ///< distance of the second nearest site, if known
};

/// The errors of a distance field.
struct Score {
  int points = 0;        ///< points whose label counts: no second site is as near
  int mislabelled = 0;   ///< of those points
  double meanError = 0;  ///< relative, of the distances of all points that a site reaches
  double largestError = 0;

  double mislabelledShare() const { return points > 0 ? double(mislabelled) / points : 0; }
};

/// Two sites are equally near if their distances differ by less than this, relatively.
inline constexpr double kTie = 1e-6;

Score score(const DistanceField& field, std::span<const SurfacePoint> points,
            std::span<const TrueNearest> truth);

/// Whether `trueNearest` can be called: it needs CGAL.
bool hasOracle();
std::vector<TrueNearest> trueNearest(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                     std::span<const SurfacePoint> points);

}  // namespace gvd::bench
