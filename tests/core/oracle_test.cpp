// SPDX-License-Identifier: MIT
//
// The exact metric against CGAL's exact distances.

#include "oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

constexpr double kTolerance = 1e-9;

/// A random mesh of at most some 300 faces: genus 0 to 3, with and without boundary, one component
/// or two, plane and not, needles and caps among the faces.
TriangleMesh randomMesh(std::uint64_t seed) {
  shapes::Random random(seed);
  const auto bumpy = [&](int genus) {
    return shapes::bumpySurface(genus, genus == 0 ? 2 : 1, random.uniform(0.1, 0.5), seed);
  };
  const auto withHoles = [&](const shapes::Shape& shape) {
    return shapes::withoutRandomFaces(shape, 1 + random.below(8), seed);
  };
  switch (seed % 12) {
    case 0:
      return shapes::randomTriangulation(5 + random.below(60), 40, seed).mesh();
    case 1:
      return shapes::grid(3 + random.below(6), 3 + random.below(6), 0.2, seed).mesh();
    case 2:
      return bumpy(0).mesh();
    case 3:
      return bumpy(1).mesh();
    case 4:
      return bumpy(2).mesh();
    case 5:
      return bumpy(3).mesh();
    case 6:
      return withHoles(bumpy(static_cast<int>(seed / 12 % 4))).mesh();
    case 7:
      return withHoles(shapes::subdivided(shapes::icosphere(1))).mesh();
    case 8:
      return shapes::gradedDisk(3 + random.below(5), 5 + random.below(6), 0.6).mesh();
    case 9:
      return shapes::torus(8 + random.below(6), 5 + random.below(5)).mesh();
    case 10:
      return shapes::joined(bumpy(0), shapes::moved(shapes::cube(), {9, 0, 0})).mesh();
    default: {
      // A saddle: shortest paths bend at its middle.
      const auto fan = shapes::vertexFan(6 + 2 * random.below(4), random.uniform(6.5, 9));
      return shapes::subdivided(shapes::subdivided(fan)).mesh();
    }
  }
}

/// In a face, on an edge or at a vertex, by turns.
SurfacePoint onFaceEdgeOrVertex(SurfacePoint p, int turn) {
  if (turn % 3 == 1) {
    p.bary[p.face % 3] = 0;
    p.bary /= p.bary.sum();
  } else if (turn % 3 == 2) {
    p.bary = Eigen::Vector3d::Unit(p.face % 3);
  }
  return p;
}

std::vector<SurfacePoint> randomPoints(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  auto points = sampleUniform(mesh, count, seed);
  for (int i = 0; i < count; ++i) points[i] = onFaceEdgeOrVertex(points[i], i);
  return points;
}

class RandomMeshes : public ::testing::TestWithParam<int> {
 protected:
  RandomMeshes()
      : mesh_(randomMesh(GetParam())),
        sites_(randomPoints(mesh_, 1 + GetParam() * 7 % 12, GetParam() + 1000)),
        points_(randomPoints(mesh_, 150, GetParam() + 2000)) {
    const Oracle oracle(mesh_);
    std::vector<SurfacePoint> places = points_;
    for (int v = 0; v < mesh_.vertexCount(); ++v) places.push_back(pointAtVertex(mesh_, v));
    for (const SurfacePoint& site : sites_) expected_.push_back(oracle.distances(site, places));
    field_ = finished(propagate(mesh_, sites_, Metric::kExact));
  }

  double expected(int label, int point) const { return expected_[label][point]; }
  double expectedAtVertex(int label, int v) const { return expected_[label][points_.size() + v]; }
  double least(int point) const {
    double result = kInfinity;
    for (const auto& distances : expected_) result = std::min(result, distances[point]);
    return result;
  }

  TriangleMesh mesh_;
  std::vector<SurfacePoint> sites_, points_;
  std::vector<std::vector<double>> expected_;  ///< by site, at all points, then at all vertices
  std::unique_ptr<DistanceField> field_;
};

TEST_P(RandomMeshes, HaveTheOraclesDistancesAndPathsAsLong) {
  for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
    SCOPED_TRACE("point " + std::to_string(i));
    const LabelledDistance nearest = field_->nearest(points_[i]);
    const double distance = least(i);
    if (distance == kInfinity) {
      EXPECT_EQ(nearest.label, -1);
      continue;
    }
    ASSERT_GE(nearest.label, 0);
    EXPECT_NEAR(nearest.distance, distance, kTolerance * distance);
    // Another label only where the two tie.
    EXPECT_LE(expected(nearest.label, i), distance * (1 + kTolerance));
    const auto path = field_->path(nearest.label, points_[i]);
    EXPECT_NEAR(lengthOf(mesh_, path), distance, kTolerance * distance);
  }
  for (int v = 0; v < mesh_.vertexCount(); ++v)
    for (const auto& [label, known] : field_->at(v)) {
      SCOPED_TRACE("site " + std::to_string(label) + ", vertex " + std::to_string(v));
      const double distance = expectedAtVertex(label, v);
      EXPECT_NEAR(known, distance, kTolerance * distance);
      const auto path = field_->path(label, pointAtVertex(mesh_, v));
      EXPECT_NEAR(lengthOf(mesh_, path), distance, kTolerance * distance);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMeshes, ::testing::Range(0, 200));

}  // namespace
}  // namespace gvd
