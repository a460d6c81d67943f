// SPDX-License-Identifier: MIT
//
// Validation of densities that are given per vertex.
#pragma once

#include <cmath>
#include <span>
#include <string>

#include "base/number_text.h"
#include "gvd/error.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` unless there is one density per vertex of the mesh, finite and
/// not negative.
inline void validateDensity(const TriangleMesh& mesh, std::span<const double> density) {
  const auto fail = [](const std::string& what) { throw Error(ErrorCode::kInvalidArgument, what); };
  const size_t vertices = mesh.vertexCount();
  if (density.size() != vertices)
    fail("there are " + std::to_string(density.size()) + " densities for " +
         std::to_string(vertices) + " vertices");
  for (size_t v = 0; v < vertices; ++v)
    if (!(density[v] >= 0 && std::isfinite(density[v])))
      fail("the density at vertex " + std::to_string(v) + " is " + numberText(density[v]));
}

}  // namespace gvd
