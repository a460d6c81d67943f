// SPDX-License-Identifier: MIT
#include "speed.h"

#include <algorithm>
#include <exception>

#include "dijkstra.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/partition.h"
#include "memory.h"
#include "timing.h"

namespace gvd::bench {
namespace {

/// A place in the next face; in the same one if no face lies beside it.
SurfacePoint besides(const TriangleMesh& mesh, const SurfacePoint& site) {
  int h = 3 * site.face;
  while (mesh.twin(h) < 0 && h < 3 * site.face + 2) ++h;
  const int face = mesh.twin(h) < 0 ? site.face : TriangleMesh::faceOf(mesh.twin(h));
  return {face, Eigen::Vector3d(0.3, 0.3, 0.4)};
}

/// The mean time of a move. A run of moves ends after a second: with few sites, each takes as long
/// as a diagram.
double changeSeconds(const TriangleMesh& mesh, DynamicDiagram& live, int runs) {
  constexpr int kMostMoves = 100;
  constexpr double kMostSeconds = 1;
  double least = kInfinity;
  for (int run = 0; run < runs; ++run) {
    const double start = threadSeconds();
    double seconds = 0;
    int moves = 0;
    while (moves < std::min(kMostMoves, live.labelCount()) && seconds < kMostSeconds) {
      live.moveSite(moves, besides(mesh, live.site(moves)));
      ++moves;
      seconds = threadSeconds() - start;
    }
    least = std::min(least, seconds / moves);
  }
  return least;
}

/// Lowers the times of `speed` to those of one run more.
void runOnce(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
             const DiagramOptions& options, MetricSpeed& speed) {
  const MemoryWatch memory;
  const auto field = timed([&] { return distances(mesh, sites, speed.metric.metric); });
  const auto diagram = timed(
      [&] { return traceDiagram(mesh, *field.result, static_cast<int>(sites.size()), options); });
  speed.bytes = static_cast<double>(memory.peak());
  const auto parts = timed([&] { return partition(mesh, diagram.result); });
  speed.distances = std::min(speed.distances, field.seconds);
  speed.diagram = std::min(speed.diagram, diagram.seconds);
  speed.partition = std::min(speed.partition, parts.seconds);
}

/// What fails says so, and the rest goes on.
template <class Work>
void unlessItFails(MetricSpeed& speed, Work work) {
  if (!speed.note.empty()) return;
  try {
    work();
  } catch (const std::exception& error) {
    speed.note = error.what();
  }
}

}  // namespace

Speed measureSpeed(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                   std::span<const NamedMetric> metrics, const SpeedOptions& options) {
  const DiagramOptions diagramOptions{.detail = options.detail};
  Speed speed;
  for (const NamedMetric& metric : metrics) speed.metrics.emplace_back().metric = metric;
  for (int run = 0; run < options.runs; ++run) {
    for (MetricSpeed& metric : speed.metrics) {
      // Twice: the first one finds the caches full of a diagram, and what is to be a unit should
      // not depend on what was measured before it.
      for (int i = 0; i < 2; ++i) {
        const auto unit = timed([&] { return dijkstra(mesh, sites); });
        speed.dijkstra = std::min(speed.dijkstra, unit.seconds);
      }
      unlessItFails(metric, [&] { runOnce(mesh, sites, diagramOptions, metric); });
    }
  }
  // Afterwards: a dynamic diagram keeps more than a diagram, which is none of the others' business.
  for (MetricSpeed& metric : speed.metrics) {
    unlessItFails(metric, [&] {
      DynamicDiagram live(mesh, sites, metric.metric.metric, diagramOptions);
      metric.change = changeSeconds(mesh, live, options.runs);
    });
  }
  return speed;
}

}  // namespace gvd::bench
