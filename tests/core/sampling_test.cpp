// SPDX-License-Identifier: MIT
#include "gvd/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "diagram_checks.h"
#include "equality.h"
#include "error_checks.h"
#include "gvd/error.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::errorOf;

std::vector<SurfacePoint> first(const std::vector<SurfacePoint>& points, std::size_t count) {
  return {points.begin(), points.begin() + static_cast<long>(count)};
}

/// Whether `hits` of `draws` is within five standard deviations of what the probability promises.
void expectFrequency(int hits, int draws, double probability) {
  const double expected = draws * probability;
  const double deviation = std::sqrt(draws * probability * (1 - probability));
  EXPECT_NEAR(hits, expected, 5 * deviation);
}

TEST(SampleUniform, GivesNoPointsIfNoneAreAskedFor) {
  EXPECT_TRUE(sampleUniform(shapes::triangle().mesh(), 0, 1).empty());
}

TEST(SampleUniform, RejectsANegativeCount) {
  EXPECT_THROW(sampleUniform(shapes::triangle().mesh(), -1, 1), Error);
}

TEST(SampleUniform, GivesBarycentricCoordinatesOfExactSumOne) {
  for (const SurfacePoint& p : sampleUniform(shapes::cube().mesh(), 10000, 1)) {
    EXPECT_GE(p.bary.minCoeff(), 0);
    EXPECT_EQ(p.bary[0] + p.bary[1] + p.bary[2], 1);
  }
}

TEST(SampleUniform, GivesTheSamePointsOnEveryPlatform) {
  const std::vector<SurfacePoint> points = sampleUniform(shapes::cube().mesh(), 100, 42);
  // The first numbers of mt19937_64 with seed 42, which the C++ standard defines.
  const auto unit = [](std::uint64_t bits) { return static_cast<double>(bits >> 11) / 0x1p53; };
  const double area = unit(13930160852258120406u);
  const double u = 1 - unit(11788048577503494824u), v = 1 - unit(13874630024467741450u);  // folded
  EXPECT_EQ(points[0].face, static_cast<int>(12 * area));
  EXPECT_EQ(points[0].bary, Eigen::Vector3d(1 - u - v, u, v));
}

TEST(SampleUniform, GivesOtherPointsForAnotherSeed) {
  const TriangleMesh mesh = shapes::cube().mesh();
  EXPECT_NE(sampleUniform(mesh, 1, 1), sampleUniform(mesh, 1, 2));
}

TEST(SampleUniform, BeginsWithTheSamePointsWhateverTheCount) {
  const TriangleMesh mesh = shapes::torus(8, 6).mesh();
  const std::vector<SurfacePoint> few = sampleUniform(mesh, 10, 7);
  const std::vector<SurfacePoint> many = sampleUniform(mesh, 1000, 7);
  EXPECT_EQ(few, first(many, few.size()));
}

TEST(SampleUniform, HitsFacesByTheirArea) {
  const TriangleMesh mesh = shapes::gradedDisk(4, 5, 0.5).mesh();
  constexpr int kDraws = 100000;
  std::vector<int> hits(mesh.faceCount(), 0);
  for (const SurfacePoint& p : sampleUniform(mesh, kDraws, 3)) ++hits[p.face];
  for (int f = 0; f < mesh.faceCount(); ++f) {
    expectFrequency(hits[f], kDraws, mesh.faceArea(f) / mesh.area());
  }
}

TEST(SampleUniform, IsUniformWithinAFace) {
  constexpr int kDraws = 100000;
  // The four similar parts of a triangle cut by the middles of its sides: at a corner (0, 1, 2), or
  // the middle one.
  std::array<int, 4> hits = {};
  for (const SurfacePoint& p : sampleUniform(shapes::triangle().mesh(), kDraws, 5)) {
    int part = 3;
    for (int i = 0; i < 3; ++i) {
      if (p.bary[i] > 0.5) part = i;
    }
    ++hits[part];
  }
  for (int part : hits) expectFrequency(part, kDraws, 0.25);
}

TEST(SampleUniform, LeavesOutFacesWithoutArea) {
  shapes::Shape shape = shapes::triangle();
  const int middle = shape.addVertex({0.5, 0, 0});  // on the side 0-1: a cap
  shape.addTriangle(1, 0, middle);
  const TriangleMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.faceCount(), 2);
  for (const SurfacePoint& p : sampleUniform(mesh, 1000, 1)) EXPECT_EQ(p.face, 0);
}

TEST(SampleUniform, HitsFlatFacesByTheirIntrinsicArea) {
  shapes::Shape shape;
  for (double x : {0, 1, 2, 3}) shape.addVertex({x, 0, 0});
  shape.addTriangle(0, 1, 2);
  shape.addTriangle(2, 1, 3);
  const TriangleMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.repairs().mollifiedTriangles, 2);
  ASSERT_NEAR(mesh.faceArea(0), mesh.area() / 2, 1e-9 * mesh.area());
  constexpr int kDraws = 10000;
  int first = 0;
  for (const SurfacePoint& p : sampleUniform(mesh, kDraws, 1)) first += p.face == 0;
  expectFrequency(first, kDraws, 0.5);
}

// --- By density ----------------------------------------------------------------------------------

TEST(SampleByDensity, HitsPlacesByTheRootOfTheirDensity) {
  const auto mesh = shapes::grid(4, 4).mesh();
  std::vector<double> density;
  for (int v = 0; v < mesh.vertexCount(); ++v)
    density.push_back(mesh.position(v).x() * mesh.position(v).x());
  constexpr int kDraws = 100000;
  int left = 0;
  for (const SurfacePoint& p : sampleByDensity(mesh, density, kDraws, 1))
    left += mesh.position(p).x() < 0.3;
  expectFrequency(left, kDraws, 0.09);  // ∫ 2x
}

TEST(SampleByDensity, BeginsWithTheSamePointsWhateverTheCount) {
  const auto mesh = shapes::cube().mesh();
  const std::vector<double> density = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto few = sampleByDensity(mesh, density, 10, 7);
  const auto many = sampleByDensity(mesh, density, 100, 7);
  EXPECT_EQ(few, first(many, few.size()));
}

TEST(SampleByDensity, RejectsWhatIsNoDensity) {
  const auto mesh = shapes::triangle().mesh();
  const auto sample = [&](const std::vector<double>& density, int count = 1) {
    sampleByDensity(mesh, density, count, 1);
  };
  EXPECT_THROW(sample({1, 1}), Error);
  EXPECT_THROW(sample({0, 0, 0}), Error);
  EXPECT_THROW(sample({1, -1, 1}), Error);
  EXPECT_THROW(sample({1, NAN, 1}), Error);
  EXPECT_THROW(sample({1, 1, 1}, -1), Error);
}

// --- Farthest ------------------------------------------------------------------------------------

double distanceBetween(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return (mesh.position(a) - mesh.position(b)).norm();
}

double leastDistance(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points) {
  double least = 1e300;
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      least = std::min(least, distanceBetween(mesh, points[i], points[j]));
  return least;
}

/// The distance of every vertex to the nearest point, for a mesh that is plane and convex.
std::vector<double> planeDistances(const TriangleMesh& mesh,
                                   const std::vector<SurfacePoint>& points) {
  std::vector<double> result(mesh.vertexCount(), 1e300);
  for (int v = 0; v < mesh.vertexCount(); ++v)
    for (const SurfacePoint& p : points)
      result[v] = std::min(result[v], (mesh.position(v) - mesh.position(p)).norm());
  return result;
}

TEST(SampleFarthest, TakesTheFarthestVertexOfThePlane) {
  for (int seed = 0; seed < 5; ++seed) {
    const auto mesh = shapes::grid(12, 9, 0.2, seed).mesh();
    const auto points = sampleFarthest(mesh, 40, seed);
    ASSERT_EQ(points.size(), 40u);
    EXPECT_EQ(first(points, 1), sampleUniform(mesh, 1, seed));
    for (size_t n = 1; n < points.size(); ++n) {
      const auto before = planeDistances(mesh, {points.begin(), points.begin() + n});
      const double farthest = *std::max_element(before.begin(), before.end());
      double taken = 1e300;
      for (size_t i = 0; i < n; ++i)
        taken = std::min(taken, distanceBetween(mesh, points[i], points[n]));
      EXPECT_NEAR(taken, farthest, 1e-9) << n;
    }
  }
}

TEST(SampleFarthest, KeepsThePointsFarApartOnCurvedSurfaces) {
  const auto mesh = shapes::torus(60, 30).mesh();
  const auto points = sampleFarthest(mesh, 50, 1);
  // In space they are no farther apart than on the surface.
  // 0.95 is as much as disks in the plane could have; farthest point sampling reaches about 0.7.
  EXPECT_GT(leastDistance(mesh, points), 0.6 * std::sqrt(2 * mesh.area() / (std::sqrt(3.0) * 50)));
}

TEST(SampleFarthest, CoversTheSurface) {
  const auto mesh = shapes::grid(20, 20, 0.2, 1).mesh();
  const auto points = sampleFarthest(mesh, 1000, 1, 0.15);
  EXPECT_LT(points.size(), 120u);
  for (const double d : planeDistances(mesh, points)) EXPECT_LE(d, 0.15 * (1 + 1e-9));
}

TEST(SampleFarthest, GivesEveryComponentAPointFirst) {
  auto shape = shapes::cube();
  for (int i = 1; i < 5; ++i)
    shape = shapes::joined(shape, shapes::moved(shapes::cube(), {2.0 * i, 0, 0}));
  const auto mesh = shape.mesh();
  std::set<int> components;
  for (const SurfacePoint& p : sampleFarthest(mesh, 5, 3))
    components.insert(mesh.component(p.face));
  EXPECT_EQ(components.size(), 5u);
}

TEST(SampleFarthest, EndsWhenEveryVertexIsTaken) {
  const auto mesh = shapes::cube().mesh();
  const auto points = sampleFarthest(mesh, 100, 1);
  EXPECT_EQ(points.size(), 9u);  // the first one is in a face
  EXPECT_TRUE(sampleFarthest(mesh, 0, 1).empty());
  EXPECT_THROW(sampleFarthest(mesh, -1, 1), Error);
}

// --- Poisson disk --------------------------------------------------------------------------------

TEST(SamplePoissonDisk, KeepsItsDistanceAndCoversThePlane) {
  const std::vector<TriangleMesh> meshes = {shapes::grid(20, 20, 0.2, 1).mesh(),
                                            shapes::grid(2, 2).mesh(),
                                            shapes::gradedDisk(8, 9, 0.6).mesh()};
  for (const TriangleMesh& mesh : meshes)
    for (const double radius : {0.05, 0.2, 0.7}) {
      const PoissonDisk sample = samplePoissonDisk(mesh, radius, 1);
      EXPECT_EQ(sample.radius, radius);
      EXPECT_GE(leastDistance(mesh, sample.points), radius * (1 - 1e-9));
      for (const double d : planeDistances(mesh, sample.points)) EXPECT_LE(d, radius * (1 + 1e-9));
      // At least half of what fits if nothing is left to chance.
      EXPECT_GT(sample.points.size(), 0.5 * 2 / (std::sqrt(3.0) * radius * radius));
    }
}

/// Paths bend at the corners of holes, where unfolded distances err by a fifth.
TEST(SampleByRadius, LeavesNoVertexFartherByExactDistances) {
  const auto mesh = shapes::perforatedPlate(3, 8).mesh();
  for (const double share : {0.07, 0.15, 0.4})
    for (const std::uint64_t seed : {1, 2}) {
      const double radius = share * mesh.boundingDiagonal();
      for (const auto& points : {sampleFarthest(mesh, 100000, seed, radius),
                                 samplePoissonDisk(mesh, radius, seed).points}) {
        const auto field = finished(propagate(mesh, points, Metric::kExact));
        for (int v = 0; v < mesh.vertexCount(); ++v)
          ASSERT_LE(nearestOf(field->at(v)).distance, radius * (1 + 1e-12)) << share << ' ' << v;
      }
      EXPECT_EQ(sampleFarthest(mesh, 2, seed, radius).size(), 2u);
    }
}

TEST(SamplePoissonDisk, KeepsItsDistanceOnASphere) {
  const auto mesh = shapes::icosphere(4).mesh();
  const PoissonDisk sample = samplePoissonDisk(mesh, 0.3, 1);
  // The chord of an arc of length 0.3.
  EXPECT_GT(leastDistance(mesh, sample.points), 2 * std::sin(0.15) * 0.99);
  EXPECT_GT(sample.points.size(), 80u);
}

TEST(SamplePoissonDisk, GivesAsManyPointsAsAskedFor) {
  const auto mesh = shapes::grid(10, 10, 0.2, 1).mesh();
  for (const int count : {0, 1, 7, 300}) {
    const PoissonDisk sample = samplePoissonDiskCount(mesh, count, 5);
    ASSERT_EQ(sample.points.size(), static_cast<size_t>(count));
    if (count < 2) continue;
    EXPECT_GE(leastDistance(mesh, sample.points), sample.radius * (1 - 1e-9));
    EXPECT_GT(sample.radius, 0.6 * std::sqrt(2 / (std::sqrt(3.0) * count)));
  }
}

TEST(SamplePoissonDisk, DependsOnItsSeedOnly) {
  const auto mesh = shapes::torus(20, 10).mesh();
  const auto a = samplePoissonDisk(mesh, 0.3, 1), b = samplePoissonDisk(mesh, 0.3, 1);
  EXPECT_EQ(a.points, b.points);
  EXPECT_NE(a.points[0], samplePoissonDisk(mesh, 0.3, 2).points[0]);
}

TEST(SamplePoissonDisk, RejectsWhatCannotBe) {
  const auto mesh = shapes::cube().mesh();
  for (const double radius : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_THROW(samplePoissonDisk(mesh, radius, 1), Error);
  EXPECT_EQ(errorOf([&] { samplePoissonDisk(mesh, 1e-9, 1); }, ErrorCode::kInvalidArgument),
            "with the radius 1e-9 there would be more than 2147483647 Poisson disks");
  EXPECT_THROW(samplePoissonDiskCount(mesh, -1, 1), Error);
}

// --- The worst region first ----------------------------------------------------------------------

TEST(SampleWorstFirst, SplitsTheLargestRegionFarFromItsSite) {
  for (const TriangleMesh& mesh : {shapes::grid(12, 12, 0.2, 1).mesh(),
                                   shapes::torus(20, 10).mesh(), shapes::icosphere(2).mesh()}) {
    const auto points = sampleWorstFirst(mesh, 20, 3, WorstRegion::kSize);
    ASSERT_EQ(points.size(), 20u);
    EXPECT_EQ(first(points, 1), sampleUniform(mesh, 1, 3));
    for (int n = 1; n < 20; ++n) {
      const auto [distances, diagram] = checks::trace(mesh, std::span(points).first(n));
      const LabelledDistance nearest = distances->nearest(points[n]);
      const double largest =
          *std::max_element(diagram.regionArea.begin(), diagram.regionArea.end());
      // On the outline of the region a neighbour is as near, but for what bisectors are
      // straightened.
      const double own = distances->distance(
          static_cast<int>(std::find_if(diagram.regionArea.begin(), diagram.regionArea.end(),
                                        [&](double a) { return a > largest * (1 - 1e-9); }) -
                           diagram.regionArea.begin()),
          points[n]);
      EXPECT_NEAR(own, nearest.distance, 0.1 * own) << n;
      EXPECT_GT(own, 0.3 * std::sqrt(largest / 3.15)) << n;
    }
  }
}

TEST(SampleWorstFirst, BeginsWithTheSamePointsWhateverTheCount) {
  const TriangleMesh mesh = shapes::torus(12, 8).mesh();
  const auto few = sampleWorstFirst(mesh, 5, 1, WorstRegion::kDistortion);
  const auto many = sampleWorstFirst(mesh, 15, 1, WorstRegion::kDistortion);
  EXPECT_EQ(few, first(many, few.size()));
  EXPECT_TRUE(sampleWorstFirst(mesh, 0, 1, WorstRegion::kSize).empty());
  EXPECT_THROW(sampleWorstFirst(mesh, -1, 1, WorstRegion::kSize), Error);
}

TEST(SampleWorstFirst, ByDistortionGoesWhereTheSurfaceBends) {
  // A large plane, and a sphere of a hundredth of its size.
  const TriangleMesh mesh =
      shapes::joined(shapes::scaled(shapes::grid(10, 10), 36), shapes::icosphere(2)).mesh();
  ASSERT_EQ(mesh.topology().components, 2);
  const auto onSphere = [&](WorstRegion worst) {
    const auto points = sampleWorstFirst(mesh, 20, 1, worst);
    return std::count_if(points.begin(), points.end(),
                         [&](const SurfacePoint& p) { return mesh.component(p.face) == 1; });
  };
  EXPECT_EQ(onSphere(WorstRegion::kSize), 1);
  EXPECT_EQ(onSphere(WorstRegion::kDistortion), 19);
}

TEST(SampleWorstFirst, ByDistortionIsBySizeWhereAllIsFlat) {
  const TriangleMesh mesh = shapes::grid(9, 9, 0.2, 4).mesh();
  const auto bySize = sampleWorstFirst(mesh, 30, 2, WorstRegion::kSize);
  const auto byDistortion = sampleWorstFirst(mesh, 30, 2, WorstRegion::kDistortion);
  EXPECT_EQ(bySize, byDistortion);
}

TEST(WorstRegions, FollowADiagramOfWhichSitesComeGoAndMove) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 4, 0.3, 1).mesh();
  for (const WorstRegion worst : {WorstRegion::kSize, WorstRegion::kDistortion}) {
    DynamicDiagram diagram(mesh, sampleUniform(mesh, 10, 1));
    WorstRegions regions(mesh, diagram.distances(), diagram.diagram(), worst);
    const auto places = sampleUniform(mesh, 30, 2);
    for (int i = 0; i < 30; ++i) {
      // Two come, one goes, one moves.
      const DiagramChange change = i % 4 < 2    ? diagram.insertSite(places[i])
                                   : i % 4 == 2 ? diagram.removeSite(i / 4)
                                                : diagram.moveSite(i / 4 + 1, places[i]);
      if (i % 3 == 0) {
        regions.follow(change);
      } else {
        const auto steps = regions.startFollow(change);
        int count = 1;
        while (!steps->step(1)) ++count;
        EXPECT_GT(count, 10);
      }
      const WorstRegions anew(mesh, diagram.distances(), diagram.diagram(), worst);
      EXPECT_NEAR((mesh.position(regions.point()) - mesh.position(anew.point())).norm(), 0,
                  1e-9 * mesh.boundingDiagonal())
          << i;
    }
  }
}

TEST(WorstRegions, PointIsOnAComponentWithoutASiteFirst) {
  const TriangleMesh mesh =
      shapes::joined(shapes::grid(5, 5), shapes::moved(shapes::triangle(), {5, 0, 0})).mesh();
  const std::vector<SurfacePoint> sites = {{0, {1, 0, 0}}};
  const auto [distances, diagram] = checks::trace(mesh, sites);
  EXPECT_EQ(WorstRegions(mesh, *distances, diagram, WorstRegion::kSize).point().face, 50);
}

// --- Components ----------------------------------------------------------------------------------

/// A grid of 50 triangles, 5 single triangles.
TriangleMesh sixComponents() {
  shapes::Shape shape = shapes::grid(5, 5);
  for (int i = 1; i <= 5; ++i)
    shape = shapes::joined(shape,
                           shapes::moved(shapes::scaled(shapes::triangle(), 0.1), {2.0 * i, 0, 0}));
  return shape.mesh();
}

std::vector<int> perComponent(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<int> count(mesh.topology().components, 0);
  for (const SurfacePoint& p : points) ++count[mesh.component(p.face)];
  return count;
}

TEST(CoverComponents, MakesRoomAmongTheLastPoints) {
  const TriangleMesh mesh = sixComponents();
  const auto points = sampleUniform(mesh, 40, 1);
  ASSERT_GT(perComponent(mesh, points)[0], 34);
  const auto covered = coverComponents(mesh, points, 2, 40, 1);
  EXPECT_EQ(perComponent(mesh, covered), (std::vector<int>{30, 2, 2, 2, 2, 2}));
  EXPECT_EQ(first(covered, 20), first(points, 20));
}

TEST(CoverComponents, AddsWhereThereIsRoom) {
  const TriangleMesh mesh = sixComponents();
  const std::vector<SurfacePoint> points = {{0, {1, 0, 0}}, {50, {1, 0, 0}}, {50, {0, 1, 0}}};
  const auto covered = coverComponents(mesh, points, 1, 100, 1);
  EXPECT_EQ(perComponent(mesh, covered), (std::vector<int>{1, 2, 1, 1, 1, 1}));
  EXPECT_EQ(perComponent(mesh, coverComponents(mesh, points, 1, 6, 1)),
            (std::vector<int>{1, 1, 1, 1, 1, 1}));
}

TEST(CoverComponents, LeavesPointsThatCoverAll) {
  const TriangleMesh mesh = shapes::torus(8, 6).mesh();
  const auto points = sampleUniform(mesh, 10, 1);
  for (const int least : {0, 1, 10}) {
    EXPECT_EQ(coverComponents(mesh, points, least, 10, 1), points);
  }
}

TEST(CoverComponents, KeepsLabelsWithoutSite) {
  const TriangleMesh mesh = sixComponents();
  const std::vector<SurfacePoint> points = {{}, {0, {1, 0, 0}}, {}, {50, {1, 0, 0}}};
  const auto covered = coverComponents(mesh, points, 1, 6, 1);
  ASSERT_EQ(covered.size(), 8u);
  EXPECT_EQ(covered[0].face, -1);
  EXPECT_EQ(covered[1], points[1]);
  EXPECT_EQ(covered[2].face, -1);
  EXPECT_THROW(coverComponents(mesh, {{mesh.faceCount(), {1, 0, 0}}}, 1, 6, 1), Error);
}

TEST(CoverComponents, RejectsCountsThatDoNotSuffice) {
  const TriangleMesh mesh = sixComponents();
  EXPECT_EQ(errorOf([&] { coverComponents(mesh, {}, 2, 11, 1); }, ErrorCode::kInvalidArgument),
            "2 per component, of which the mesh has 6, makes 12 sites, more than the 11 in all");
  EXPECT_THROW(coverComponents(mesh, {}, -1, 11, 1), Error);
  EXPECT_THROW(coverComponents(mesh, {}, 2147483647, 2147483647, 1), Error);
}

TEST(SampleFarthest, RefusesACoveringRadiusThatIsNone) {
  const auto mesh = shapes::cube().mesh();
  EXPECT_THROW(sampleFarthest(mesh, 3, 1, -1), Error);
  EXPECT_THROW(sampleFarthest(mesh, 3, 1, NAN), Error);
  EXPECT_EQ(sampleFarthest(mesh, 3, 1, kInfinity).size(), 1u);
}

TEST(BareComponents, RefuseAPointThatIsNotOnTheMesh) {
  const auto mesh = shapes::cube().mesh();
  for (const SurfacePoint& p : {SurfacePoint{12, Eigen::Vector3d(1, 0, 0)}, SurfacePoint{-2, {}},
                                SurfacePoint{0, Eigen::Vector3d(1, 1, 0)}})
    EXPECT_THROW(bareComponents(mesh, std::vector{p}), Error);
  EXPECT_EQ(bareComponents(mesh, std::vector{SurfacePoint()}).components, 1);
}

TEST(BareComponents, AreThoseWithoutAPoint) {
  const TriangleMesh mesh = sixComponents();
  const std::vector<SurfacePoint> points = {{0, {1, 0, 0}}, {52, {1, 0, 0}}};
  const BareComponents bare = bareComponents(mesh, points);
  EXPECT_EQ(bare.components, 4);
  EXPECT_NEAR(bare.area, 4 * 0.005, 1e-15);
  EXPECT_EQ(bareComponents(mesh, {}).components, 6);
  EXPECT_NEAR(bareComponents(mesh, {}).area, mesh.area(), 1e-12);
}

}  // namespace
}  // namespace gvd
