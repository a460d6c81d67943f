// SPDX-License-Identifier: MIT
//
// Mass and first moment of each region, and the energy: a tessellation computes its steps from
// them.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Integrals over the region of one site.
struct RegionMoments {
  double mass = 0;  ///< ∫ ρ
  /// ∫ ρ u, where u is the logarithmic map: the vector of length d along which the shortest path to
  /// a point leaves the site, in the frame of the site's face.
  Eigen::Vector2d moment = {0, 0};
};

struct CvtEnergy {
  double energy = 0;               ///< Σ ∫ ρ d²
  std::vector<double> faceEnergy;  ///< per mesh face, sums to the energy
  std::vector<RegionMoments> regions;
};

/// Integrates over the regions of a diagram traced with detail 0 from these distances. The density
/// ρ is given per vertex and linear in between; if empty, it is 1. All integrals are exact for d² =
/// Σ bᵢ Uᵢ² - Σ bᵢ bⱼ |eᵢⱼ|² and u = Σ bᵢ Uᵢ (cos θᵢ, sin θᵢ), where U and θ are the polar
/// coordinates of the corners; in the site's own face, these are |p - s|² and p - s. Then -2 ∫ ρ u
/// is the exact gradient of the energy wherever the energy has one: a moving bisector has the same
/// d² on both sides, so its motion contributes nothing, and ∂(U²)/∂s = -2 U (cos θ, sin θ). O(F).
/// All must outlive the work.
std::unique_ptr<SlicedWork<CvtEnergy>> startCvtEnergy(const TriangleMesh& mesh,
                                                      const DistanceField& distances,
                                                      const Diagram& diagram,
                                                      std::span<const double> density);

}  // namespace gvd
