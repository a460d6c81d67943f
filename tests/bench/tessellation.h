// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "gvd/cvt.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// How good centroidal tessellations become, and what that takes.
struct TessellationScore {
  /// The energy ∫ d², d the exact distance, after 0, 10 and 50 iterations (or when there are no
  /// more), as multiples of the hexagonal one.
  std::array<double, 3> energy;
  double diagrams;  ///< time of an iteration, of what ends in vain too, in diagrams
};
inline constexpr std::array<int, 3> kIterationsShown = {0, 10, 50};

/// `points` are uniform by area: the integral is their mean.
TessellationScore measureTessellation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      std::span<const SurfacePoint> points, CvtMethod method);

}  // namespace gvd::bench
