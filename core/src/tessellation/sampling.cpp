// SPDX-License-Identifier: MIT
// This work is based on:
// Gabriel Peyré, Laurent Cohen. Geodesic Remeshing Using Front Propagation. 2006
// Michael McCool, Eugene Fiume. Hierarchical Poisson Disk Sampling Distributions. 1992
#include "gvd/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <span>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "base/random.h"
#include "distance/common_labels.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "mesh/surface_geometry.h"
#include "tessellation/density.h"

namespace gvd {
namespace {

/// The areas of the faces; if there is no area at all, 1 for each.
std::vector<double> faceWeights(const TriangleMesh& mesh) {
  const bool hasArea = mesh.area() > 0;
  std::vector<double> weights(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) weights[f] = hasArea ? mesh.faceArea(f) : 1;
  return weights;
}

void requireCount(int count) {
  if (count < 0) {
    throw Error(ErrorCode::kInvalidArgument,
                "there cannot be " + std::to_string(count) + " sample points");
  }
}

SurfacePoint drawPoint(std::mt19937_64& random, const std::vector<double>& sums) {
  SurfacePoint p;
  p.face = drawIndex(random, sums);
  p.bary = drawBarycentric(random);
  return p;
}

SurfacePoint atVertex(const TriangleMesh& mesh, int vertex) {
  const int h = mesh.outgoing(vertex);
  return {TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

template <class Spreads>
void spreadFrom(dgpc::UnfoldingSweep& sweep, const SurfacePoint& site, Spreads spreads) {
  long budget = std::numeric_limits<long>::max();
  sweep.start(site);
  sweep.run(spreads, budget);
}

/// The distance from every vertex to the nearest of the points so far, and the farthest vertex.
class Farthest {
 public:
  explicit Farthest(const TriangleMesh& mesh)
      : sweep_(mesh), longestEdge_(longestEdges(mesh)), least_(mesh.vertexCount(), kInfinity) {
    for (int v = 0; v < mesh.vertexCount(); ++v) queue_.push({kInfinity, -v});
  }

  void add(const SurfacePoint& point) {
    // Where a point is the nearest, its distance is right if it is at both ends of every edge that
    // the path crosses: these are no farther beyond the point's region than an edge is long.
    spreadFrom(sweep_, point,
               [&](int v, double distance) { return distance < least_[v] + longestEdge_[v]; });
    for (const int v : sweep_.reached()) least_[v] = std::min(least_[v], sweep_.distance(v));
  }

  /// Distances only fall: the first vertex whose distance in the queue is up to date is the
  /// farthest.
  std::pair<double, int> farthest() {
    for (;;) {
      const auto [distance, negative] = queue_.top();
      if (distance == least_[-negative]) return {distance, -negative};
      queue_.pop();
      queue_.push({least_[-negative], negative});
    }
  }

 private:
  dgpc::UnfoldingSweep sweep_;
  const std::vector<double> longestEdge_;
  std::vector<double> least_;
  std::priority_queue<std::pair<double, int>> queue_;  ///< vertices negated: the lowest first
};

/// Points that keep their distance. Each of them is known at all vertices of the faces that its
/// disk reaches into, so that whether a place is free can be told from its own face.
class Disks {
 public:
  explicit Disks(const TriangleMesh& mesh)
      : mesh_(mesh), sweep_(mesh), longestEdge_(longestEdges(mesh)), known_(mesh.vertexCount()) {}

  const std::vector<SurfacePoint>& points() const { return points_; }

  /// Adds a point unless another one is nearer than the radius, which must never grow.
  bool add(const SurfacePoint& p, double radius) {
    if (!isFree(p, radius)) return false;
    const int label = static_cast<int>(points_.size());
    points_.push_back(p);
    spreadFrom(sweep_, p,
               [&](int v, double distance) { return distance < radius + 2 * longestEdge_[v]; });
    for (const int v : sweep_.reached()) known_[v].push_back({label, sweep_.distance(v)});
    return true;
  }

 private:
  bool isFree(const SurfacePoint& p, double radius) const {
    const auto sides = squaredSides(mesh_, p.face);
    const double excess = p.bary[0] * p.bary[1] * sides[0] + p.bary[1] * p.bary[2] * sides[1] +
                          p.bary[2] * p.bary[0] * sides[2];
    const auto knownAt = [&](int corner) -> std::span<const LabelledDistance> {
      return known_[mesh_.tail(3 * p.face + corner)];
    };
    double least = kInfinity;
    visitCommonLabels(knownAt(0), knownAt(1), knownAt(2),
                      [&](int /*label*/, const std::array<double, 3>& d) {
                        least = std::min(least, p.bary[0] * d[0] * d[0] + p.bary[1] * d[1] * d[1] +
                                                    p.bary[2] * d[2] * d[2] - excess);
                      });
    return !(least < radius * radius);
  }

  const TriangleMesh& mesh_;
  dgpc::UnfoldingSweep sweep_;
  const std::vector<double> longestEdge_;
  std::vector<std::vector<LabelledDistance>> known_;  ///< per vertex, ascending by label
  std::vector<SurfacePoint> points_;
};

/// Throws darts until as many in a row have missed as make it unlikely that there is much room
/// left, or there are `count` points.
void throwDarts(Disks& disks, double radius, size_t count, std::mt19937_64& random,
                const std::vector<double>& sums) {
  constexpr size_t kFewest = 100;
  size_t misses = 0;
  while (disks.points().size() < count && misses < disks.points().size() + kFewest)
    misses = disks.add(drawPoint(random, sums), radius) ? 0 : misses + 1;
}

}  // namespace

std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  requireCount(count);
  const std::vector<double> sums = cumulative(faceWeights(mesh));
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) p = drawPoint(random, sums);
  return points;
}

std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed) {
  requireCount(count);
  validateDensity(mesh, density);
  std::vector<double> sums = faceWeights(mesh);
  std::vector<Eigen::Vector3d> corners(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int i = 0; i < 3; ++i) corners[f][i] = density[mesh.tail(3 * f + i)];
    sums[f] *= corners[f].sum();
  }
  sums = cumulative(sums);
  if (!(sums.back() > 0))
    throw Error(ErrorCode::kInvalidArgument, "the density is zero all over the surface");
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) {
    p.face = drawIndex(random, sums);
    const Eigen::Vector3d& rho = corners[p.face];
    do {
      p.bary = drawBarycentric(random);
    } while (drawUniform(random) * rho.maxCoeff() > p.bary.dot(rho));
  }
  return points;
}

std::vector<SurfacePoint> sampleFarthest(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         double coveringRadius) {
  requireCount(count);
  std::vector<SurfacePoint> points;
  if (count == 0) return points;
  points = sampleUniform(mesh, 1, seed);
  Farthest field(mesh);
  field.add(points.back());
  while (static_cast<int>(points.size()) < count) {
    const auto [distance, vertex] = field.farthest();
    if (!(distance > coveringRadius)) break;
    points.push_back(atVertex(mesh, vertex));
    field.add(points.back());
  }
  return points;
}

PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, double radius, std::uint64_t seed) {
  if (!(radius > 0 && std::isfinite(radius)))
    throw Error(ErrorCode::kInvalidArgument,
                "a Poisson disk cannot have the radius " + numberText(radius));
  Disks disks(mesh);
  std::mt19937_64 random(seed);
  throwDarts(disks, radius, std::numeric_limits<size_t>::max(), random,
             cumulative(faceWeights(mesh)));
  for (int v = 0; v < mesh.vertexCount(); ++v) disks.add(atVertex(mesh, v), radius);
  return {disks.points(), radius};
}

PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  requireCount(count);
  constexpr double kShrink = 0.95;
  // In the plane no more than this many disks fit, in a hexagonal lattice.
  double radius = count > 0 ? std::sqrt(2 * mesh.area() / (std::sqrt(3.0) * count)) : 0;
  Disks disks(mesh);
  std::mt19937_64 random(seed);
  const std::vector<double> sums = cumulative(faceWeights(mesh));
  for (;;) {
    throwDarts(disks, radius, count, random, sums);
    if (disks.points().size() == static_cast<size_t>(count)) return {disks.points(), radius};
    radius *= kShrink;
  }
}

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
  std::vector<int> has(components, 0);
  for (const SurfacePoint& p : points) ++has[mesh.component(p.face)];
  std::vector<std::vector<int>> faces(components);
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (const int c = mesh.component(f); has[c] < perComponent) faces[c].push_back(f);

  const std::vector<double> weights = faceWeights(mesh);
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> added;
  for (const std::vector<int>& list : faces) {
    if (list.empty()) continue;
    std::vector<double> sums;
    sums.reserve(list.size());
    for (const int f : list) sums.push_back((sums.empty() ? 0 : sums.back()) + weights[f]);
    int& there = has[mesh.component(list.front())];
    for (; there < perComponent; ++there) {
      SurfacePoint p = drawPoint(random, sums);
      p.face = list[p.face];
      added.push_back(p);
    }
  }

  std::size_t total = points.size() + added.size();
  for (std::size_t i = points.size(); i-- > 0 && total > static_cast<std::size_t>(count);) {
    int& there = has[mesh.component(points[i].face)];
    if (there <= perComponent) continue;
    --there;
    --total;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  points.insert(points.end(), added.begin(), added.end());
  return points;
}

BareComponents bareComponents(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<char> isBare(mesh.topology().components, true);
  for (const SurfacePoint& p : points)
    if (p.face >= 0) isBare[mesh.component(p.face)] = false;
  BareComponents bare;
  bare.components = static_cast<int>(std::count(isBare.begin(), isBare.end(), true));
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (isBare[mesh.component(f)]) bare.area += mesh.faceArea(f);
  return bare;
}

}  // namespace gvd
