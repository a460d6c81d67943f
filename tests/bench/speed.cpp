// SPDX-License-Identifier: MIT
#include "speed.h"

#include "dijkstra.h"
#include "gvd/diagram.h"
#include "memory.h"
#include "metrics.h"
#include "timing.h"

namespace gvd::bench {

double dijkstraSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                       const SpeedOptions& options) {
  return timed(options.runs, [&] { return dijkstra(mesh, sites); }).seconds;
}

Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                   const SpeedOptions& options) {
  const MemoryWatch memory;
  const auto field = timed(options.runs, [&] { return distances(mesh, sites, metric); });
  const int siteCount = static_cast<int>(sites.size());
  const auto diagram = timed(options.runs, [&] {
    return traceDiagram(mesh, *field.result, siteCount, {.detail = options.detail});
  });
  return {field.seconds, diagram.seconds, static_cast<double>(memory.peak())};
}

}  // namespace gvd::bench
