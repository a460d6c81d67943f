// SPDX-License-Identifier: MIT
// This work is based on:
// Gabriel Peyré, Laurent Cohen. Geodesic Remeshing Using Front Propagation. 2006
// Michael McCool, Eugene Fiume. Hierarchical Poisson Disk Sampling Distributions. 1992
#include "gvd/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <queue>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/random.h"
#include "base/sliced_loop.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "mesh/given_points.h"
#include "mesh/point_drawing.h"
#include "mesh/representations.h"
#include "mesh/surface_geometry.h"
#include "tessellation/density.h"
#include "tessellation/disk_grid.h"
#include "tessellation/vertex_covering.h"

namespace gvd {
namespace {

void requireCount(int count) {
  if (count < 0)
    throw Error(ErrorCode::kInvalidArgument,
                "there cannot be " + std::to_string(count) + " sample points");
}

/// Adds, one after another, the vertex that is farthest from all points so far.
class FarthestSampling final : public SlicedWork<std::vector<SurfacePoint>> {
 public:
  FarthestSampling(const TriangleMesh& mesh, int count, std::uint64_t seed, double coveringRadius)
      : mesh_(mesh), count_(count), seed_(seed), coveringRadius_(coveringRadius), sweep_(mesh) {
    requireCount(count);
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return fillInSlices(least_, mesh_.vertexCount(), kInfinity, budget); },
        [&] {
          return loop_.run(mesh_.vertexCount(), budget, 8, [&](int v) {
            queue_.push({kInfinity, -v});
          });
        },
        [&] {
          if (count_ > 0) add(sampleUniform(mesh_, 1, seed_).front());
        },
        [&] { return count_ == 0 || addOthers(budget); },
        [&] {
          return coveringRadius_ == 0 || runPart(covering_, budget, mesh_, coveringRadius_,
                                                 static_cast<size_t>(count_), points_);
        });
  }
  double progress() const override {
    return count_ > 0 ? static_cast<double>(points_.size()) / count_ : 1;
  }
  std::vector<SurfacePoint> result() override { return std::move(points_); }

 private:
  void add(const SurfacePoint& point) {
    points_.push_back(point);
    // A distance from the nearest point is right if the sweep reaches both ends of every edge that
    // the path crosses. These ends are at most an edge length beyond the point's region.
    sweep_.start(point, [this](int v) { return least_[v] + mesh_.longestEdge(v); });
    spread_ = {};
  }

  bool isComplete() const { return static_cast<int>(points_.size()) == count_; }

  bool addOthers(long& budget) {
    const auto& reached = sweep_.reached();
    while (spread_.run([&] { return sweep_.step(budget); },
                       [&] {
                         return loop_.run(reached.size(), budget, 8, [&](int i) {
                           const int v = reached[i];
                           least_[v] = std::min(least_[v], sweep_.distance(v));
                         });
                       },
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
  const std::uint64_t seed_;
  const double coveringRadius_;

  SlicedSequence sequence_, spread_;
  SlicedLoop loop_;
  dgpc::UnfoldingSweep sweep_;
  std::vector<double> least_;                          ///< from the nearest point, per vertex
  std::priority_queue<std::pair<double, int>> queue_;  ///< vertices negated: the lowest first
  std::vector<SurfacePoint> points_;
  std::optional<VertexCovering> covering_;
};

/// Points that keep their distance. Each point has its distance at all vertices of the faces that
/// its disk reaches, so whether a place is free follows from its own face, and in a large face from
/// the disks near the place.
class DiskSampling final : public SlicedWork<PoissonDisk> {
 public:
  /// Throws darts until there are `count` points, or so many darts in a row have missed that there
  /// is probably little room left. Then, without a count, the vertices that are free are added;
  /// with a count, the radius shrinks.
  DiskSampling(const TriangleMesh& mesh, std::optional<int> count, double radius,
               std::uint64_t seed)
      : mesh_(mesh),
        count_(count),
        radius_(radius),
        random_(seed),
        sweep_(mesh),
        disks_(mesh, radius) {
    if (count) requireCount(*count);
  }

  bool advance(long budget) override {
    return sequence_.run([&] { return disks_.prepare(budget); },
                         [&] { sums_ = cumulative(faceAreas(mesh_)); },
                         [&] { return addAll(budget); },
                         [&] {
                           return count_ || runPart(covering_, budget, mesh_, radius_,
                                                    std::numeric_limits<size_t>::max(), points_);
                         });
  }
  double progress() const override {
    return count_.value_or(0) > 0 ? static_cast<double>(points_.size()) / *count_
                                  : static_cast<double>(nextVertex_) / mesh_.vertexCount();
  }
  PoissonDisk result() override { return {std::move(points_), radius_}; }

 private:
  bool addAll(long& budget) {
    for (;;) {
      if (isSpreading_ && !spread(budget)) return false;
      if (isDone()) return true;
      if (budget <= 0) return false;
      offer(next(), budget);
    }
  }

  bool isDone() const {
    return count_ ? static_cast<int>(points_.size()) == *count_
                  : nextVertex_ == mesh_.vertexCount();
  }

  SurfacePoint next() {
    constexpr size_t kFewestMisses = 100;
    constexpr double kShrink = 0.95;  // nearer to 1, points are more even, and take longer
    if (nextVertex_ > 0 || misses_ >= points_.size() + kFewestMisses) {
      if (!count_) return pointAtVertex(mesh_, nextVertex_++);
      radius_ *= kShrink;
      misses_ = 0;
    }
    return drawPoint(random_, sums_);
  }

  /// Adds a point unless another one is nearer than the radius.
  void offer(const SurfacePoint& p, long& budget) {
    ++misses_;
    if (!isFree(p, budget)) return;
    if (nextVertex_ == 0) misses_ = 0;
    points_.push_back(p);
    sweep_.start(p, [this](int v) { return radius_ + 2 * mesh_.longestEdge(v); });
    spread_ = {};
    isSpreading_ = true;
  }

  bool spread(long& budget) {
    const auto& reached = sweep_.reached();
    isSpreading_ = !spread_.run(
        [&] { return sweep_.step(budget); },
        [&] { return loop_.run(reached.size(), budget, 4, [&](int i) { addDisk(reached[i]); }); });
    return !isSpreading_;
  }

  /// Adds the disk of the new point to the faces whose first corner is a vertex that it reached.
  void addDisk(int v) {
    for (const int h : mesh_.fan(v)) {
      if (h % 3 != 0) continue;
      const int f = TriangleMesh::faceOf(h);
      const DiskGrid::Distances distances(sweep_.distance(v), sweep_.distance(mesh_.tail(h + 1)),
                                          sweep_.distance(mesh_.tail(h + 2)));
      if (distances.maxCoeff() < kInfinity) disks_.add(f, distances, radius_);
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
      if (squared < radius_ * radius_) return false;
    }
    return true;
  }

  /// Disks that a dart is compared with in about the time of a unit of budget.
  static constexpr long kDisksPerUnit = 32;

  const TriangleMesh& mesh_;
  const std::optional<int> count_;
  double radius_;
  std::mt19937_64 random_;

  SlicedSequence sequence_, spread_;
  SlicedLoop loop_;
  dgpc::UnfoldingSweep sweep_;
  std::vector<double> sums_;  ///< cumulative weights of the faces
  size_t misses_ = 0;         ///< since the last dart that hit
  int nextVertex_ = 0;        ///< to be tried, after all darts
  bool isSpreading_ = false;
  DiskGrid disks_;
  std::vector<SurfacePoint> points_;
  std::optional<VertexCovering> covering_;
};

}  // namespace

std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  requireCount(count);
  const std::vector<double> sums = cumulative(faceAreas(mesh));
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) p = drawPoint(random, sums);
  return points;
}

std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed) {
  requireCount(count);
  requireDensity(mesh, density);
  std::vector<double> sums = faceAreas(mesh);
  std::vector<Eigen::Vector3d> corners(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int i = 0; i < 3; ++i) corners[f][i] = std::sqrt(density[mesh.tail(3 * f + i)]);
    sums[f] *= corners[f].sum();
  }
  sums = cumulative(sums);
  if (!(sums.back() > 0))
    throw Error(ErrorCode::kInvalidArgument, "the density is zero all over the surface");
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) {
    p.face = drawIndex(random, sums);
    const Eigen::Vector3d& root = corners[p.face];
    do {
      p.bary = drawBarycentric(random);
    } while (drawUniform(random) * root.maxCoeff() > p.bary.dot(root));
  }
  return points;
}

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startFarthest(const TriangleMesh& mesh,
                                                                     int count, std::uint64_t seed,
                                                                     double coveringRadius) {
  if (!(coveringRadius >= 0))
    throw Error(ErrorCode::kInvalidArgument,
                "points cannot cover a surface with the radius " + numberText(coveringRadius));
  return std::make_unique<FarthestSampling>(mesh, count, seed, coveringRadius);
}

std::vector<SurfacePoint> sampleFarthest(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         double coveringRadius) {
  return finished(startFarthest(mesh, count, seed, coveringRadius));
}

std::unique_ptr<SlicedWork<PoissonDisk>> startPoissonDisk(const TriangleMesh& mesh, double radius,
                                                          std::uint64_t seed) {
  if (!(radius > 0 && std::isfinite(radius)))
    throw Error(ErrorCode::kInvalidArgument,
                "a Poisson disk cannot have the radius " + numberText(radius));
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

namespace {

std::vector<int> countPerComponent(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<int> counts(mesh.topology().components, 0);
  for (const SurfacePoint& p : points)
    if (p.face != -1) ++counts[mesh.component(p.face)];
  return counts;
}

/// Draws points on the components that have fewer than `perComponent`, as many as they lack.
std::vector<SurfacePoint> drawMissing(const TriangleMesh& mesh, std::span<const int> counts,
                                      int perComponent, std::uint64_t seed) {
  std::vector<std::vector<int>> faces(counts.size());
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (const int c = mesh.component(f); counts[c] < perComponent) faces[c].push_back(f);
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> drawn;
  for (std::size_t c = 0; c < faces.size(); ++c) {
    std::vector<double> areas;
    for (const int f : faces[c]) areas.push_back(mesh.faceArea(f));
    const std::vector<double> sums = cumulative(areas);
    for (int i = counts[c]; i < perComponent; ++i) {
      drawn.push_back(drawPoint(random, sums));
      drawn.back().face = faces[c][drawn.back().face];
    }
  }
  return drawn;
}

}  // namespace

std::vector<SurfacePoint> coverComponents(const TriangleMesh& mesh,
                                          std::vector<SurfacePoint> points, int perComponent,
                                          int count, std::uint64_t seed) {
  requireCount(perComponent);
  const int components = mesh.topology().components;
  if (static_cast<std::int64_t>(perComponent) * components > count)
    throw Error(ErrorCode::kInvalidArgument, "there cannot be " + std::to_string(perComponent) +
                                                 " sites on each of " + std::to_string(components) +
                                                 " components if there are " +
                                                 std::to_string(count) + " in all");
  points = allOnMesh(mesh, points, "point ");
  std::vector<int> counts = countPerComponent(mesh, points);
  const std::vector<SurfacePoint> missing = drawMissing(mesh, counts, perComponent, seed);
  std::int64_t surplus = std::accumulate(counts.begin(), counts.end(), std::int64_t{0}) +
                         static_cast<std::int64_t>(missing.size()) - count;
  // From the last to the first.
  std::vector<SurfacePoint> covering(missing.rbegin(), missing.rend());
  for (auto p = points.rbegin(); p != points.rend(); ++p) {
    if (surplus > 0 && p->face != -1 && counts[mesh.component(p->face)] > perComponent) {
      --counts[mesh.component(p->face)];
      --surplus;
    } else {
      covering.push_back(*p);
    }
  }
  std::reverse(covering.begin(), covering.end());
  return covering;
}

BareComponents bareComponents(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  const std::vector<int> counts = countPerComponent(mesh, allOnMesh(mesh, points, "point "));
  BareComponents bare;
  bare.components = static_cast<int>(std::count(counts.begin(), counts.end(), 0));
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (counts[mesh.component(f)] == 0) bare.area += mesh.faceArea(f);
  return bare;
}

}  // namespace gvd
