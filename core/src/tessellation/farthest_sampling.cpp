// SPDX-License-Identifier: MIT
// This work is based on:
// Gabriel Peyré, Laurent Cohen. Geodesic Remeshing Using Front Propagation. 2006
//
// `sampleFarthest`.
#include <algorithm>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mesh/incidence.h"
#include "tessellation/vertex_covering.h"

namespace gvd {
namespace {

/// Adds, one after another, the vertex that is farthest from all points so far.
class FarthestSampling final : public SequentialWork<std::vector<SurfacePoint>> {
 public:
  FarthestSampling(const TriangleMesh& mesh, int count, std::uint64_t seed, double coveringRadius)
      : mesh_(mesh),
        count_(count),
        coveringRadius_(coveringRadius),
        sweep_(mesh),
        first_(startUniform(mesh, std::min(count, 1), seed)) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return fillInSlices(least_, mesh_.vertexCount(), kInfinity, budget); },
        forEach(mesh_.vertexCount(), budget, 8,
                [&](int v) {
                  queue_.push({kInfinity, -v});
                }),
        [&] { return sweep_.prepare(budget); }, [&] { return first_->step(budget); },
        [&] {
          for (const SurfacePoint& p : first_->take()) add(p);
        },
        [&] { return count_ == 0 || addOthers(budget); },
        [&] {
          return coveringRadius_ == 0 || isComplete() ||
                 runPart(covering_, budget, mesh_, coveringRadius_, static_cast<size_t>(count_),
                         out_);
        });
  }
  double share() const override {
    return count_ > 0 ? static_cast<double>(out_.size()) / count_ : sequence_.progress();
  }

 private:
  void add(const SurfacePoint& point) {
    out_.push_back(point);
    sweep_.start(point);
  }

  bool isComplete() const { return static_cast<int>(out_.size()) == count_; }

  /// Takes the distance of a vertex from the last point. A distance from the nearest point is right
  /// if the sweep reaches both ends of every edge that the path crosses. These ends are at most an
  /// edge length beyond the point's region.
  void takeDistance(int v) {
    least_[v] = std::min(least_[v], sweep_.distance(v));
    sweep_.setReach(v, least_[v] + mesh_.longestEdge(v));
  }

  bool addOthers(long& budget) {
    const auto& reached = sweep_.reached();
    while (spread_.runRound([&] { return sweep_.step(budget); },
                            forItems(reached, budget, 8, [&](int v) { takeDistance(v); }),
                            [&] { return isComplete() || findFarthest(budget); })) {
      if (isComplete()) return true;
      const auto [distance, negative] = queue_.top();
      if (!(distance > coveringRadius_)) return true;
      add(pointAtVertex(mesh_, -negative));
    }
    return false;
  }

  /// Distances only decrease, so the first vertex whose distance in the queue is up to date is the
  /// farthest.
  bool findFarthest(long& budget) {
    for (; budget > 0; --budget) {
      const auto [distance, negative] = queue_.top();
      if (distance == least_[-negative]) return true;
      queue_.pop();
      queue_.push({least_[-negative], negative});
    }
    return false;
  }

  const TriangleMesh& mesh_;
  const int count_;
  const double coveringRadius_;

  SlicedSequence spread_;
  dgpc::UnfoldingSweep sweep_;
  std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> first_;
  std::vector<double> least_;                          ///< from the nearest point, per vertex
  std::priority_queue<std::pair<double, int>> queue_;  ///< vertices negated: the lowest first
  std::optional<VertexCovering> covering_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startFarthest(const TriangleMesh& mesh,
                                                                     int count, std::uint64_t seed,
                                                                     double coveringRadius) {
  if (!(coveringRadius >= 0))
    rejectArgument("points cannot cover a surface with the radius " + numberText(coveringRadius));
  return std::make_unique<FarthestSampling>(mesh, count, seed, coveringRadius);
}

std::vector<SurfacePoint> sampleFarthest(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         double coveringRadius) {
  return finished(startFarthest(mesh, count, seed, coveringRadius));
}

}  // namespace gvd
