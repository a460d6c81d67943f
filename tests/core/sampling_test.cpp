// SPDX-License-Identifier: MIT
#include "gvd/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "gvd/error.h"
#include "shapes.h"

namespace gvd {
namespace {

bool samePoint(const SurfacePoint& p, const SurfacePoint& q) {
  return p.face == q.face && p.bary == q.bary;
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
  EXPECT_FALSE(samePoint(sampleUniform(mesh, 1, 1)[0], sampleUniform(mesh, 1, 2)[0]));
}

TEST(SampleUniform, BeginsWithTheSamePointsWhateverTheCount) {
  const TriangleMesh mesh = shapes::torus(8, 6).mesh();
  const std::vector<SurfacePoint> few = sampleUniform(mesh, 10, 7);
  const std::vector<SurfacePoint> many = sampleUniform(mesh, 1000, 7);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_TRUE(samePoint(few[i], many[i])) << i;
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

TEST(SampleUniform, HitsAllFacesAlikeIfNoneHasArea) {
  shapes::Shape shape;
  for (double x : {0, 1, 2, 3}) shape.addVertex({x, 0, 0});
  shape.addTriangle(0, 1, 2);
  shape.addTriangle(2, 1, 3);
  const TriangleMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.area(), 0);
  constexpr int kDraws = 10000;
  int first = 0;
  for (const SurfacePoint& p : sampleUniform(mesh, kDraws, 1)) first += p.face == 0;
  expectFrequency(first, kDraws, 0.5);
}

}  // namespace
}  // namespace gvd
