// SPDX-License-Identifier: MIT
#include "tessellation/disk_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "gvd/sampling.h"
#include "shapes.h"

namespace gvd {
namespace {

/// A triangle on the unit interval.
TriangleMesh triangleWithApex(double x, double y) {
  shapes::Shape shape;
  shape.addVertex({0, 0, 0});
  shape.addVertex({1, 0, 0});
  shape.addVertex({x, y, 0});
  shape.addTriangle(0, 1, 2);
  return shape.mesh();
}

TEST(DiskGrid, HasEveryDiskThatContainsAPointAndFewOthers) {
  constexpr double kRadius = 0.02;
  for (const TriangleMesh& mesh : {shapes::triangle().mesh(), triangleWithApex(0.3, 0.01)}) {
    DiskGrid grid(mesh, kRadius);
    long budget = 1000000;
    ASSERT_TRUE(grid.prepare(budget));
    const auto fromCorners = [&](const SurfacePoint& p) {
      DiskGrid::Distances d;
      for (int i = 0; i < 3; ++i) d[i] = (mesh.position(mesh.tail(i)) - mesh.position(p)).norm();
      return d;
    };
    const auto centres = sampleUniform(mesh, 2000, 1);
    for (const SurfacePoint& p : centres) grid.add(0, fromCorners(p), kRadius);
    for (const SurfacePoint& p : sampleUniform(mesh, 100, 2)) {
      const std::span<const int> near = grid.near(p);
      EXPECT_LT(near.size(), centres.size() / 5);
      for (const SurfacePoint& centre : centres) {
        if ((mesh.position(p) - mesh.position(centre)).norm() > kRadius * (1 - 1e-9)) continue;
        EXPECT_TRUE(std::any_of(near.begin(), near.end(),
                                [&](int disk) { return grid[disk] == fromCorners(centre); }));
      }
    }
  }
}

/// A needle has one rectangle, and is much longer than a disk is wide: a disk beside it is nearer
/// to its corners than the needle is long.
TEST(DiskGrid, ANeedleHasOnlyTheDisksThatReachIt) {
  const TriangleMesh mesh = triangleWithApex(0.5, 0.001);
  constexpr double kRadius = 0.03;
  DiskGrid grid(mesh, kRadius);
  long budget = 1000;
  ASSERT_TRUE(grid.prepare(budget));
  for (const double y : {-0.1, -0.02, 0.1}) {
    DiskGrid::Distances d;
    for (int i = 0; i < 3; ++i)
      d[i] = (mesh.position(mesh.tail(i)) - Eigen::Vector3d(0.5, y, 0)).norm();
    grid.add(0, d, kRadius);
  }
  EXPECT_EQ(grid.near(shapes::centroid(0)).size(), 1);
}

TEST(SamplePoissonDisk, TakesFewStepsForThousandsOfPointsInAFace) {
  const auto mesh = shapes::cube().mesh();
  const auto stepsFor = [&](int count) {
    const auto sampling = startPoissonDiskCount(mesh, count, 1);
    int steps = 1;
    while (!sampling->step(1000)) ++steps;
    return steps;
  };
  // The number of darts grows faster than that of points: for five times as many points, by
  // 5^(5/3), about 15. To compare each with all points of its face would take 50 times as long.
  EXPECT_LT(stepsFor(5000), 20 * stepsFor(1000));
}

}  // namespace
}  // namespace gvd
