// SPDX-License-Identifier: MIT
#include "tessellation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gvd/diagram.h"
#include "metrics.h"
#include "timing.h"

namespace gvd::bench {
namespace {

/// As a multiple of the energy of regular hexagons in the plane, of the same number and area:
/// A²/k · 5/(18√3). On a curved surface it may be less than 1.
double energyOverHexagons(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                          std::span<const SurfacePoint> points) {
  const auto field = distances(mesh, sites, Metric::kExact);
  double sum = 0;
  int reached = 0;
  for (const SurfacePoint& p : points) {
    const double distance = field->nearest(p).distance;
    if (distance == kInfinity) continue;
    sum += distance * distance;
    ++reached;
  }
  const double hexagons = mesh.area() / static_cast<double>(sites.size()) * 5 / (18 * std::sqrt(3));
  return sum / reached / hexagons;
}

double diagramSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites) {
  constexpr int kRuns = 3;
  return timed(kRuns,
               [&] {
                 const auto field = distances(mesh, sites, Metric::kDgpc);
                 return traceDiagram(mesh, *field, static_cast<int>(sites.size()));
               })
      .seconds;
}

}  // namespace

TessellationScore measureTessellation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      std::span<const SurfacePoint> points, CvtMethod method) {
  TessellationScore score{};
  CvtOptions options;
  options.method = method;
  options.iterations = kIterationsShown.back();
  Cvt cvt(mesh, sites, options);
  double seconds = 0;
  for (size_t i = 0; i < kIterationsShown.size(); ++i) {
    const double start = threadSeconds();
    bool isReached = false;
    while (!cvt.isDone() && !isReached)
      isReached = cvt.step(std::numeric_limits<long>::max()) &&
                  cvt.iteration().number >= kIterationsShown[i];
    if (i > 0) seconds += threadSeconds() - start;
    score.energy[i] = energyOverHexagons(mesh, cvt.sites(), points);
  }
  score.diagrams =
      seconds / std::max(1, cvt.iteration().number) / diagramSeconds(mesh, cvt.sites());
  return score;
}

}  // namespace gvd::bench
