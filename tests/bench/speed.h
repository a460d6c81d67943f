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

/// What one metric takes: times in seconds, of the fastest run.
struct MetricSpeed {
  NamedMetric metric;
  double distances = kInfinity;  ///< from `propagate` to `take`
  double diagram = kInfinity;    ///< `traceDiagram`
  double partition = kInfinity;
  /// A site that moves to the next face, the mean of up to 100; none where sites can't be moved.
  std::optional<double> change;
  double bytes = 0;  ///< the most that distances and diagram have allocated at a time
  std::string note;  ///< why there are no times
};

struct Speed {
  double dijkstra = kInfinity;  ///< the unit: see `dijkstra`
  std::vector<MetricSpeed> metrics;
};

/// Takes turns: Dijkstra, one metric, Dijkstra, the other, and so on, `runs` times. So a machine
/// that is slower for a while is slower for all of them, and their ratios hold.
Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                   std::span<const NamedMetric> metrics, const SpeedOptions& options);

}  // namespace gvd::bench
