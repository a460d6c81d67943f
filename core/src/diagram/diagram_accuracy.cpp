// SPDX-License-Identifier: MIT
//
// How well a diagram keeps to its distances: points are drawn, and their regions compared.

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "diagram/given_diagram.h"
#include "diagram/region_lookup.h"
#include "distance/site_distances.h"
#include "gvd/diagram.h"
#include "mesh/random_points.h"

namespace gvd {
namespace {

/// A third of the side of a square as large as a mean region, or half the longest edge if that is
/// less, as a share of the bounding diagonal.
double maxEdgeFor(const TriangleMesh& mesh, const Diagram& diagram) {
  double area = 0;
  int regions = 0;
  for (const double ofRegion : diagram.regionArea) {
    area += ofRegion;
    regions += ofRegion > 0;
  }
  const double longest = mesh.longestEdge();
  const double ofRegions = regions > 0 ? std::sqrt(area / regions) / 3 : longest;
  return std::min(ofRegions, longest / 2) / mesh.boundingDiagonal();
}

/// Counts points, drawn uniformly, that lie in another region than that of their nearest site.
class Comparison final : public SlicedWork<DiagramAccuracy> {
 public:
  Comparison(const TriangleMesh& mesh, const DistanceField& distances, const Diagram& diagram,
             int samples)
      : mesh_(mesh), distances_(distances), diagram_(diagram), samples_(samples) {}

  bool advance(long budget) override {
    return sumAreas(mesh_, sums_, budget) && loop_.run(samples_, budget, 1, [&](int) {
      const SurfacePoint p = drawPoint(random_, sums_);
      mislabelled_ += distances_.nearest(p, budget).label != labelAt(mesh_, diagram_, p);
      ++drawn_;
      return kUnitsPerPoint;
    });
  }
  double share() const override { return static_cast<double>(drawn_) / samples_; }
  DiagramAccuracy result() override {
    return {static_cast<double>(mislabelled_) / samples_, maxEdgeFor(mesh_, diagram_)};
  }

 private:
  static constexpr long kUnitsPerPoint = 16;

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const Diagram& diagram_;
  const int samples_;
  std::vector<double> sums_;  ///< of the areas of faces
  std::mt19937_64 random_;    // the same numbers at each call
  SlicedLoop loop_;
  int drawn_ = 0, mislabelled_ = 0;
};

}  // namespace

std::unique_ptr<SlicedWork<DiagramAccuracy>> startAccuracy(const TriangleMesh& mesh,
                                                           const DistanceField& distances,
                                                           const Diagram& diagram, int samples) {
  requireMesh(mesh, distances);
  requireFaces(mesh, diagram);
  if (samples < 1)
    rejectArgument("the number of samples is " + std::to_string(samples) + ", not positive");
  return std::make_unique<Comparison>(mesh, distances, diagram, samples);
}

DiagramAccuracy accuracy(const TriangleMesh& mesh, const DistanceField& distances,
                         const Diagram& diagram, int samples) {
  return finished(startAccuracy(mesh, distances, diagram, samples));
}

}  // namespace gvd
