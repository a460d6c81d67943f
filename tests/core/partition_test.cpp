// SPDX-License-Identifier: MIT
#include "gvd/partition.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "diagram_checks.h"
#include "gvd/sampling.h"
#include "partition/convex_triangulation.h"
#include "partition_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::hasItsTwins;
using checks::trace;
using Eigen::Vector2d;
using Eigen::Vector3d;
using shapes::centroid;

constexpr double kPi = 3.141592653589793;

/// With sites that are apart, all of it holds.
::testing::AssertionResult isSound(const TriangleMesh& mesh, const Diagram& d, const Partition& p) {
  const auto result = checks::isSound(mesh, p);
  return result ? checks::agreesWithDiagram(mesh, d, p) : result;
}

class PartitionOfRandomMeshes : public ::testing::TestWithParam<int> {};

TEST_P(PartitionOfRandomMeshes, IsTheSurfaceItWas) {
  const auto mesh = shapes::randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, shapes::randomSiteCount(mesh, GetParam()), GetParam());
  for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
    const Diagram d = trace(mesh, sites, metric).diagram;
    EXPECT_TRUE(isSound(mesh, d, partition(mesh, d)));
  }
}

TEST_P(PartitionOfRandomMeshes, IsSoWithSitesAtVertices) {
  const auto mesh = shapes::randomMesh(GetParam());
  const auto sites = sampleFarthest(mesh, shapes::randomSiteCount(mesh, GetParam()), GetParam());
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_TRUE(isSound(mesh, d, partition(mesh, d)));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PartitionOfRandomMeshes, ::testing::Range(0, 104));

TEST(Partition, CutsASquareBetweenAnyNumberOfVertices) {
  const auto mesh = shapes::grid(6, 6, 0.2, 1).mesh();
  for (int count = 1; count <= mesh.vertexCount(); ++count) {
    const Diagram d = trace(mesh, sampleFarthest(mesh, count, count)).diagram;
    EXPECT_TRUE(isSound(mesh, d, partition(mesh, d))) << count;
  }
}

TEST(Partition, IsTheSurfaceItWasWithDetail) {
  const std::array<TriangleMesh, 4> meshes = {
      shapes::bumpySurface(1, 2, 0.2, 5).mesh(), shapes::icosphere(2).mesh(),
      shapes::annulus(12, 3).mesh(), shapes::grid(5, 5, 0.2, 1).mesh()};
  for (const TriangleMesh& mesh : meshes) {
    const auto sites = sampleUniform(mesh, 12, 5);
    for (const int detail : {1, 2, 3}) {
      const Diagram d = trace(mesh, sites, Metric::kDgpc, detail).diagram;
      EXPECT_TRUE(isSound(mesh, d, partition(mesh, d))) << detail;
    }
  }
}

/// A surface that touches itself along an edge, around both ends of which it goes on: so there are
/// two edges with the same ends.
TEST(Partition, KeepsTwoEdgesWithTheSameEndsApart) {
  const shapes::Shape shape{{1.5, 0.5, 1.5, 1,   0, 2, 1,   0, 1,   1.5, 0.5, 0.5, 1, 0,  0, 0.5, 1,
                             0,   0.5, 1,   1,   1, 1, 2,   1, 0.5, 1.5, 1.5, 1,   1, 2,  1, 0,   1,
                             1,   1.5, 1.5, 0.5, 0, 1, 1.5, 0, 0,   2,   0,   0.5, 1, 0.5},
                            {0,  1, 2,  3,  2, 4,  0,  2,  3,  4,  2,  5,  2, 1,  6,  2,  6,  5,
                             7,  8, 9,  8,  2, 3,  9,  3,  10, 8,  3,  9,  7, 9,  11, 12, 4,  5,
                             13, 5, 14, 12, 5, 13, 10, 13, 3,  13, 14, 15, 3, 15, 2,  13, 15, 3}};
  const TriangleMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.repairs().nonManifoldEdges, 1);
  ASSERT_EQ(mesh.topology().components, 1);
  const std::vector<SurfacePoint> sites = {
      {11, {0.72, 0.28, 0}}, {1, {0.19, 0.45, 0.36}}, {10, {0, 0, 1}}};
  for (const int detail : {0, 1, 2}) {
    const Diagram d = trace(mesh, sites, Metric::kExact, detail).diagram;
    EXPECT_TRUE(checks::isConsistent(mesh, d, detail)) << detail;
    EXPECT_TRUE(isSound(mesh, d, partition(mesh, d))) << detail;
  }
}

TEST(Partition, MeasuresTheSidesOfACube) {
  const auto mesh = shapes::cube().mesh();
  const auto sites = shapes::middlesOfSides(mesh);
  const Diagram d = trace(mesh, sites).diagram;
  const Partition p = partition(mesh, d);
  ASSERT_EQ(p.regions.size(), 6u);
  for (const RegionPatch& region : p.regions) {
    EXPECT_EQ(region.components, 1);
    EXPECT_EQ(region.eulerCharacteristic, 1);
    EXPECT_EQ(region.selfTouchings, 0);
    EXPECT_NEAR(region.area, 1, 1e-9);
    EXPECT_NEAR(region.perimeter, 4, 1e-9);
    EXPECT_EQ(region.boundaryLength, 0);
    const Vector3d centre = mesh.position(sites[region.label]);
    EXPECT_NEAR((region.centroid - centre).norm(), 0, 1e-9);
    EXPECT_NEAR((mesh.position(region.nearCentroid) - centre).norm(), 0, 1e-9);
    ASSERT_EQ(region.neighbours.size(), 4u);
    for (const auto& n : region.neighbours) EXPECT_NEAR(n.length, 1, 1e-9);
  }
}

TEST(Partition, FindsTheCentroidOnABentRegion) {
  // All of a sphere: the centroid is its centre, and every face is about as near.
  const auto mesh = shapes::icosphere(2).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  const Partition p = partition(mesh, trace(mesh, sites).diagram);
  EXPECT_NEAR(p.regions[0].centroid.norm(), 0, 1e-12);
  double nearest = 1;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Vector3d a = mesh.position(mesh.tail(3 * f)), b = mesh.position(mesh.tail(3 * f + 1));
    const Vector3d c = mesh.position(mesh.tail(3 * f + 2));
    nearest = std::min(nearest, std::abs(a.dot((b - a).cross(c - a).normalized())));
  }
  EXPECT_NEAR(mesh.position(p.regions[0].nearCentroid).norm(), nearest, 1e-12);
}

TEST(Partition, KnowsTheTopologyOfOneRegion) {
  struct Case {
    TriangleMesh mesh;
    int euler, genus, loops;
  };
  const std::array<Case, 5> cases = {{{shapes::icosphere(1).mesh(), 2, 0, 0},
                                      {shapes::torus(12, 8).mesh(), 0, 1, 0},
                                      {shapes::bumpySurface(3, 1, 0.2, 1).mesh(), -4, 3, 0},
                                      {shapes::cylinder(8, 4).mesh(), 0, 0, 2},
                                      {shapes::grid(3, 3).mesh(), 1, 0, 1}}};
  for (const Case& c : cases) {
    const std::vector<SurfacePoint> sites = {centroid(0)};
    const Partition p = partition(c.mesh, trace(c.mesh, sites).diagram);
    const RegionPatch& region = p.regions[0];
    EXPECT_EQ(region.components, 1);
    EXPECT_EQ(region.eulerCharacteristic, c.euler);
    EXPECT_EQ(region.genus, c.genus);
    EXPECT_EQ(region.loops, c.loops);
    EXPECT_EQ(region.selfTouchings, 0);
    EXPECT_EQ(region.perimeter, region.boundaryLength);
  }
}

TEST(Partition, GivesWhatNoSiteReachesAPartOfItsOwn) {
  const auto mesh =
      shapes::joined(shapes::octahedron(), shapes::moved(shapes::octahedron(), Vector3d(5, 0, 0)))
          .mesh();
  const std::vector<SurfacePoint> sites = {centroid(0), centroid(3)};
  const Diagram d = trace(mesh, sites).diagram;
  const Partition all = partition(mesh, d);
  EXPECT_TRUE(isSound(mesh, d, all));
  EXPECT_EQ(all.unreachable.triangleCount, 8);
  EXPECT_EQ(all.unreachable.eulerCharacteristic, 2);
  EXPECT_EQ(all.triangleLabel.back(), Diagram::kUnreachable);
  const Partition reached = partition(mesh, d, {.leaveOutUnreachable = true});
  EXPECT_EQ(reached.unreachable.triangleCount, 0);
  EXPECT_EQ(reached.triangles.size(), all.triangles.size() - 8);
  EXPECT_EQ(reached.points.size(), all.points.size() - 6);
}

TEST(Partition, HasAnEmptyRegionForACoincidentSite) {
  const auto mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {centroid(40), centroid(7), centroid(7)};
  const Partition p = partition(mesh, trace(mesh, sites).diagram);
  EXPECT_EQ(p.regions[2].label, 2);
  EXPECT_EQ(p.regions[2].triangleCount, 0);
  EXPECT_EQ(p.regions[2].area, 0);
  EXPECT_EQ(p.regions[2].components, 0);
}

/// Bisectors run up a spike that is 1e11 times as high as wide: points on its edges were merged
/// with its tip from farther away than points between the edges, which left a region pinched off
/// there.
TEST(Partition, IsNotPinchedAtTheTipOfASpike) {
  const std::vector<double> positions = {3, 3, 2, 0, 0, 0, 0, 0, 1, 3, 1, 1, -1e30, 1, 3};
  const std::vector<int> triangles = {0, 2, 3, 1, 3, 2, 0, 3, 4, 1, 4, 3, 0, 4, 2, 1, 2, 4};
  const TriangleMesh mesh(positions, triangles);
  const std::vector<SurfacePoint> sites = {{0, {0, 0, 1}},
                                           {0, {0x1p-16, 0, 1 - 0x1p-16}},
                                           {0, {0.01171875, 0, 0.98828125}},
                                           {0, {0, 0.04296875, 0.95703125}}};
  const Diagram diagram = trace(mesh, sites, Metric::kExact).diagram;
  EXPECT_TRUE(isSound(mesh, diagram, partition(mesh, diagram)));
}

TEST(Partition, LeavesHolesForIndifferentFaces) {
  const auto mesh = shapes::icosphere(2).mesh();
  Diagram d = trace(mesh, sampleFarthest(mesh, 2, 1)).diagram;
  for (int f = 0; f < mesh.faceCount() && d.indifferentFaces.size() < 5; ++f)
    if (d.faceLabel[f] >= 0) d.indifferentFaces.push_back(f);  // as if several labels tied there
  const Partition filled = partition(mesh, d);
  EXPECT_TRUE(isSound(mesh, d, filled));
  const Partition open = partition(mesh, d, {.leaveOutIndifferent = true});
  EXPECT_TRUE(hasItsTwins(open));
  EXPECT_EQ(open.triangles.size(), filled.triangles.size() - d.indifferentFaces.size());
  double hole = 0;
  for (const int f : d.indifferentFaces) hole += mesh.faceArea(f);
  EXPECT_NEAR(open.regions[0].area + open.regions[1].area, mesh.area() - hole, 1e-12 * mesh.area());
  for (const int f : open.triangleFace)
    EXPECT_EQ(std::count(d.indifferentFaces.begin(), d.indifferentFaces.end(), f), 0);
}

TEST(Partition, LeavesHolesWhereSitesTieBehindASaddle) {
  // Two sites as far from the middle of twelve equilateral triangles, four of them behind it.
  const auto mesh = shapes::vertexFan(12, 4 * kPi).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0), centroid(1)};
  for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
    const Diagram d = trace(mesh, sites, metric).diagram;
    ASSERT_EQ(d.indifferentFaces.size(), 4u);
    const Partition filled = partition(mesh, d);
    EXPECT_TRUE(isSound(mesh, d, filled));
    EXPECT_EQ(filled.triangles.size(), 12u);
    const Partition open = partition(mesh, d, {.leaveOutIndifferent = true});
    EXPECT_TRUE(hasItsTwins(open));
    EXPECT_EQ(open.triangles.size(), 8u);
    EXPECT_NEAR(open.regions[0].area, open.regions[1].area, 1e-12 * mesh.area());
  }
}

// --- Triangulations of convex polygons -----------------------------------------------------------

double leastAngle(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const std::array<Vector2d, 3> p = {a, b, c};
  double least = kPi;
  for (int i = 0; i < 3; ++i) {
    const Vector2d u = p[(i + 1) % 3] - p[i], v = p[(i + 2) % 3] - p[i];
    least = std::min(least, std::atan2(std::abs(u[0] * v[1] - u[1] * v[0]), u.dot(v)));
  }
  return least;
}

/// The largest least angle of all triangulations of the corners from … to.
double bestAngle(std::span<const Vector2d> p, int from, int to) {
  if (to - from < 2) return kPi;
  double best = -1;
  for (int k = from + 1; k < to; ++k)
    best = std::max(best, std::min({leastAngle(p[from], p[k], p[to]), bestAngle(p, from, k),
                                    bestAngle(p, k, to)}));
  return best;
}

TEST(ConvexTriangulation, HasTheLargestLeastAngle) {
  ConvexTriangulation triangulation;
  for (int seed = 0; seed < 300; ++seed) {
    shapes::Random random(seed);
    std::vector<double> angles(4 + seed % 5);
    for (double& a : angles) a = random.uniform(0, 2 * kPi);
    std::sort(angles.begin(), angles.end());
    std::vector<Vector2d> corners;  // on an ellipse
    const double width = random.uniform(0.05, 1);
    for (const double a : angles) corners.push_back({std::cos(a), width * std::sin(a)});
    double least = kPi;
    const auto triangles = triangulation.compute(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    for (const auto& t : triangles)
      least = std::min(least, leastAngle(corners[t[0]], corners[t[1]], corners[t[2]]));
    EXPECT_NEAR(least, bestAngle(corners, 0, static_cast<int>(corners.size()) - 1), 1e-9);
  }
}

TEST(ConvexTriangulation, MakesNoFlatTriangleAtAStraightAngle) {
  ConvexTriangulation triangulation;
  const std::vector<Vector2d> corners = {{0, 0},     {0.25, 0}, {0.5, 0}, {1, 0},
                                         {0.5, 0.5}, {0, 1},    {0, 0.5}};
  for (size_t turn = 0; turn < corners.size(); ++turn) {
    std::vector<Vector2d> turned = corners;
    std::rotate(turned.begin(), turned.begin() + turn, turned.end());
    for (const auto& t : triangulation.compute(turned))
      EXPECT_GT(leastAngle(turned[t[0]], turned[t[1]], turned[t[2]]), 0.1);
  }
}

}  // namespace
}  // namespace gvd
