// SPDX-License-Identifier: MIT
#include "convergence.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "base/random.h"
#include "diagram/region_lookup.h"
#include "gvd/diagram.h"
#include "gvd/sampling.h"
#include "metrics.h"
#include "shapes.h"

namespace gvd::bench {
namespace {

using Eigen::Vector3d;

/// The point of a mesh around the origin that lies in a direction from there.
SurfacePoint pointInDirection(const TriangleMesh& mesh, const Vector3d& direction) {
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.position(mesh.tail(3 * f + i));
    const Vector3d weights = corners.inverse() * direction;
    if (weights.minCoeff() >= 0) return {f, weights / weights.sum()};
  }
  throw std::logic_error("the mesh does not surround the origin");
}

double greatCircleDistance(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

DetailStudy::DetailStudy(const TriangleMesh& mesh, std::vector<SurfacePoint> sites,
                         std::uint64_t seed)
    : mesh_(mesh), sites_(std::move(sites)) {
  constexpr int kInMixedFaces = 400'000, kElsewhere = 100'000;
  const auto truth = distances(mesh, sites_, Metric::kExact);
  const Diagram diagram = traceDiagram(mesh, *truth, static_cast<int>(sites_.size()));
  std::vector<double> mixed(mesh.faceCount()), others(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
    (diagram.faceLabel[f] == Diagram::kMixed ? mixed : others)[f] = mesh.faceArea(f);
  addStratum(*truth, mixed, kInMixedFaces, seed);
  addStratum(*truth, others, kElsewhere, seed + 1);
}

void DetailStudy::addStratum(const DistanceField& truth, std::span<const double> areas, int count,
                             std::uint64_t seed) {
  const std::vector<double> sums = cumulative(areas);
  if (!(sums.back() > 0)) return;
  Stratum stratum{sums.back() / mesh_.area(), {}, {}};
  std::mt19937_64 random(seed);
  for (int i = 0; i < count; ++i) {
    const int face = drawIndex(random, sums);
    stratum.points.push_back({face, drawBarycentric(random)});
    stratum.labels.push_back(truth.nearest(stratum.points.back()).label);
  }
  strata_.push_back(std::move(stratum));
}

std::vector<double> DetailStudy::mislabelled(Metric metric, int most) const {
  const auto field = distances(mesh_, sites_, metric);
  std::vector<double> result;
  for (int detail = 0; detail <= most; ++detail) {
    const Diagram diagram =
        traceDiagram(mesh_, *field, static_cast<int>(sites_.size()), {.detail = detail});
    double share = 0;
    for (const Stratum& stratum : strata_) {
      int wrong = 0;
      for (size_t i = 0; i < stratum.points.size(); ++i)
        wrong += labelAt(mesh_, diagram, stratum.points[i]) != stratum.labels[i];
      share += stratum.share * wrong / static_cast<double>(stratum.points.size());
    }
    result.push_back(share);
  }
  return result;
}

SphereCase sphereCase(int subdivisions, int siteCount, int pointCount, std::uint64_t seed) {
  SphereCase result{shapes::icosphere(subdivisions).mesh(), {}, {}, {}};
  std::vector<Vector3d> directions;
  const TriangleMesh coarse = shapes::icosphere(2).mesh();
  for (const SurfacePoint& p : sampleUniform(coarse, siteCount, seed)) {
    directions.push_back(coarse.position(p));
    result.sites.push_back(pointInDirection(result.mesh, directions.back()));
  }
  result.points = sampleUniform(result.mesh, pointCount, seed + 1);
  for (const SurfacePoint& p : result.points) {
    TrueNearest nearest;
    for (int label = 0; label < siteCount; ++label) {
      const double distance = greatCircleDistance(directions[label], result.mesh.position(p));
      if (distance < nearest.distance)
        nearest = {label, distance, nearest.distance};
      else
        nearest.second = std::min(nearest.second, distance);
    }
    result.nearest.push_back(nearest);
  }
  return result;
}

}  // namespace gvd::bench
