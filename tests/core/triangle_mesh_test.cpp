// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "error_checks.h"
#include "gvd/error.h"
#include "mesh/face_layout.h"
#include "mesh_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::cleanMesh;
using checks::errorOf;
using checks::expectInvariants;
using checks::expectTrueToInput;
using checks::repairedMesh;
using shapes::Shape;
using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// --- From one triangle upward --------------------------------------------------------------------

TEST(TriangleMesh, OfOneTriangle) {
  const TriangleMesh mesh = cleanMesh(shapes::triangle());
  EXPECT_EQ(mesh.vertexCount(), 3);
  EXPECT_EQ(mesh.faceCount(), 1);
  EXPECT_EQ(mesh.halfedgeCount(), 3);
  for (int h = 0; h < 3; ++h) {
    EXPECT_EQ(mesh.tail(h), h);
    EXPECT_EQ(mesh.tip(h), (h + 1) % 3);
    EXPECT_EQ(mesh.twin(h), -1);
    EXPECT_EQ(mesh.outgoing(h), h);
    EXPECT_EQ(mesh.rotate(h), -1);
    EXPECT_TRUE(mesh.onBoundary(h));
  }
  EXPECT_EQ(mesh.length(0), 1);
  EXPECT_EQ(mesh.length(1), std::sqrt(2.0));
  EXPECT_EQ(mesh.length(2), 1);
  EXPECT_NEAR(mesh.cornerAngle(0), pi / 2, kEpsilon);
  EXPECT_NEAR(mesh.cornerAngle(1), pi / 4, kEpsilon);
  EXPECT_NEAR(mesh.cornerAngle(2), pi / 4, kEpsilon);
  EXPECT_EQ(mesh.faceArea(0), 0.5);
  EXPECT_EQ(mesh.area(), 0.5);
  EXPECT_EQ(mesh.boundingDiagonal(), std::sqrt(2.0));
  EXPECT_EQ(mesh.position({0, {0.5, 0.25, 0.25}}), Eigen::Vector3d(0.25, 0.25, 0));
}

TEST(TriangleMesh, OfTwoTrianglesPairsTheirCommonEdge) {
  const TriangleMesh mesh = cleanMesh(shapes::grid(1, 1));  // (0,1,3) and (0,3,2)
  EXPECT_EQ(mesh.twin(2), 3);
  EXPECT_EQ(mesh.twin(3), 2);
  EXPECT_EQ(mesh.outgoing(0), 0) << "the boundary halfedge from which turning meets both faces";
  EXPECT_EQ(mesh.rotate(0), 3);
  EXPECT_EQ(mesh.rotate(3), -1);
}

struct TopologyCase {
  std::string name;
  Shape shape;
  int vertices, faces, edges, components, boundaryLoops, euler, genus;
};

void PrintTo(const TopologyCase& test, std::ostream* out) { *out << test.name; }

class Topology : public testing::TestWithParam<TopologyCase> {};

TEST_P(Topology, IsCounted) {
  const TopologyCase& expected = GetParam();
  const TriangleMesh mesh = cleanMesh(expected.shape);
  const MeshTopology& topology = mesh.topology();
  EXPECT_EQ(mesh.vertexCount(), expected.vertices);
  EXPECT_EQ(mesh.faceCount(), expected.faces);
  EXPECT_EQ(topology.edges, expected.edges);
  EXPECT_EQ(topology.components, expected.components);
  EXPECT_EQ(topology.boundaryLoops, expected.boundaryLoops);
  EXPECT_EQ(topology.eulerCharacteristic, expected.euler);
  EXPECT_EQ(topology.genus, expected.genus);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Topology,
    testing::Values(
        TopologyCase{"triangle", shapes::triangle(), 3, 1, 3, 1, 1, 1, 0},
        TopologyCase{"tetrahedron", shapes::tetrahedron(), 4, 4, 6, 1, 0, 2, 0},
        TopologyCase{"octahedron", shapes::octahedron(), 6, 8, 12, 1, 0, 2, 0},
        TopologyCase{"cube", shapes::cube(), 8, 12, 18, 1, 0, 2, 0},
        TopologyCase{"icosphere", shapes::icosphere(2), 162, 320, 480, 1, 0, 2, 0},
        TopologyCase{"grid", shapes::grid(3, 2, 0.2, 1), 12, 12, 23, 1, 1, 1, 0},
        TopologyCase{"randomTriangulation", shapes::randomTriangulation(100, 200, 1), 104, 202, 305,
                     1, 1, 1, 0},
        TopologyCase{"gradedDisk", shapes::gradedDisk(30, 6, 0.5), 181, 354, 534, 1, 1, 1, 0},
        TopologyCase{"annulus", shapes::annulus(8, 2), 24, 32, 56, 1, 2, 0, 0},
        TopologyCase{"ell", shapes::ell(2), 21, 24, 44, 1, 1, 1, 0},
        TopologyCase{"cone", shapes::vertexFan(5, 3), 6, 5, 10, 1, 1, 1, 0},
        TopologyCase{"saddle", shapes::vertexFan(8, 8 * pi / 3), 9, 8, 16, 1, 1, 1, 0},
        TopologyCase{"torus", shapes::torus(8, 5), 40, 80, 120, 1, 0, 0, 1},
        TopologyCase{"plate of genus 0", shapes::perforatedPlate(0), 16, 28, 42, 1, 0, 2, 0},
        TopologyCase{"plate of genus 1", shapes::perforatedPlate(1), 32, 64, 96, 1, 0, 0, 1},
        TopologyCase{"plate of genus 2", shapes::perforatedPlate(2), 48, 100, 150, 1, 0, -2, 2},
        TopologyCase{"plate of genus 3", shapes::perforatedPlate(3), 64, 136, 204, 1, 0, -4, 3},
        TopologyCase{"bumpySurface", shapes::bumpySurface(2, 2, 0.2, 1), 198, 400, 600, 1, 0, -2,
                     2},
        TopologyCase{"cylinder", shapes::cylinder(7, 3), 28, 42, 70, 1, 2, 0, 0},
        TopologyCase{"sphere and torus", shapes::joined(shapes::octahedron(), shapes::torus(4, 3)),
                     18, 32, 48, 2, 0, 2, 1},
        TopologyCase{"subdivided cube", shapes::subdivided(shapes::cube()), 26, 48, 72, 1, 0, 2,
                     0}));

TEST(TriangleMesh, NumbersComponentsInOrderOfTheirFirstFace) {
  const Shape two =
      shapes::joined(shapes::tetrahedron(), shapes::moved(shapes::tetrahedron(), {10, 0, 0}));
  const TriangleMesh mesh = cleanMesh(two);
  for (int f = 0; f < 8; ++f) EXPECT_EQ(mesh.component(f), f / 4);
}

TEST(TriangleMesh, KeepsTheNumbersOfACleanMesh) {
  const Shape shape = shapes::shuffled(shapes::torus(8, 5), 1);
  const TriangleMesh mesh = cleanMesh(shape);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(mesh.inputVertex(v), v);
    EXPECT_EQ(mesh.position(v), shape.position(v));
  }
  for (int f = 0; f < mesh.faceCount(); ++f) {
    EXPECT_EQ(mesh.inputFace(f), f);
    EXPECT_FALSE(mesh.isFlipped(f));
    for (int h = 3 * f; h < 3 * f + 3; ++h) EXPECT_EQ(mesh.tail(h), shape.triangles[h]);
  }
}

// --- Measures ------------------------------------------------------------------------------------

/// A triangle with corner angles at the vertices 0, 1, 2.
TriangleMesh triangleMesh(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
  Shape shape;
  for (const auto& p : {a, b, c}) shape.addVertex(p);
  shape.addTriangle(0, 1, 2);
  return shape.mesh();
}

TEST(CornerAngle, OfANeedleHasFullRelativePrecision) {
  const TriangleMesh mesh = triangleMesh({0, 0, 0}, {1, -5e-10, 0}, {1, 5e-10, 0});
  EXPECT_NEAR(mesh.cornerAngle(0), 1e-9, 1e-9 * 8 * kEpsilon);
}

TEST(Apex, OfANeedleHasFullRelativePrecision) {
  const TriangleMesh mesh = triangleMesh({0, 0, 0}, {1, -5e-10, 0}, {1, 5e-10, 0});
  expectInvariants(mesh);
  EXPECT_NEAR(apexOf(mesh.face(0), 0).y(), 1e-9, 1e-9 * 8 * kEpsilon)
      << "the tip over the long side";
  EXPECT_NEAR(apexOf(mesh.face(0), 1).y(), 1, 8 * kEpsilon) << "the far corner over the short side";
}

/// A strip of flat rectangles: a third of its edges are much shorter than the mean.
TEST(ShortEdgeLength, LeavesQueuesFewEnoughBuckets) {
  constexpr int kCount = 150000;
  Shape strip;
  for (int i = 0; i <= kCount; ++i)
    for (const double y : {0.0, 1e-3}) strip.addVertex({static_cast<double>(i), y, 0});
  for (int v = 0; v < 2 * kCount; v += 2) strip.addQuad(v, v + 2, v + 3, v + 1);
  const TriangleMesh mesh = strip.mesh();
  const double longest = mesh.meanEdgeLength() * mesh.halfedgeCount();
  EXPECT_GE(mesh.shortEdgeLength() * (1 << 30), 6 * longest);
}

TEST(CornerAngle, OfAFlatTriangleIsAlmostZeroOrPi) {
  const TriangleMesh mesh = triangleMesh({0, 0, 0}, {1, 0, 0}, {3, 0, 0});
  expectInvariants(mesh);
  EXPECT_NEAR(mesh.cornerAngle(0), 0, 1e-4);
  EXPECT_NEAR(mesh.cornerAngle(1), pi, 1e-4);
  EXPECT_NEAR(mesh.cornerAngle(2), 0, 1e-4);
}

TEST(CornerAngle, OfTrianglesThatAreFlatButForRounding) {
  shapes::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d direction(random.uniform(), random.uniform(), random.uniform());
    const double s = random.uniform(0.1, 0.9);
    expectInvariants(triangleMesh({0, 0, 0}, s * direction, direction));
  }
}

TEST(CornerAngle, OfACapHasTheDigitsThatItsLengthsHaveLost) {
  // A cap of height 1e-5 in a plane: what rounding takes of its sides, 1e-16, is 1e-6 of its
  // height.
  Shape shape;
  for (const auto& p : {Eigen::Vector3d(0.4, 1e-5, 0), {0, 0, 0}, {1, 0, 0}, {0.7, 2, 0}}) {
    shape.addVertex(p);
  }
  shape.addTriangle(0, 1, 2);
  shape.addTriangle(0, 2, 3);
  shape.addTriangle(0, 3, 1);
  EXPECT_NEAR(cleanMesh(shape).angleSum(0), 2 * pi, 4 * kEpsilon);
}

TEST(CornerAngle, DoesNotDependOnScale) {
  const Shape shape = shapes::tetrahedron();
  for (double scale : {1e-60, 1e-30, 1.0, 1e30, 1e59}) {
    const TriangleMesh mesh = shapes::scaled(shape, scale).mesh();
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      EXPECT_NEAR(mesh.length(h) / scale, 2 * std::sqrt(2.0), 8 * kEpsilon) << scale;
      EXPECT_NEAR(mesh.cornerAngle(h), pi / 3, 8 * kEpsilon) << scale;
    }
  }
}

TEST(AngleSum, OfACubeCornerIsThreeRightAngles) {
  const TriangleMesh mesh = shapes::cube().mesh();
  for (int v = 0; v < 8; ++v) EXPECT_NEAR(mesh.angleSum(v), 1.5 * pi, 8 * kEpsilon);
}

TEST(AngleSum, TellsConesFromSaddles) {
  for (double sum : {0.5, 3.0, 2 * pi, 8 * pi / 3, 12.0}) {
    const TriangleMesh mesh = cleanMesh(shapes::vertexFan(8, sum));
    EXPECT_NEAR(mesh.angleSum(0), sum, 1e-14);
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(mesh.length(3 * i), 1, 4 * kEpsilon);
  }
}

TEST(Area, IsTheSumOfTheFaces) {
  EXPECT_NEAR(shapes::cube().mesh().area(), 6, 16 * kEpsilon);
  EXPECT_NEAR(shapes::randomTriangulation(500, 1000, 1).mesh().area(), 1, 1e-12);
  EXPECT_NEAR(shapes::randomTriangulation(200, 400, 1, 3).mesh().area(), 1, 1e-12);
  EXPECT_NEAR(shapes::ell(3).mesh().area(), 3, 1e-14);
  EXPECT_NEAR(shapes::perforatedPlate(1, 3).mesh().area(), 32, 1e-12);
}

TEST(BoundingDiagonal, IsThatOfTheBoundingBox) {
  EXPECT_EQ(shapes::cube().mesh().boundingDiagonal(), std::sqrt(3.0));
  EXPECT_EQ(shapes::moved(shapes::cube(), {100, 0, 0}).mesh().boundingDiagonal(), std::sqrt(3.0));
}

// --- Any input -----------------------------------------------------------------------------------

TEST(TriangleMesh, IsTheSameSurfaceHoweverTheInputIsOrdered) {
  const Shape shape = shapes::bumpySurface(2, 2, 0.3, 1);
  const TriangleMesh expected = cleanMesh(shape);
  for (int seed = 0; seed < 5; ++seed) {
    const TriangleMesh mesh = cleanMesh(shapes::shuffled(shape, seed));
    EXPECT_EQ(mesh.topology().genus, expected.topology().genus);
    EXPECT_NEAR(mesh.area(), expected.area(), 1e-12);
    const TriangleMesh soup = repairedMesh(shapes::shuffled(shapes::unwelded(shape), seed));
    EXPECT_EQ(soup.vertexCount(), expected.vertexCount());
    EXPECT_EQ(soup.topology().eulerCharacteristic, expected.topology().eulerCharacteristic);
  }
}

TEST(TriangleMesh, HoldsItsInvariantsWhateverIsMissing) {
  for (int seed = 0; seed < 20; ++seed) {
    const Shape whole = shapes::bumpySurface(seed % 4, 2, 0.3, seed);
    const int missing = whole.faceCount() * (seed + 1) / 25;
    const Shape shape = shapes::withoutRandomFaces(whole, missing, seed);
    const TriangleMesh mesh = shape.mesh();
    expectInvariants(mesh);
    expectTrueToInput(shape, mesh);
    EXPECT_GT(mesh.topology().boundaryLoops, 0);
  }
}

TEST(TriangleMesh, HoldsItsInvariantsForRandomTriangles) {
  // Few places, many triangles: degenerate, duplicate, non-manifold and non-orientable all at once.
  for (int seed = 0; seed < 200; ++seed) {
    shapes::Random random(seed);
    Shape shape;
    const int places = 4 + random.below(8);
    for (int i = 0; i < 2 * places; ++i) {
      const int place = random.below(places);
      shape.addVertex({double(place), double(place * place % 7), double(place % 3)});
    }
    for (int i = 0; i < 1 + seed / 4; ++i) {
      const auto vertex = [&] { return random.below(shape.vertexCount()); };
      const int a = vertex(), b = vertex(), c = vertex();
      shape.addTriangle(a, b, c);
    }
    for (const MeshOptions& options : std::vector<MeshOptions>{
             {},
             {.weld = 0.2},
             {.orientation = Orientation::kKeep},
             {.weld = 0.1, .orientation = Orientation::kKeep, .minComponent = 3}}) {
      try {
        expectInvariants(shape.mesh(options));
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("no ")) << error.what();
      }
    }
  }
}

// --- Bad input -----------------------------------------------------------------------------------

TEST(TriangleMesh, RejectsWhatIsNoListOfTriangles) {
  const auto error = [](std::vector<double> positions, std::vector<int> triangles) {
    return errorOf([&] { TriangleMesh(positions, triangles); }, ErrorCode::kInvalidMesh);
  };
  const std::vector<double> three = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(error({0, 0}, {}), "the number of coordinates is 2, not a multiple of three");
  EXPECT_EQ(error(three, {0, 1}), "the number of vertex indices is 2, not a multiple of three");
  EXPECT_EQ(error(three, {0, 1, 2, 0, 1, 3}),
            "triangle 1 has vertex index 3, but the number of vertices is 3");
  EXPECT_EQ(error(three, {0, -1, 2}),
            "triangle 0 has vertex index -1, but the number of vertices is 3");
  EXPECT_EQ(error({}, {}), "there are no triangles");
  EXPECT_EQ(
      error({0, 0, 0, 1, 0, 0, 0, kNan, 0}, {0, 1, 2, 0, 0, 1}),
      "no triangle is left of 2: 1 with a corner that is not finite, 1 with two corners at one "
      "position");
}

TEST(TriangleMesh, RejectsSizesThatProductsOverflowOrUnderflowAt) {
  const auto error = [](double scale) {
    const Shape shape = shapes::scaled(shapes::tetrahedron(), scale);
    return errorOf([&] { shape.mesh(); }, ErrorCode::kInvalidMesh);
  };
  for (const double scale : {1e60, 1e100, 1e160, 1e308})
    EXPECT_EQ(error(scale), "the positions are too far apart to measure distances");
  for (const double scale : {1e-61, 1e-100, 1e-160, 1e-307})
    EXPECT_EQ(error(scale), "the positions are too close together to measure distances");
}

}  // namespace
}  // namespace gvd
