// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// `count` points of the surface, independent and uniform by area (by face, if all faces have zero
/// area); `face` counts the faces of `mesh`. The same mesh, count and seed give the same points on
/// every platform, and the first n points do not depend on `count`. Throws `Error(kInvalidArgument)`
/// if `count` is negative. O(F + count log F).
std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed);

}  // namespace gvd
