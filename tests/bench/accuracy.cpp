// SPDX-License-Identifier: MIT
#include "accuracy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#ifdef GVD_HAS_ORACLE
#include "oracle.h"
#endif

namespace gvd::bench {

Score score(const DistanceField& field, std::span<const SurfacePoint> points,
            std::span<const TrueNearest> truth) {
  Score result;
  double errors = 0;
  int distances = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const LabelledDistance found = field.nearest(points[i]);
    const TrueNearest& expected = truth[i];
    if (expected.second - expected.distance >= kTie * expected.second || expected.label < 0) {
      ++result.points;
      result.mislabelled += found.label != expected.label;
    }
    if (expected.label >= 0 && found.label >= 0 && expected.distance > 0) {
      const double error = std::abs(found.distance / expected.distance - 1);
      errors += error;
      result.largestError = std::max(result.largestError, error);
      ++distances;
    }
  }
  if (distances > 0) result.meanError = errors / distances;
  return result;
}

#ifdef GVD_HAS_ORACLE

bool hasOracle() { return true; }

std::vector<TrueNearest> trueNearest(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                     std::span<const SurfacePoint> points) {
  const Oracle oracle(mesh);
  std::vector<TrueNearest> result(points.size());
  for (size_t label = 0; label < sites.size(); ++label) {
    const std::vector<double> distances = oracle.distances(sites[label], points);
    for (size_t i = 0; i < points.size(); ++i) {
      TrueNearest& nearest = result[i];
      if (distances[i] < nearest.distance) {
        nearest.second = std::exchange(nearest.distance, distances[i]);
        nearest.label = static_cast<int>(label);
      } else {
        nearest.second = std::min(nearest.second, distances[i]);
      }
    }
  }
  return result;
}

#else

bool hasOracle() { return false; }

std::vector<TrueNearest> trueNearest(const TriangleMesh&, std::span<const SurfacePoint>,
                                     std::span<const SurfacePoint>) {
  throw std::logic_error("built without CGAL");
}

#endif

}  // namespace gvd::bench
