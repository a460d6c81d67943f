// SPDX-License-Identifier: MIT
#include "speed.h"

#include <algorithm>

#include "dijkstra.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/partition.h"
#include "memory.h"
#include "metrics.h"
#include "timing.h"

namespace gvd::bench {

double dijkstraSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                       const SpeedOptions& options) {
  return timed(options.runs, [&] { return dijkstra(mesh, sites); }).seconds;
}

namespace {

/// The time that a site takes to move into the face beside its own, on average.
double changeSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const SpeedOptions& options) {
  DynamicDiagram dynamic(mesh, sites, {.detail = options.detail});
  const int moves = std::min(100, static_cast<int>(sites.size()));
  const auto all = timed(options.runs, [&] {
    for (int label = 0; label < moves; ++label) {
      const int face = dynamic.site(label).face;
      int h = 3 * face;
      while (mesh.twin(h) < 0 && h < 3 * face + 2) ++h;
      const int beside = mesh.twin(h) < 0 ? face : TriangleMesh::faceOf(mesh.twin(h));
      dynamic.moveSite(label, {beside, Eigen::Vector3d(0.3, 0.3, 0.4)});
    }
    return 0;
  });
  return all.seconds / moves;
}

}  // namespace

Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                   const SpeedOptions& options) {
  const MemoryWatch memory;
  const auto field = timed(options.runs, [&] { return distances(mesh, sites, metric); });
  const int siteCount = static_cast<int>(sites.size());
  const auto diagram = timed(options.runs, [&] {
    return traceDiagram(mesh, *field.result, siteCount, {.detail = options.detail});
  });
  const auto bytes = static_cast<double>(memory.peak());
  const auto parts = timed(options.runs, [&] { return partition(mesh, diagram.result); });
  const double change = metric == Metric::kDgpc ? changeSeconds(mesh, sites, options) : 0;
  return {field.seconds, diagram.seconds, parts.seconds, change, bytes};
}

}  // namespace gvd::bench
