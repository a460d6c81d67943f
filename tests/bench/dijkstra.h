// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// The shortest ways along edges from the nearest of all sites to every vertex, in one sweep: the
/// least that any method has to do, and so the unit that times are given in. From a site to the
/// corners of its face the way is straight.
std::vector<LabelledDistance> dijkstra(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites);

}  // namespace gvd::bench
