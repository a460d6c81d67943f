// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::bench {

struct SpeedOptions {
  int runs = 1;
  int detail = 0;
};

/// The time of the unit, in seconds: see `dijkstra`.
double dijkstraSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                       const SpeedOptions& options);

/// Where the time of one metric goes, in seconds.
struct Speed {
  double distances;  ///< `propagate` to `take`
  double diagram;    ///< `traceDiagram`
  double partition;  ///< `partition`
};
Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                   const SpeedOptions& options);

}  // namespace gvd::bench
