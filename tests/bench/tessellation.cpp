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

/// How long it takes to compute what one iteration more comes to.
double iterationSeconds(Cvt& cvt) {
  const double start = threadSeconds();
  while (!cvt.step(std::numeric_limits<long>::max()) && !cvt.isDone()) {
  }
  return threadSeconds() - start;
}

double diagramSeconds(const TriangleMesh& mesh, std::span<const SurfacePoint> sites) {
  const double start = threadSeconds();
  const auto field = distances(mesh, sites, Metric::kExact);
  traceDiagram(mesh, *field, static_cast<int>(sites.size()));
  return threadSeconds() - start;
}

}  // namespace

TessellationScore measureTessellation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      std::span<const SurfacePoint> points, CvtMethod method) {
  TessellationScore score{};
  CvtOptions options;
  options.method = method;
  options.iterations = kIterationsShown.back();
  Cvt cvt(mesh, sites, options);
  iterationSeconds(cvt);  // the initial sites
  // A diagram after each iteration: the machine may be faster now and slower then.
  double seconds = 0, secondsOfDiagrams = 0;
  for (size_t i = 0; i < kIterationsShown.size(); ++i) {
    while (!cvt.isDone() && cvt.iteration().number < kIterationsShown[i]) {
      const int before = cvt.iteration().number;
      seconds += iterationSeconds(cvt);
      if (cvt.iteration().number > before) secondsOfDiagrams += diagramSeconds(mesh, cvt.sites());
    }
    score.energy[i] = energyOverHexagons(mesh, cvt.sites(), points);
  }
  score.diagrams = seconds / secondsOfDiagrams;
  return score;
}

}  // namespace gvd::bench
