// SPDX-License-Identifier: MIT
//
// What `TriangleMesh` makes of faces that are no triangles: flat, tiny, or both.

#include "mesh/building/mollification.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "gvd/triangle_mesh.h"
#include "mesh/face_layout.h"
#include "shapes.h"

namespace gvd {
namespace {

using Eigen::Vector3d;
using shapes::Shape;
using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Shape shapeOf(const std::vector<Vector3d>& positions, const std::vector<int>& triangles) {
  Shape shape;
  for (const Vector3d& p : positions) shape.addVertex(p);
  shape.triangles = triangles;
  return shape;
}

// --- Flat and tiny faces, as they occur ----------------------------------------------------------

/// A triangle on one side of an edge, two on the other side that meet in the middle of it. The gap
/// between them is filled by a face without height.
Shape tJunction() {
  return shapeOf({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                 {0, 1, 2, 1, 0, 3, 3, 0, 4, 1, 3, 4});
}

/// A fan around vertex 1, all of it on one line.
Shape fanOnALine() {
  const Vector3d direction(1, 2, -1);
  return shapeOf({3 * direction, 2 * direction, {0, 0, 0}, -0.38897914627289654 * direction},
                 {0, 1, 2, 2, 3, 0, 1, 0, 3});
}

/// A grid, all of its vertices moved onto one line.
Shape gridOnALine() {
  Shape shape = shapes::grid(4, 4, 0.2, 1);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    const Vector3d p = shape.position(v);
    shape.setPosition(v, (p.x() + 0.37 * p.y()) * Vector3d(0.3, 0.1, -0.7));
  }
  return shape;
}

/// Vertices on edges of a grid's faces, which are divided into faces with and without area.
Shape gridWithFlatFaces() {
  Shape shape = shapes::grid(3, 3);
  const std::vector<int> whole = std::exchange(shape.triangles, {});
  for (std::size_t t = 0; t < whole.size(); t += 3) {
    const int a = whole[t], b = whole[t + 1], c = whole[t + 2];
    const double share = 0.3 + 0.01 * static_cast<double>(t);
    const int middle = shape.addVertex((1 - share) * shape.position(a) + share * shape.position(b));
    shape.addTriangle(a, b, middle);
    shape.addTriangle(a, middle, c);
    shape.addTriangle(middle, b, c);
  }
  return shape;
}

/// A tube with a disk at one end whose middle is not one vertex but a ring of them, as cosine and
/// sine of rounded angles make it: next to each other, 1e-17 apart.
Shape tubeWithRoundedPole() {
  constexpr int kAround = 16;
  Shape shape;
  const double radii[] = {1, 1, 0.6, std::cos(pi / 2)};
  const double heights[] = {0, 1, 1.5, 1.7};
  for (int ring = 0; ring < 4; ++ring) {
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * pi * i / kAround;
      shape.addVertex(
          {radii[ring] * std::sin(angle), heights[ring], radii[ring] * std::cos(angle)});
    }
  }
  for (int ring = 0; ring < 3; ++ring) {
    for (int i = 0; i < kAround; ++i) {
      const int a = kAround * ring + i, b = kAround * ring + (i + 1) % kAround;
      shape.addQuad(a, b, b + kAround, a + kAround);
    }
  }
  return shape;
}

/// An outline closed by the sine of π, 2.4e-16 beside its beginning.
Shape outlineThatAlmostCloses() {
  return shapeOf({{1, 0, 0}, {1, 2 * std::sin(pi), 0}, {2, -2, 0}, {0, 0, 0}}, {0, 1, 2, 1, 0, 3});
}

/// A surface so far from the origin that all its coordinates are rounded to `unit`.
Shape roundedTo(double unit, const Shape& shape) {
  Shape rounded = shape;
  for (double& x : rounded.positions) x = unit * std::round(x / unit);
  return rounded;
}

Shape farFromOrigin() {
  return shapes::moved(roundedTo(0x1p-4, shapes::randomTriangulation(60, 40, 1)),
                       {0x1p40, -0x1p40, 0x1p40});
}

/// Two of three coordinates lost by rounding: every face is on one line.
Shape farAlongAPlane() {
  Shape shape = shapes::icosphere(1);
  for (int v = 0; v < shape.vertexCount(); ++v)
    shape.setPosition(v, {931015491584, -931015491584, shape.position(v).z()});
  return shape;
}

/// A torus of size 1e21 × 1e18 × 100.
Shape torusOfUnequalScales() { return shapes::scaled(shapes::torus(4, 4), {5e21, 2e18, 160}); }

/// Needles to 1e15.
Shape needles() {
  Shape shape;
  for (int i = 0; i <= 8; ++i) {
    const double width = std::pow(10, -2 * i + 1);
    shape.addVertex({double(i), -width, 0});
    shape.addVertex({double(i), width, 0});
  }
  for (int i = 0; i < 16; i += 2) shape.addQuad(i, i + 2, i + 3, i + 1);
  return shape;
}

struct Case {
  std::string name;
  Shape shape;
};

void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }

std::vector<Case> degenerateCases() {
  return {{"triangle on a line", shapeOf({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {0, 1, 2})},
          {"T junction", tJunction()},
          {"fan on a line", fanOnALine()},
          {"grid on a line", gridOnALine()},
          {"grid with flat faces", gridWithFlatFaces()},
          {"tube with rounded pole", tubeWithRoundedPole()},
          {"outline that almost closes", outlineThatAlmostCloses()},
          {"far from the origin", farFromOrigin()},
          {"far along a plane", farAlongAPlane()},
          {"torus of unequal scales",
           shapes::joined(torusOfUnequalScales(), shapes::scaled(fanOnALine(), 1e21))},
          {"needles", needles()}};
}

// --- The definition, in more digits --------------------------------------------------------------

/// How much longer two sides are than the third, at the corner where that is least.
long double leastExcess(long double a, long double b, long double c) {
  if (a < b) std::swap(a, b);
  if (a < c) std::swap(a, c);
  if (b < c) std::swap(b, c);
  return c - (a - b);
}

long double distance(const Vector3d& p, const Vector3d& q) {
  return (q.cast<long double>() - p.cast<long double>()).norm();
}

struct Definition {
  long double mollification = 0;
  int triangles = 0;
};

/// The least amount, from positions.
Definition definitionFor(const TriangleMesh& mesh) {
  std::vector<long double> lengths(mesh.halfedgeCount());
  long double mean = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    lengths[h] = distance(mesh.position(mesh.tail(h)), mesh.position(mesh.tip(h)));
    mean += lengths[h] / mesh.halfedgeCount();
  }
  Definition result;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const long double* l = &lengths[3 * f];
    const long double longest = std::max({mean, l[0], l[1], l[2]});
    const long double missing = kMollificationMargin * longest - leastExcess(l[0], l[1], l[2]);
    if (missing <= 0) continue;
    ++result.triangles;
    result.mollification = std::max(result.mollification, missing);
  }
  return result;
}

/// Positive area, angles between 0 and π that sum to π, and the margin in each face.
void expectTriangles(const TriangleMesh& mesh) {
  const double mean = mesh.meanEdgeLength() - mesh.repairs().mollification;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto& l = mesh.face(f).lengths;
    const double longest = *std::ranges::max_element(l);
    EXPECT_GE(leastExcess(l[0], l[1], l[2]),
              (1 - 1e-3) * kMollificationMargin * std::max(mean, longest));
    EXPECT_GT(mesh.faceArea(f), 0);
    double sum = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      EXPECT_GT(apexOf(mesh.face(f), h % 3).y(), 0);
      EXPECT_GT(mesh.cornerAngle(h), 0);
      EXPECT_LT(mesh.cornerAngle(h), pi);
      sum += mesh.cornerAngle(h);
      if (mesh.twin(h) >= 0) {
        EXPECT_EQ(mesh.length(mesh.twin(h)), mesh.length(h));
      }
    }
    EXPECT_NEAR(sum, pi, 8 * kEpsilon);
  }
}

class Mollification : public testing::TestWithParam<Case> {};

TEST_P(Mollification, IsTheLeastThatMakesTrianglesOfAllFaces) {
  const TriangleMesh mesh = GetParam().shape.mesh();
  expectTriangles(mesh);
  const Definition expected = definitionFor(mesh);
  EXPECT_GT(mesh.repairs().mollification, 0);
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, expected.triangles);
  EXPECT_NEAR(mesh.repairs().mollification, expected.mollification, 1e-3 * expected.mollification);
}

TEST_P(Mollification, IsAddedToEveryEdge) {
  const TriangleMesh mesh = GetParam().shape.mesh();
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_EQ(mesh.length(h), (mesh.position(mesh.tip(h)) - mesh.position(mesh.tail(h))).norm() +
                                  mesh.repairs().mollification);
  }
}

TEST_P(Mollification, MakesNoDistanceInAFaceShorter) {
  const TriangleMesh mesh = GetParam().shape.mesh();
  shapes::Random random(1);
  const auto randomPoint = [&] {
    const Vector3d bary(random.uniform(), random.uniform(), random.uniform());
    return Vector3d(bary / bary.sum());
  };
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int i = 0; i < 10; ++i) {
      const Vector3d p = randomPoint(), q = randomPoint(), d = q - p;
      const double inSpace =
          (d[1] * (mesh.position(mesh.tail(3 * f + 1)) - mesh.position(mesh.tail(3 * f))) +
           d[2] * (mesh.position(mesh.tail(3 * f + 2)) - mesh.position(mesh.tail(3 * f))))
              .norm();
      const double along = layOut(mesh.face(f), 0, d).norm();
      const auto& lengths = mesh.face(f).lengths;
      EXPECT_GE(along, inSpace - 4 * kEpsilon * *std::ranges::max_element(lengths));
    }
  }
}

TEST_P(Mollification, OfAScaledMeshIsScaled) {
  const TriangleMesh mesh = GetParam().shape.mesh();
  for (const double scale : {0x1p-100, 0x1p100}) {  // 8e-31 and 1.3e30
    const TriangleMesh scaled = shapes::scaled(GetParam().shape, scale).mesh();
    EXPECT_EQ(scaled.repairs().mollifiedTriangles, mesh.repairs().mollifiedTriangles);
    EXPECT_EQ(scaled.repairs().mollification, scale * mesh.repairs().mollification);
    EXPECT_EQ(scaled.area(), scale * scale * mesh.area());
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      EXPECT_EQ(scaled.length(h), scale * mesh.length(h));
      EXPECT_EQ(scaled.cornerAngle(h), mesh.cornerAngle(h));
    }
  }
}

TEST_P(Mollification, DoesNotDependOnTheOrderOfFaces) {
  const TriangleMesh mesh = GetParam().shape.mesh();
  for (int seed = 0; seed < 3; ++seed) {
    const TriangleMesh shuffled = shapes::shuffled(GetParam().shape, seed).mesh();
    expectTriangles(shuffled);
    EXPECT_EQ(shuffled.repairs().mollifiedTriangles, mesh.repairs().mollifiedTriangles);
    EXPECT_NEAR(shuffled.repairs().mollification, mesh.repairs().mollification,
                1e-6 * mesh.repairs().mollification);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Mollification, testing::ValuesIn(degenerateCases()));

// --- By hand -------------------------------------------------------------------------------------

TEST(MollificationAmount, OfATriangleOnALineIsTheMarginOfItsLongestSide) {
  const TriangleMesh mesh = shapeOf({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {0, 1, 2}).mesh();
  EXPECT_EQ(mesh.repairs().mollification, 3 * kMollificationMargin);
  EXPECT_EQ(mesh.length(0), 1 + 3 * kMollificationMargin);
  // Heron: sides 1, 2 and 3, perimeter 6, excesses of 2 and 4 at the ends.
  EXPECT_NEAR(mesh.area(), std::sqrt(6 * 3 * kMollificationMargin * 2 * 4) / 4,
              10 * kMollificationMargin * mesh.area());
}

TEST(MollificationAmount, OfAShortTriangleIsTheMarginOfTheMeanEdge) {
  // A triangle of size 1e-20 beside one with sides of 3, 4 and 5: the mean is 2.
  const TriangleMesh mesh =
      shapeOf({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {9, 0, 0}, {9, 1e-20, 0}, {9, 0, 1e-20}},
              {0, 1, 2, 3, 4, 5})
          .mesh();
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, 1);
  EXPECT_NEAR(mesh.repairs().mollification, 2 * kMollificationMargin, 1e-19);
  for (int h = 3; h < 6; ++h) EXPECT_NEAR(mesh.cornerAngle(h), pi / 3, 1e-6);
}

TEST(MollificationAmount, OfANeedleIsWhatItsExcessLacks) {
  // Short side 2^-38, of the order of the margin, between two of almost 1 at right angles to it.
  const double width = 0x1p-38;
  const TriangleMesh mesh = shapeOf({{0, 0, 0}, {1, 0, 0}, {1, width, 0}}, {0, 1, 2}).mesh();
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, 1);
  EXPECT_NEAR(mesh.repairs().mollification, kMollificationMargin - width, 1e-20);
}

TEST(MollificationAmount, MovesATurnedMeshByRoundingOnly) {
  const Shape shape = gridWithFlatFaces();
  const TriangleMesh mesh = shape.mesh();
  Shape turned = shape;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.7, 0.2, 0.5).normalized();
  for (int v = 0; v < shape.vertexCount(); ++v)
    turned.setPosition(v, turn * shape.position(v) + Vector3d(1, 2, 3));
  const TriangleMesh other = turned.mesh();
  expectTriangles(other);
  EXPECT_EQ(other.repairs().mollifiedTriangles, mesh.repairs().mollifiedTriangles);
  EXPECT_NEAR(other.repairs().mollification, mesh.repairs().mollification, 1e-15);
  EXPECT_NEAR(other.area(), mesh.area(), 1e-8);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_NEAR(other.length(h), mesh.length(h), 1e-14);
    EXPECT_NEAR(other.cornerAngle(h), mesh.cornerAngle(h), 1e-8);
  }
}

TEST(MollificationAmount, CountsFacesWithEdgesWhoseSquaresUnderflow) {
  const TriangleMesh mesh =
      shapes::joined(shapes::tetrahedron(), shapes::scaled(shapes::octahedron(), 1e-200)).mesh();
  expectTriangles(mesh);
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, 8);
}

// --- Nothing to do -------------------------------------------------------------------------------

void expectUntouched(const Shape& shape, const std::string& name) {
  const TriangleMesh mesh = shape.mesh();
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, 0) << name;
  EXPECT_EQ(mesh.repairs().mollification, 0) << name;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_EQ(mesh.length(h), (mesh.position(mesh.tip(h)) - mesh.position(mesh.tail(h))).norm())
        << name;
  }
  expectTriangles(mesh);
}

TEST(CleanMesh, KeepsItsLengthsToTheBit) {
  expectUntouched(shapes::triangle(), "triangle");
  expectUntouched(shapes::bumpySurface(2, 3, 0.4, 1), "bumpy surface");
  expectUntouched(shapes::gradedDisk(30, 6, 0.5), "faces 1e-9 times the size of others");
  expectUntouched(shapes::vertexFan(24, 0.1), "narrow cone");
  for (int seed = 0; seed < 10; ++seed)
    expectUntouched(shapes::randomTriangulation(60, 40, seed), "needles and caps");
}

TEST(CleanMesh, MayHaveThinTriangles) {
  for (const double degrees : {1.0, 0.1, 0.01, 0.001}) {
    const double height = 0.5 * std::tan(degrees * pi / 180);
    expectUntouched(shapeOf({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}, {0, 1, 2}), "cap");
    expectUntouched(shapeOf({{0, 0, 0}, {1, 0, 0}, {1, 2 * height, 0}}, {0, 1, 2}), "needle");
  }
}

TEST(CleanMesh, HasFullPrecisionFarFromTheOrigin) {
  // The same differences of coordinates give the same bits. The offset is 1e6 sizes of the mesh.
  const Shape near = roundedTo(0x1p-30, shapes::bumpySurface(1, 2, 0.3, 1));
  const TriangleMesh expected = near.mesh();
  const Shape far = shapes::moved(near, {0x1p22, -0x1p22, 0x1p22});
  expectUntouched(far, "far from the origin");
  const TriangleMesh mesh = far.mesh();
  ASSERT_EQ(mesh.halfedgeCount(), expected.halfedgeCount());
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_EQ(mesh.length(h), expected.length(h));
    EXPECT_EQ(mesh.cornerAngle(h), expected.cornerAngle(h));
  }
  EXPECT_EQ(mesh.area(), expected.area());
}

// --- Triangles in space --------------------------------------------------------------------------

TEST(MeasureTriangle, HasTheAreaAndAnglesThatItsRoundedLengthsHaveLost) {
  // A cap of height 1e-9: its sides are of length 1 to the last bit.
  const IntrinsicTriangle t = measureTriangle({Vector3d(-1, 0, 0), {1, 0, 0}, {0, 1e-9, 0}});
  EXPECT_EQ(t.lengths[1], 1);
  EXPECT_EQ(t.lengths[2], 1);
  EXPECT_NEAR(t.twiceArea, 2e-9, 2e-9 * 4 * kEpsilon);
  EXPECT_NEAR(t.leastExcess(), 1e-18, 1e-18 * 4 * kEpsilon);
}

TEST(Lengthened, FollowsFromTheLengths) {
  // By a half: sides of 3.5, 4.5 and 5.5.
  const IntrinsicTriangle t =
      lengthened(measureTriangle({Vector3d(0, 0, 0), {3, 0, 0}, {0, 4, 0}}), 0.5);
  EXPECT_EQ(t.lengths[0], 3.5);
  EXPECT_EQ(t.lengths[1], 5.5);
  EXPECT_EQ(t.lengths[2], 4.5);
  EXPECT_NEAR(t.dots[0], (3.5 * 3.5 + 4.5 * 4.5 - 5.5 * 5.5) / 2, 16 * kEpsilon);
  EXPECT_NEAR(t.excess[0], 2.5, 4 * kEpsilon);
  EXPECT_NEAR(t.twiceArea, std::sqrt(13.5 * 2.5 * 4.5 * 6.5) / 2, 64 * kEpsilon);
}

TEST(Lengthened, MakesAPointAnEquilateralTriangle) {
  const IntrinsicTriangle t =
      lengthened(measureTriangle({Vector3d(1, 2, 3), {1, 2, 3}, {1, 2, 3}}), 2);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::atan2(t.twiceArea, t.dots[i]), pi / 3, kEpsilon);
}

}  // namespace
}  // namespace gvd
