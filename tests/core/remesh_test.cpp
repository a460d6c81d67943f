// SPDX-License-Identifier: MIT
#include "gvd/remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "diagram_checks.h"
#include "error_checks.h"
#include "gvd/closest_point.h"
#include "gvd/cvt.h"
#include "gvd/dual.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mesh/nearest_on_triangle.h"
#include "mesh/triangle_tree.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::errorOf;
using Eigen::Vector3d;

Vector3d randomPoint(shapes::Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(TriangleTree, FindsWhatLookingAtEveryTriangleFinds) {
  shapes::Random random(1);
  for (const int count : {1, 2, 4, 5, 9, 200}) {
    std::vector<SpaceTriangle> triangles(count);
    for (auto& triangle : triangles) {
      const Vector3d centre = randomPoint(random);
      for (Vector3d& corner : triangle) corner = centre + 0.2 * randomPoint(random);
    }
    TriangleTree tree(triangles);
    for (long budget = 3; !tree.step(budget); budget = 3) {
    }
    for (int i = 0; i < 100; ++i) {
      const Vector3d p = 1.5 * randomPoint(random);
      double least = std::numeric_limits<double>::infinity();
      for (const auto& t : triangles) {
        const Vector3d bary = nearestOnTriangle(p, t).bary;
        EXPECT_NEAR(bary.sum(), 1, 1e-12);
        EXPECT_GE(bary.minCoeff(), 0);
        least = std::min(least, (bary[0] * t[0] + bary[1] * t[1] + bary[2] * t[2] - p).norm());
      }
      EXPECT_DOUBLE_EQ(std::sqrt(tree.nearest(p).squaredDistance), least);
    }
  }
  const TriangleTree empty(std::vector<SpaceTriangle>{});
  EXPECT_EQ(empty.nearest({0, 0, 0}).triangle, -1);
}

TEST(NearestOnTriangle, IsNotFartherThanAnySample) {
  shapes::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const SpaceTriangle t = {randomPoint(random), randomPoint(random), randomPoint(random)};
    const Vector3d p = 2 * randomPoint(random), bary = nearestOnTriangle(p, t).bary;
    const double distance = (bary[0] * t[0] + bary[1] * t[1] + bary[2] * t[2] - p).norm();
    for (int a = 0; a <= 10; ++a)
      for (int b = 0; a + b <= 10; ++b)
        EXPECT_LE(distance, ((a * t[0] + b * t[1] + (10 - a - b) * t[2]) / 10 - p).norm() + 1e-12);
  }
}

/// On needles and on caps, whose third corner is beside the longest side. The error was that of the
/// squared area: from 1e-6 of the length on, the height.
TEST(NearestOnTriangle, OfAPointOnAThinTriangleIsThatPoint) {
  shapes::Random random(3);
  for (const double height : {1e-3, 1e-5, 1e-7, 1e-10}) {
    for (int i = 0; i < 200; ++i) {
      const Vector3d u = randomPoint(random).normalized();
      const Vector3d v = u.cross(randomPoint(random)).normalized();
      const Vector3d from = randomPoint(random);
      SpaceTriangle t = {from, from + u, from + random.uniform() * u + height * v};
      std::rotate(t.begin(), t.begin() + i % 3, t.end());
      const double a = random.uniform(), b = (1 - a) * random.uniform();
      const Vector3d p = a * t[0] + b * t[1] + (1 - a - b) * t[2];
      const Vector3d bary = nearestOnTriangle(p, t).bary;
      EXPECT_NEAR((bary[0] * t[0] + bary[1] * t[1] + bary[2] * t[2] - p).norm(), 0, 2e-15);
    }
  }
}

/// The mesh itself as polygons.
PolygonMesh asPolygons(const TriangleMesh& mesh) {
  PolygonMesh result;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const int h = mesh.outgoing(v);
    result.points.push_back({h / 3, Vector3d::Unit(h % 3)});
    result.positions.push_back(mesh.position(v));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
    result.faces.add(
        std::vector<int>{mesh.tail(3 * f), mesh.tail(3 * f + 1), mesh.tail(3 * f + 2)});
  return result;
}

TEST(RemeshQuality, OfAnIcosahedronIsThatOfItsTriangles) {
  const TriangleMesh mesh = shapes::icosphere(0).mesh();
  const RemeshQuality quality = measureQuality(mesh, asPolygons(mesh));
  EXPECT_EQ(quality.triangles, 20);
  EXPECT_NEAR(quality.minAngle, 60, 1e-9);
  EXPECT_NEAR(quality.meanMinAngle, 60, 1e-9);
  EXPECT_EQ(quality.minValence, 5);
  EXPECT_EQ(quality.maxValence, 5);
  EXPECT_EQ(quality.regularShare, 0);
  EXPECT_NEAR(quality.hausdorff, 0, 1e-12);
}

TEST(RemeshQuality, KnowsTheDistanceOfAnIcosahedronFromASphere) {
  // The middles of its faces are deepest inside.
  const TriangleMesh coarse = shapes::icosphere(0).mesh(), sphere = shapes::icosphere(4).mesh();
  const double depth = 1 - coarse.position({0, Vector3d::Constant(1.0 / 3)}).norm();
  EXPECT_NEAR(measureQuality(sphere, asPolygons(coarse)).hausdorff, depth, 0.02 * depth);
  EXPECT_NEAR(measureQuality(coarse, asPolygons(sphere)).hausdorff, depth, 0.02 * depth);
}

/// The largest distance of a fine grid of points on one mesh from the other.
double farthestSample(const TriangleMesh& from, const TriangleMesh& to) {
  constexpr int kRows = 40;
  const ClosestPointQuery query(to);
  double farthest = 0;
  for (int f = 0; f < from.faceCount(); ++f)
    for (int a = 0; a <= kRows; ++a)
      for (int b = 0; a + b <= kRows; ++b) {
        const Vector3d bary = Vector3d(a, b, kRows - a - b) / kRows;
        farthest = std::max(farthest, query.closestTo(from.position({f, bary})).distance);
      }
  return farthest;
}

/// The farthest points were on sides of the twelve-sided ends, half as far again as any sample.
TEST(RemeshQuality, FindsTheFarthestPointOfAFaceWithManyTrianglesBesideIt) {
  const TriangleMesh surface = shapes::cylinder(12, 1).mesh();
  for (const int count : {20, 60, 300}) {
    const RepairedSites valid = repair(surface, sampleUniform(surface, count, 3), Metric::kExact);
    const PolygonMesh dual = dualMesh(surface, valid.sites, valid.diagram);
    std::vector<double> positions;
    for (const Vector3d& p : dual.positions) positions.insert(positions.end(), p.begin(), p.end());
    std::vector<int> triangles;
    for (const auto& t : triangulate(dual).triangles)
      triangles.insert(triangles.end(), t.begin(), t.end());
    const TriangleMesh remesh(positions, triangles);
    const double sampled =
        std::max(farthestSample(surface, remesh), farthestSample(remesh, surface));
    EXPECT_GE(measureQuality(surface, dual).hausdorff, 0.99 * sampled) << count << " sites";
    EXPECT_LE(measureQuality(surface, dual).hausdorff, 1.02 * sampled) << count << " sites";
  }
}

/// A unit square, and a narrow wall on one of its sides and another across it at x = 0.8: the
/// points halfway between the walls are farthest. The search had ended at x = 0.375.
TEST(RemeshQuality, FindsThePointsHalfwayBetweenTwoWalls) {
  const TriangleMesh square = shapes::grid(1, 1).mesh();
  PolygonMesh walls;
  for (const double x : {0.0, 0.8}) {
    const int first = static_cast<int>(walls.positions.size());
    for (const Vector3d& p : {Vector3d(x, 0, 0), Vector3d(x, 1, 0), Vector3d(x, 0.5, 0.01)})
      walls.positions.push_back(p);
    walls.faces.add(std::array{first, first + 1, first + 2});
  }
  const double distance = measureQuality(square, walls).hausdorff;
  EXPECT_GE(distance, 0.99 * 0.4);
  EXPECT_LE(distance, 0.4);
}

TEST(RemeshQuality, OfPositionsThatAreNotFiniteIsInfinitelyFar) {
  const TriangleMesh mesh = shapes::icosphere(1).mesh();
  for (const double fault :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    PolygonMesh remesh = asPolygons(mesh);
    remesh.positions[5].y() = fault;
    EXPECT_EQ(measureQuality(mesh, remesh).hausdorff, std::numeric_limits<double>::infinity());
  }
}

TEST(RemeshQuality, CountsNeighboursOfVerticesInsideOnly) {
  const TriangleMesh mesh = shapes::grid(4, 4).mesh();
  const RemeshQuality quality = measureQuality(mesh, asPolygons(mesh));
  EXPECT_EQ(quality.minValence, 6);
  EXPECT_EQ(quality.maxValence, 6);
  EXPECT_EQ(quality.regularShare, 1);
  EXPECT_NEAR(quality.minAngle, 45, 1e-9);
}

TEST(RemeshQuality, OfNothingIsInfinitelyFar) {
  const TriangleMesh mesh = shapes::icosphere(0).mesh();
  const RemeshQuality quality = measureQuality(mesh, {});
  EXPECT_EQ(quality.triangles, 0);
  EXPECT_EQ(quality.hausdorff, std::numeric_limits<double>::infinity());
}

TEST(RemeshQuality, OfACentroidalTessellationIsHigh) {
  const TriangleMesh mesh = shapes::icosphere(3).mesh();
  CvtOptions options;
  options.iterations = 30;
  Cvt cvt(mesh, sampleUniform(mesh, 100, 1), options);
  while (!cvt.isDone()) cvt.step(100000);
  const RepairedSites valid = repair(mesh, cvt.sites(), Metric::kExact);
  const RemeshQuality quality = measureQuality(mesh, dualMesh(mesh, valid.sites, valid.diagram));
  EXPECT_EQ(quality.triangles, 2 * static_cast<int>(valid.sites.size()) - 4);
  EXPECT_GT(quality.minAngle, 30);
  EXPECT_GT(quality.meanMinAngle, 50);
  EXPECT_GE(quality.minValence, 5);
  EXPECT_LE(quality.maxValence, 7);
}

TEST(Remesh, HasAValidDualAndKeepsLabelsAndFixedSites) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 3, 0.1, 1).mesh();
  const auto sites = sampleFarthest(mesh, 40, 1);
  const RepairedSites remeshed =
      remesh(mesh, sites, {.tessellation = {.iterations = 10, .fixedSites = {3}}});
  EXPECT_EQ(remeshed.sites.size(), sites.size() + remeshed.added);
  EXPECT_EQ(remeshed.diagram.siteCount, static_cast<int>(remeshed.sites.size()));
  EXPECT_TRUE(findViolations(mesh, remeshed.sites, remeshed.diagram).empty());
  EXPECT_EQ(remeshed.sites[3].bary, sites[3].bary);
  EXPECT_NE(remeshed.sites[4].bary, sites[4].bary);
  const auto meanAngle = [&](const RepairedSites& r) {
    return measureQuality(mesh, dualMesh(mesh, r.sites, r.diagram)).meanMinAngle;
  };
  EXPECT_GT(meanAngle(remeshed), meanAngle(repair(mesh, sites, Metric::kExact)));
}

TEST(Remesh, RefusesWhatTakesMoreSitesThanAllowed) {
  const TriangleMesh mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {mesh.fromInputVertex(0), mesh.fromInputVertex(3)};
  errorOf([&] { remesh(mesh, sites, {.maxAdded = 1}); }, ErrorCode::kTooFewSites);
  EXPECT_THROW(remesh(mesh, sites, {.maxAdded = -1}), Error);
}

/// Meshes of polygons are made by callers, too.
TEST(PolygonMesh, RefusesFacesOfVerticesThatDoNotExist) {
  const TriangleMesh cube = shapes::cube().mesh();
  for (const int absent : {-1, 3}) {
    PolygonMesh polygons;
    polygons.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    polygons.faces.add(std::vector<int>{0, 1, 2});
    EXPECT_TRUE(topologyOf(polygons).isManifold);
    EXPECT_EQ(measureQuality(cube, polygons).triangles, 1);
    polygons.faces.add(std::vector<int>{1, 0, absent});
    EXPECT_THROW(topologyOf(polygons), Error);
    EXPECT_THROW(triangulate(polygons), Error);
    EXPECT_THROW(measureQuality(cube, polygons), Error);
  }
}

TEST(Triangulate, KeepsSidesAndTurnsNoTriangleOver) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 3, 0.1, 1).mesh();
  const RepairedSites valid = repair(mesh, sampleFarthest(mesh, 60, 1), Metric::kExact);
  for (const PolygonMesh& polygons :
       {dualMesh(mesh, valid.sites, valid.diagram), regionMesh(mesh, valid.diagram)}) {
    const PolygonTriangles cut = triangulate(polygons);
    PolygonMesh triangles = polygons;
    triangles.faces = {};
    for (const auto& triangle : cut.triangles) triangles.faces.add(triangle);
    const PolygonTopology before = topologyOf(polygons), after = topologyOf(triangles);
    EXPECT_TRUE(after.isManifold);
    EXPECT_EQ(after.eulerCharacteristic, before.eulerCharacteristic);
    EXPECT_EQ(after.genus, 1);
    EXPECT_EQ(after.vertices, before.vertices);
  }
}

/// Two polygons on both sides of 0-1-2, which is bent at 1: 0-2 is a Delaunay diagonal of both.
TEST(Triangulate, JoinsNoTwoVerticesTwice) {
  const std::vector<std::vector<std::vector<int>>> cases = {{{0, 1, 2, 3}, {5, 2, 1, 0}},
                                                            {{0, 1, 2, 3, 4}, {6, 5, 2, 1, 0}}};
  for (const auto& faces : cases) {
    PolygonMesh polygons;
    polygons.positions = {{0, 0, 0},  {1, 0, 2},   {2, 0, 0},  {2, 2, -2},
                          {0, 2, -2}, {2, -2, -2}, {0, -2, -2}};
    for (const auto& face : faces) polygons.faces.add(face);
    ASSERT_TRUE(topologyOf(polygons).isManifold);
    PolygonMesh triangles = polygons;
    triangles.faces = {};
    for (const auto& triangle : triangulate(polygons).triangles) triangles.faces.add(triangle);
    EXPECT_EQ(triangles.faces.size(), 2 * (static_cast<int>(faces[0].size()) - 2));
    EXPECT_TRUE(topologyOf(triangles).isManifold);
  }
}

}  // namespace
}  // namespace gvd
