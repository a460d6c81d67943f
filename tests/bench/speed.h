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

/// What one metric takes.
struct Speed {
  double distances;  ///< seconds from `propagate` to `take`
  double diagram;    ///< seconds of `traceDiagram`
  double partition;  ///< seconds of `partition`
  double change;  ///< seconds for one site that moves to the next face, on average; 0 if it cannot
  double bytes;  ///< the most that distances and diagram have allocated at a time, besides the mesh
};
Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                   const SpeedOptions& options);

}  // namespace gvd::bench
