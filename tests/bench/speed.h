// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "metrics.h"

namespace gvd::bench {

struct SpeedOptions {
  int runs = 1;
  int detail = 0;
};

/// The cost of one metric: times in seconds, of the fastest run.
struct MetricSpeed {
  NamedMetric metric;
  double distances = kInfinity;  ///< from `propagate` to `take`
  double diagram = kInfinity;    ///< `traceDiagram`
  double partition = kInfinity;
  /// The mean of up to 100 moves of a site to the next face; none if sites cannot be moved.
  std::optional<double> change;
  double bytes = 0;  ///< peak allocated by distances and diagram
  std::string note;  ///< why there are no times
};

struct Speed {
  double dijkstra = kInfinity;  ///< the unit: see `dijkstra`
  std::vector<MetricSpeed> metrics;
};

/// Alternates Dijkstra and the metrics, `runs` times, so that a temporary slowdown of the machine
/// affects all of them alike, and their ratios hold.
Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                   std::span<const NamedMetric> metrics, const SpeedOptions& options);

}  // namespace gvd::bench
