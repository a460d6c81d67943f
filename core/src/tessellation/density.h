// SPDX-License-Identifier: MIT
//
// Checks densities that are given per vertex.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "base/number_text.h"
#include "base/rejection.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The largest density whose integral with the squared distance does not overflow: no shortest path
/// is longer than all edges together. The rest up to 2^1024 is for constant factors and for sums.
inline double mostDensity(const TriangleMesh& mesh) {
  const double longest = mesh.meanEdgeLength() * mesh.halfedgeCount();
  return 0x1p1000 / (std::max(mesh.area(), 1.0) * std::max(longest * longest, 1.0));
}

/// Throws `Error(kInvalidArgument)` unless there is one density per vertex of the mesh, finite, not
/// negative, and small enough to be integrated.
inline void requireDensity(const TriangleMesh& mesh, std::span<const double> density) {
  const size_t vertices = mesh.vertexCount();
  if (density.size() != vertices)
    rejectArgument("the number of densities is " + std::to_string(density.size()) +
                   ", not that of vertices, " + std::to_string(vertices));
  const double most = mostDensity(mesh);
  for (size_t v = 0; v < vertices; ++v) {
    const bool isFinite = density[v] >= 0 && std::isfinite(density[v]);
    if (isFinite && density[v] <= most) continue;
    rejectArgument("the density at vertex " + std::to_string(v) + " is " + numberText(density[v]) +
                   (isFinite ? ", more than can be integrated on this mesh"
                             : ", not a finite number of 0 or more"));
  }
}

}  // namespace gvd
