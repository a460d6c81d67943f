// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// The shortest paths along edges from the nearest of all sites to every vertex, in one sweep. No
/// method does less, so times are given in units of this. From a site to the corners of its face,
/// paths are straight.
std::vector<LabelledDistance> dijkstra(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites);

}  // namespace gvd::bench
