// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "gvd/cvt.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// The quality of centroidal tessellations, and its cost.
struct TessellationScore {
  /// The energy ∫ d², with d the exact distance, after 0, 10 and 50 iterations (or at the end, if
  /// there are fewer), as multiples of that of hexagons.
  std::array<double, 3> energy;
  double diagrams;  ///< time per iteration, rejected trials included, in diagrams
};
inline constexpr std::array<int, 3> kIterationsShown = {0, 10, 50};

/// `points` are uniform by area, so that the integral is the mean over them.
TessellationScore measureTessellation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      std::span<const SurfacePoint> points, CvtMethod method);

}  // namespace gvd::bench
