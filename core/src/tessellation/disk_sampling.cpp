// SPDX-License-Identifier: MIT
// This work is based on:
// Robert Cook. Stochastic Sampling in Computer Graphics. 1986
// Michael McCool, Eugene Fiume. Hierarchical Poisson Disk Sampling Distributions. 1992
//
// `samplePoissonDisk` and `samplePoissonDiskCount`.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/random.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mesh/face_metric.h"
#include "mesh/incidence.h"
#include "mesh/random_points.h"
#include "tessellation/disk_grid.h"
#include "tessellation/vertex_covering.h"

namespace gvd {
namespace {

/// Dart throwing: random points, each kept unless it lies in the disk of an earlier one. A disk is
/// stored in all faces that it reaches, so whether a place is free follows from its own face, and
/// in a large face from the disks near the place.
class DiskSampling final : public SequentialWork<PoissonDisk> {
 public:
  /// Throws darts until there are `count` points, or so many darts in a row have missed that there
  /// is probably little room left. Then, without a count, the vertices that are free are added;
  /// with a count, the radius shrinks.
  DiskSampling(const TriangleMesh& mesh, std::optional<int> count, double radius,
               std::uint64_t seed)
      : mesh_(mesh), count_(count), random_(seed), sweep_(mesh), disks_(mesh, radius) {
    out_.radius = radius;
    if (count) requireCount(*count);
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return sweep_.prepare(budget); }, [&] { return disks_.prepare(budget); },
        [&] { return sumAreas(mesh_, sums_, budget); }, [&] { return addAll(budget); },
        [&] {
          return count_ || runPart(covering_, budget, mesh_, out_.radius,
                                   std::numeric_limits<size_t>::max(), out_.points);
        });
  }
  double share() const override {
    const auto points = static_cast<double>(out_.points.size());
    if (count_) return *count_ > 0 ? points / *count_ : 0;
    if (covering_) return (1 + covering_->progress()) / 2;
    constexpr double kDensity = 0.7;  // points per squared radius, when hardly any more fit
    return std::min(points * out_.radius * out_.radius / (kDensity * mesh_.area()), 1.0) / 2;
  }

 private:
  bool addAll(long& budget) {
    for (;;) {
      if (isSpreading_ && !spread(budget)) return false;
      if (isDone()) return true;
      if (count_ && isFull()) {
        constexpr double kShrink = 0.95;  // nearer to 1, points are more even, and take longer
        out_.radius *= kShrink;
        misses_ = 0;
      }
      if (!setReach(budget) || budget <= 0) return false;
      offer(next(), budget);
    }
  }

  /// Lets the sweep reach a little farther than the radius.
  bool setReach(long& budget) {
    if (reachedRadius_ == out_.radius) return true;
    if (!loop_.run(mesh_.vertexCount(), budget, kQuickRounds,
                   [&](int v) { sweep_.setReach(v, out_.radius + 2 * mesh_.longestEdge(v)); }))
      return false;
    reachedRadius_ = out_.radius;
    return true;
  }

  bool isDone() const {
    return count_ ? static_cast<int>(out_.points.size()) == *count_
                  : nextVertex_ == mesh_.vertexCount();
  }

  /// Whether so many darts in a row have missed that there is probably little room left.
  bool isFull() const {
    constexpr size_t kFewestMisses = 100;
    return misses_ >= out_.points.size() + kFewestMisses;
  }

  /// A dart, or a vertex if darts are over.
  SurfacePoint next() {
    if (!count_ && (nextVertex_ > 0 || isFull())) return pointAtVertex(mesh_, nextVertex_++);
    return drawPoint(random_, sums_);
  }

  /// Adds a point unless another one is nearer than the radius.
  void offer(const SurfacePoint& p, long& budget) {
    ++misses_;
    if (!isFree(p, budget)) return;
    if (nextVertex_ == 0) misses_ = 0;
    out_.points.push_back(p);
    sweep_.start(p);
    isSpreading_ = true;
  }

  bool spread(long& budget) {
    const auto& reached = sweep_.reached();
    isSpreading_ = !spread_.runRound([&] { return sweep_.step(budget); },
                                     forItems(reached, budget, 4, [&](int v) { addDisk(v); }));
    return !isSpreading_;
  }

  /// Adds the disk of the new point to the faces whose first corner is a vertex that it reached.
  void addDisk(int v) {
    for (const int h : mesh_.fan(v)) {
      if (h % 3 != 0) continue;
      const int f = TriangleMesh::faceOf(h);
      const DiskGrid::Distances distances(sweep_.distance(v), sweep_.distance(mesh_.tail(h + 1)),
                                          sweep_.distance(mesh_.tail(h + 2)));
      if (distances.maxCoeff() < kInfinity) disks_.add(f, distances, out_.radius);
    }
  }

  bool isFree(const SurfacePoint& p, long& budget) const {
    const double excess = interpolationExcess(p.bary, squaredSides(mesh_, p.face));
    const std::span<const int> disks = disks_.near(p);
    budget -= 1 + static_cast<long>(disks.size()) / kDisksPerUnit;
    for (const int disk : disks) {
      const DiskGrid::Distances& d = disks_[disk];
      const double squared =
          p.bary[0] * d[0] * d[0] + p.bary[1] * d[1] * d[1] + p.bary[2] * d[2] * d[2] - excess;
      if (squared < out_.radius * out_.radius) return false;
    }
    return true;
  }

  /// Disks that a dart is compared with in about the time of a unit of budget.
  static constexpr long kDisksPerUnit = 32;

  const TriangleMesh& mesh_;
  const std::optional<int> count_;
  double reachedRadius_ = 0;  ///< the radius that `setReach` was last done for
  std::mt19937_64 random_;

  SlicedSequence spread_;
  SlicedLoop loop_;
  dgpc::UnfoldingSweep sweep_;
  std::vector<double> sums_;  ///< of the areas of faces
  size_t misses_ = 0;         ///< since the last dart that hit
  int nextVertex_ = 0;        ///< to be tried, after all darts
  bool isSpreading_ = false;
  DiskGrid disks_;
  std::optional<VertexCovering> covering_;
};

}  // namespace

std::unique_ptr<SlicedWork<PoissonDisk>> startPoissonDisk(const TriangleMesh& mesh, double radius,
                                                          std::uint64_t seed) {
  if (!(radius > 0 && std::isfinite(radius)))
    rejectArgument("a Poisson disk cannot have the radius " + numberText(radius));
  constexpr int kMost = std::numeric_limits<int>::max();
  if (0.7 * mesh.area() / (radius * radius) > kMost)
    rejectArgument("with the radius " + numberText(radius) + " there would be more than " +
                   std::to_string(kMost) + " Poisson disks");
  return std::make_unique<DiskSampling>(mesh, std::nullopt, radius, seed);
}

PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, double radius, std::uint64_t seed) {
  return finished(startPoissonDisk(mesh, radius, seed));
}

std::unique_ptr<SlicedWork<PoissonDisk>> startPoissonDiskCount(const TriangleMesh& mesh, int count,
                                                               std::uint64_t seed) {
  // The spacing of `count` points in a hexagonal lattice, the densest packing in the plane.
  const double radius = count > 0 ? std::sqrt(2 * mesh.area() / (std::sqrt(3.0) * count)) : 0;
  return std::make_unique<DiskSampling>(mesh, count, radius, seed);
}

PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  return finished(startPoissonDiskCount(mesh, count, seed));
}

}  // namespace gvd
