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
  double second = kInfinity;  ///< distance of the second nearest site, if it is known
};

/// How far a field is from the truth.
struct Score {
  int points = 0;        ///< that count for labels: those with two sites as near are left out
  int mislabelled = 0;   ///< of them
  double meanError = 0;  ///< of the distances of all points that a site reaches, relative
  double largestError = 0;

  double mislabelledShare() const { return points > 0 ? double(mislabelled) / points : 0; }
};

/// Two sites are as near as each other if their distances differ by less than this, relatively.
inline constexpr double kTie = 1e-6;

Score score(const DistanceField& field, std::span<const SurfacePoint> points,
            std::span<const TrueNearest> truth);

/// Whether `trueNearest` can be called: it takes CGAL.
bool hasOracle();
std::vector<TrueNearest> trueNearest(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                     std::span<const SurfacePoint> points);

}  // namespace gvd::bench
