// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "gvd/error.h"
#include "mesh/face_layout.h"
#include "mesh/vertex_welding.h"
#include "shapes.h"

namespace gvd {
namespace {

using shapes::Shape;
using std::numbers::pi;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// --- Checkers ------------------------------------------------------------------------------------

/// All that holds for every mesh, whatever the input was.
void expectInvariants(const TriangleMesh& mesh) {
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_GT(mesh.length(h), 0);
    EXPECT_TRUE(std::isfinite(mesh.length(h)));
    const int twin = mesh.twin(h);
    if (twin < 0) continue;
    ASSERT_EQ(mesh.twin(twin), h);
    EXPECT_EQ(mesh.tail(twin), mesh.tip(h));
    EXPECT_EQ(mesh.tip(twin), mesh.tail(h));
    EXPECT_EQ(mesh.length(twin), mesh.length(h));
    EXPECT_EQ(mesh.component(twin / 3), mesh.component(h / 3));
  }

  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const Eigen::Vector2d apex = apexOf(mesh.face(h / 3), h % 3);
    const double toTip = mesh.length(mesh.next(h)), toTail = mesh.length(mesh.previous(h));
    const double rounding = 8 * kEpsilon * (mesh.length(h) + toTip + toTail);
    EXPECT_GT(apex.y(), 0);
    EXPECT_NEAR(apex.norm(), toTail, rounding);
    EXPECT_NEAR((apex - Eigen::Vector2d(mesh.length(h), 0)).norm(), toTip, rounding);
  }

  std::vector<int> corners(mesh.vertexCount(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) ++corners[mesh.tail(h)];
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const int first = mesh.outgoing(v);
    int met = 0;
    double angles = 0;
    int h = first;
    do {
      ASSERT_EQ(mesh.tail(h), v);
      angles += mesh.cornerAngle(h);
      ++met;
      h = mesh.rotate(h);
    } while (h >= 0 && h != first && met <= corners[v]);
    EXPECT_EQ(met, corners[v]) << "vertex " << v << " has one fan";
    EXPECT_EQ(h < 0, mesh.onBoundary(v));
    EXPECT_EQ(mesh.twin(first) < 0, mesh.onBoundary(v));
    EXPECT_NEAR(mesh.angleSum(v), angles, 1e-13 * met);
  }

  double area = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const TriangleMesh::Face& face = mesh.face(f);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(face.lengths[i], mesh.length(3 * f + i));
      EXPECT_EQ(face.vertices[i], mesh.tail(3 * f + i));
      EXPECT_EQ(face.twins[i], mesh.twin(3 * f + i));
      const double angle = mesh.cornerAngle(3 * f + i);
      EXPECT_NEAR(face.cosines[i], std::cos(angle), 8 * kEpsilon);
      EXPECT_NEAR(face.sines[i], std::sin(angle), 8 * kEpsilon);
      EXPECT_GT(face.sines[i], 0);
    }
    EXPECT_GT(mesh.faceArea(f), 0);
    EXPECT_NEAR(mesh.faceArea(f), face.lengths[0] * apexOf(face, 0).y() / 2,
                8 * kEpsilon * mesh.faceArea(f));
    area += mesh.faceArea(f);

    double sum = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      EXPECT_GT(mesh.cornerAngle(h), 0);
      EXPECT_LT(mesh.cornerAngle(h), pi);
      sum += mesh.cornerAngle(h);
    }
    EXPECT_NEAR(sum, pi, 8 * kEpsilon);
  }

  EXPECT_EQ(mesh.area(), area);

  const MeshRepairs& r = mesh.repairs();
  EXPECT_EQ(r.mollification > 0, r.mollifiedTriangles > 0);
  EXPECT_EQ(mesh.inputFaceCount(), mesh.faceCount() + r.nonFiniteTriangles + r.degenerateTriangles +
                                       r.duplicateTriangles + r.smallComponentTriangles);
  EXPECT_EQ(r.smallComponents > 0, r.smallComponentTriangles > 0);
  EXPECT_EQ(mesh.inputVertexCount(),
            mesh.vertexCount() - r.splitVertices + r.weldedVertices + r.isolatedVertices);
}

/// Every corner of every input triangle is found where the input has it, and faces lead back.
void expectTrueToInput(const Shape& shape, const TriangleMesh& mesh) {
  for (int t = 0; t < shape.faceCount(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint corner = mesh.fromInput({t, Eigen::Vector3d::Unit(i)});
      EXPECT_EQ(mesh.position(corner), shape.position(shape.triangles[3 * t + i]));
    }
  }
  const Eigen::Vector3d bary(0.5, 0.375, 0.125);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const SurfacePoint input = mesh.toInput({f, bary});
    EXPECT_EQ(input.face, mesh.inputFace(f));
    const SurfacePoint back = mesh.fromInput(input);
    EXPECT_EQ(back.face, f);
    EXPECT_EQ(back.bary, bary);
  }
}

int repairCount(const MeshRepairs& r) {
  return r.weldedVertices + r.isolatedVertices + r.nonFiniteTriangles + r.degenerateTriangles +
         r.duplicateTriangles + r.nonManifoldEdges + r.orientationCuts + r.flippedTriangles +
         r.smallComponents + r.splitVertices + r.mollifiedTriangles;
}

TriangleMesh cleanMesh(const Shape& shape) {
  TriangleMesh mesh = shape.mesh();
  EXPECT_EQ(repairCount(mesh.repairs()), 0);
  expectInvariants(mesh);
  expectTrueToInput(shape, mesh);
  return mesh;
}

TriangleMesh repairedMesh(const Shape& shape, const MeshOptions& options = {}) {
  TriangleMesh mesh = shape.mesh(options);
  EXPECT_GT(repairCount(mesh.repairs()), 0);
  expectInvariants(mesh);
  return mesh;
}

std::string errorOf(const std::function<void()>& call, ErrorCode code) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

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

// --- Repairs, one small mesh each ----------------------------------------------------------------

TEST(Repairs, WeldVerticesAtBitEqualPositions) {
  const TriangleMesh mesh = repairedMesh(shapes::unwelded(shapes::cube()));
  EXPECT_EQ(mesh.vertexCount(), 8);
  EXPECT_EQ(mesh.repairs().weldedVertices, 36 - 8);
  EXPECT_EQ(repairCount(mesh.repairs()), 36 - 8);
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
}

TEST(Repairs, WeldMinusZeroToZero) {
  Shape shape = shapes::triangle();
  const int zero = shape.addVertex({-0.0, 0, -0.0});
  const int one = shape.addVertex({0, 1, -0.0});
  shape.addTriangle(zero, one, shape.addVertex({-1, 0, 0}));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().weldedVertices, 2);
  EXPECT_EQ(mesh.topology().components, 1);
}

TEST(Repairs, DoNotWeldNeighbouringNumbers) {
  Shape shape = shapes::unwelded(shapes::grid(1, 1));  // (0,0) and (1,1) occur twice
  double& x = shape.positions[3 * 2];
  ASSERT_EQ(x, 1);
  x = std::nextafter(x, 2);
  EXPECT_EQ(repairedMesh(shape).repairs().weldedVertices, 1);
}

TEST(Repairs, LeaveOutIsolatedVertices) {
  Shape shape;
  shape.addVertex({5, 5, 5});
  shape = shapes::joined(shape, shapes::triangle());
  shape.addVertex({5, 5, 5});
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.vertexCount(), 3);
  EXPECT_EQ(mesh.repairs().isolatedVertices, 2);
  EXPECT_EQ(mesh.inputVertex(0), 1);
}

TEST(Repairs, DropTrianglesWithACornerThatIsNotFinite) {
  Shape shape = shapes::octahedron();
  const int nan = shape.addVertex({kNan, 0, 0});
  const int infinite = shape.addVertex({0, -std::numeric_limits<double>::infinity(), 0});
  shape.addTriangle(0, 1, nan);
  shape.addTriangle(0, 1, infinite);
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().nonFiniteTriangles, 2);
  EXPECT_EQ(mesh.repairs().isolatedVertices, 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 0) << "the rest is untouched";
}

TEST(Repairs, DropTrianglesWithTwoEqualCorners) {
  Shape shape = shapes::tetrahedron();
  const int copy = shape.addVertex(shape.position(0));
  shape.addTriangle(0, 0, 1);
  shape.addTriangle(0, 1, copy);
  shape.addTriangle(2, 2, 2);
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().degenerateTriangles, 3);
  EXPECT_EQ(mesh.repairs().weldedVertices, 1);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 0);
  expectTrueToInput(shape, mesh);
}

TEST(Repairs, KeepTrianglesOfZeroAreaWithThreeCorners) {
  // A vertex in the middle of a side of one triangle only, the gap filled by a cap.
  Shape shape;
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 0), {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}}) {
    shape.addVertex(p);
  }
  shape.addTriangle(0, 1, 2);
  shape.addTriangle(1, 0, 3);
  shape.addTriangle(3, 0, 4);
  shape.addTriangle(1, 3, 4);
  const TriangleMesh mesh = repairedMesh(shape);
  expectTrueToInput(shape, mesh);
  EXPECT_EQ(mesh.faceCount(), 4);
  EXPECT_EQ(mesh.repairs().mollifiedTriangles, 1);
  EXPECT_EQ(repairCount(mesh.repairs()), 1);
  EXPECT_EQ(mesh.topology().components, 1);
  EXPECT_NEAR(mesh.angleSum(3), 2 * pi, 1e-4) << "an inner vertex thanks to the cap";
}

TEST(Repairs, DropDuplicatesEitherSideUp) {
  Shape shape = shapes::tetrahedron();
  shape.addTriangle(1, 2, 0);
  shape.addTriangle(2, 1, 0);
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().duplicateTriangles, 2);
  EXPECT_EQ(repairCount(mesh.repairs()), 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
  expectTrueToInput(shape, mesh);
}

/// `count` triangles that share the edge 0-1.
Shape book(int count) {
  Shape shape;
  shape.addVertex({0, 0, 0});
  shape.addVertex({0, 0, 1});
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    shape.addTriangle(0, 1, shape.addVertex({std::cos(angle), std::sin(angle), 0}));
  }
  return shape;
}

TEST(Repairs, CutEdgesOfThreeOrMoreTriangles) {
  for (int count : {3, 4, 7}) {
    const TriangleMesh mesh = repairedMesh(book(count));
    EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
    EXPECT_EQ(mesh.repairs().splitVertices, 2 * (count - 1));
    EXPECT_EQ(mesh.repairs().flippedTriangles, 0) << "there is nothing to agree with";
    EXPECT_EQ(mesh.topology().components, count);
    EXPECT_EQ(mesh.topology().boundaryLoops, count);
  }
}

TEST(Repairs, CutTwoCubesThatShareAnEdgeThere) {
  // The edge at x = y = 1 between the cubes at (0,0,0) and (1,1,0).
  const Shape shape = shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), {1, 1, 0}));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().weldedVertices, 2);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
  EXPECT_EQ(mesh.repairs().splitVertices, 2);
  EXPECT_EQ(mesh.topology().components, 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 2) << "a slit of two edges in each cube";
}

TEST(Repairs, TurnOverTheMinority) {
  const TriangleMesh mesh = repairedMesh(shapes::withFaceTurnedOver(shapes::octahedron(), 0));
  EXPECT_EQ(mesh.repairs().flippedTriangles, 1);
  EXPECT_TRUE(mesh.isFlipped(0));
  for (int f = 1; f < 8; ++f) EXPECT_FALSE(mesh.isFlipped(f));
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
}

TEST(Repairs, TurnOverTheMinorityOfEachComponent) {
  Shape inside = shapes::moved(shapes::tetrahedron(), {10, 0, 0});
  for (int f = 0; f < 4; ++f) inside = shapes::withFaceTurnedOver(inside, f);
  cleanMesh(inside);
  const Shape shape = shapes::joined(shapes::withFaceTurnedOver(shapes::tetrahedron(), 2),
                                     shapes::withFaceTurnedOver(inside, 1));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().flippedTriangles, 2);
  for (int f = 0; f < 8; ++f) EXPECT_EQ(mesh.isFlipped(f), f == 2 || f == 5) << f;
}

TEST(Repairs, OrientByTheFirstTriangleOnADraw) {
  for (int turned : {0, 1}) {
    const TriangleMesh mesh = repairedMesh(shapes::withFaceTurnedOver(shapes::grid(1, 1), turned));
    EXPECT_FALSE(mesh.isFlipped(0));
    EXPECT_TRUE(mesh.isFlipped(1));
  }
}

TEST(Repairs, CutAMoebiusStripOpen) {
  for (int across : {1, 3}) {
    const TriangleMesh mesh = repairedMesh(shapes::moebiusStrip(12, across));
    EXPECT_GE(mesh.repairs().orientationCuts, across);
    EXPECT_EQ(mesh.topology().components, 1);
    EXPECT_EQ(mesh.topology().boundaryLoops, 1);
    EXPECT_EQ(mesh.topology().eulerCharacteristic, 1) << "a disk";
  }
}

TEST(Repairs, CutAClosedSurfaceWithoutOrientation) {
  // The projective plane: half of an icosahedron, opposite points identified. In general position
  // in space its triangles intersect, which does not matter.
  Shape shape;
  for (int i = 0; i < 6; ++i) shape.addVertex({double(i), double(i * i), double(i * i * i)});
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 1, 2},
                                                               {0, 2, 3},
                                                               {0, 3, 4},
                                                               {0, 4, 5},
                                                               {0, 5, 1},
                                                               {1, 2, 4},
                                                               {2, 3, 5},
                                                               {3, 4, 1},
                                                               {4, 5, 2},
                                                               {5, 1, 3}}) {
    shape.addTriangle(a, b, c);
  }
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 0);
  EXPECT_GT(mesh.repairs().orientationCuts, 0);
  EXPECT_GT(mesh.topology().boundaryLoops, 0);
}

TEST(Repairs, SplitAVertexSharedByTwoTriangles) {
  Shape shape = shapes::triangle();
  shape.addTriangle(0, shape.addVertex({-1, 0, 0}), shape.addVertex({0, -1, 0}));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().splitVertices, 1);
  EXPECT_EQ(repairCount(mesh.repairs()), 1);
  EXPECT_EQ(mesh.vertexCount(), 6);
  EXPECT_EQ(mesh.topology().components, 2);
  EXPECT_EQ(mesh.tail(0), 0) << "the first fan keeps the number";
  EXPECT_EQ(mesh.tail(3), 5) << "the copy comes last";
  EXPECT_EQ(mesh.inputVertex(5), 0);
}

TEST(Repairs, SplitAVertexWhereASurfaceTouchesItself) {
  // Two opposite corners of a 3×1 strip pinched into one place: one component still.
  Shape shape = shapes::grid(3, 1);
  shape.setPosition(3, shape.position(4));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().weldedVertices, 1);
  EXPECT_EQ(mesh.repairs().splitVertices, 1);
  EXPECT_EQ(mesh.topology().components, 1);
  EXPECT_EQ(mesh.topology().boundaryLoops, 1);
}

// --- Any input -----------------------------------------------------------------------------------

// --- Options -------------------------------------------------------------------------------------

/// The same shape with every coordinate off by up to `most`.
Shape jittered(Shape shape, double most, std::uint64_t seed) {
  shapes::Random random(seed);
  for (double& x : shape.positions) x += random.uniform(-most, most);
  return shape;
}

TEST(Weld, JoinsWhatRoundingHasTornApart) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    const Shape torn = shapes::scaled(jittered(shapes::unwelded(shapes::cube()), 1e-7, 1), scale);
    EXPECT_EQ(torn.mesh().topology().components, 12);
    EXPECT_TRUE(torn.mesh().topology().hasOpenSeams);
    const TriangleMesh mesh = repairedMesh(torn, {.weld = 1e-6});
    EXPECT_EQ(mesh.vertexCount(), 8);
    EXPECT_EQ(mesh.repairs().weldedVertices, 36 - 8);
    EXPECT_EQ(mesh.topology().boundaryLoops, 0);
    EXPECT_FALSE(mesh.topology().hasOpenSeams);
  }
}

TEST(OpenSeams, AreFoundInLongBoundaries) {
  // Two sheets of 10,002 boundary vertices each, along each other on one side; the diagonal is √5.
  const auto hasOpenSeams = [](double gap) {
    const Shape sheet = shapes::grid(5000, 1);
    const Shape sheets = shapes::joined(sheet, shapes::moved(sheet, {0, 1 + gap, 0}));
    return sheets.mesh().topology().hasOpenSeams;
  };
  EXPECT_TRUE(hasOpenSeams(2e-6));
  EXPECT_FALSE(hasOpenSeams(3e-6));
}

TEST(OpenSeams, AreNeitherShortBoundaryEdgesNorCutEdges) {
  Shape shape = shapes::grid(1, 1);
  const int near = shape.addVertex({1 + 1e-9, 0, 0});
  shape.addTriangle(1, near, 3);
  EXPECT_FALSE(shape.mesh().topology().hasOpenSeams);
  const TriangleMesh moebius = shapes::moebiusStrip(20).mesh();
  EXPECT_GT(moebius.repairs().orientationCuts, 0);
  EXPECT_FALSE(moebius.topology().hasOpenSeams);
}

TEST(Weld, IsRelativeToTheBoxOfTheTrianglesAlone) {
  for (const double x : {1e9, 1e308}) {
    Shape shape = shapes::grid(2, 2);
    shape.addVertex({x, 0, 0});  // no triangle's
    EXPECT_EQ(shape.mesh({.weld = 1e-3}).faceCount(), 8) << x;
  }
}

TEST(Weld, LeavesVerticesThatAreFartherApart) {
  // The diagonal is 5, the tolerance 1: at a distance of 1 vertices are welded, not beyond.
  Shape shape;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), {3, 0, 0}, {3, 4, 0}, {0, 4, 0}})
    shape.addVertex(p);
  shape.addQuad(0, 1, 2, 3);
  const int near = shape.addVertex({1, 4, 0}), far = shape.addVertex({3, std::nextafter(1., 2), 0});
  shape.addTriangle(0, 1, near);
  shape.addTriangle(0, far, 3);
  const TriangleMesh mesh = repairedMesh(shape, {.weld = 0.2});
  EXPECT_EQ(mesh.repairs().weldedVertices, 1);
  EXPECT_EQ(mesh.fromInputVertex(near).face, mesh.fromInput({2, {0, 0, 1}}).face);
  EXPECT_EQ(mesh.position(mesh.fromInputVertex(near)), shape.position(3));
}

TEST(Weld, DoesNotRunAlongAChain) {
  // Neighbours are half a tolerance apart: every third stays, none moves by more than a tolerance.
  Shape shape = shapes::grid(100, 1);
  const TriangleMesh mesh = repairedMesh(shape, {.weld = 0.02 / std::sqrt(2.0) * 1.01});
  EXPECT_EQ(mesh.vertexCount(), 2 * 34);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    const auto place = mesh.position(mesh.fromInputVertex(v));
    EXPECT_LE((place - shape.position(v)).norm(), 0.0203);
  }
}

TEST(Weld, OfAllInOnePlaceLeavesNothing) {
  EXPECT_NE(errorOf([] { shapes::cube().mesh({.weld = 1}); }, ErrorCode::kInvalidMesh), "");
}

TEST(Weld, BelowRoundingIsExact) {
  const Shape shape = shapes::moved(shapes::cube(), {1e6, 0, 0});
  for (const double weld : {0.0, 5e-324, 1e-300, 1e-17}) {
    EXPECT_EQ(repairCount(shape.mesh({.weld = weld}).repairs()), 0) << weld;
  }
}

TEST(Weld, FindsTheFirstVertexInReach) {
  // Against all pairs of vertices, at places where cubes of the search begin and end.
  for (int seed = 0; seed < 50; ++seed) {
    shapes::Random random(seed);
    Shape shape;
    const double offset = seed % 2 ? 1e6 : 0;
    for (int v = 0; v < 60; ++v)
      shape.addVertex({offset + random.below(40), random.below(3) * 0.5, random.below(2) * 1.0});
    shape.addTriangle(0, 1, 2);
    for (int t = 0; t < 60; ++t)
      shape.addTriangle(random.below(60), random.below(60), random.below(60));
    Eigen::Vector3d least = shape.position(0), most = least;
    for (const int v : shape.triangles) {
      least = least.cwiseMin(shape.position(v));
      most = most.cwiseMax(shape.position(v));
    }
    const double weld = 1.25 / (most - least).norm();
    std::vector<int> staying, expected;
    for (int v = 0; v < shape.vertexCount(); ++v) {
      int first = v;
      for (const int u : staying)
        if ((shape.position(u) - shape.position(v)).norm() <= 1.25) first = std::min(first, u);
      if (first == v) staying.push_back(v);
      expected.push_back(first);
    }
    VertexWelding welding(shape.positions, shape.triangles, weld);
    for (long budget = 7; !welding.step(budget); budget = 7) {
    }
    EXPECT_EQ(welding.take(), expected);
  }
}

TEST(KeptOrientation, TurnsNothingOverAndCutsWhereTrianglesDisagree) {
  const Shape shape = shapes::withFaceTurnedOver(shapes::octahedron(), 0);
  const TriangleMesh mesh = repairedMesh(shape, {.orientation = Orientation::kKeep});
  EXPECT_EQ(mesh.repairs().flippedTriangles, 0);
  EXPECT_EQ(mesh.repairs().orientationCuts, 3);
  EXPECT_EQ(mesh.topology().components, 2);
  for (int f = 0; f < 8; ++f) {
    EXPECT_FALSE(mesh.isFlipped(f));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(mesh.inputVertex(mesh.tail(3 * f + i)), shape.triangles[3 * f + i]);
  }
}

TEST(KeptOrientation, IsThatOfAConsistentMesh) {
  Shape inside = shapes::tetrahedron();
  for (int f = 0; f < 4; ++f) inside = shapes::withFaceTurnedOver(inside, f);
  EXPECT_EQ(repairCount(inside.mesh({.orientation = Orientation::kKeep}).repairs()), 0);
}

TEST(MinComponent, DropsWhatHasFewerTriangles) {
  // 4, 12 and 1 triangles; the tetrahedron has one that is turned over.
  Shape shape = shapes::joined(shapes::withFaceTurnedOver(shapes::tetrahedron(), 0),
                               shapes::moved(shapes::cube(), {9, 0, 0}));
  shape = shapes::joined(shape, shapes::moved(shapes::triangle(), {0, 9, 0}));
  EXPECT_EQ(repairedMesh(shape, {.minComponent = 1}).repairs().smallComponents, 0);
  EXPECT_EQ(repairedMesh(shape, {.minComponent = 4}).faceCount(), 16);

  const TriangleMesh mesh = repairedMesh(shape, {.minComponent = 5});
  EXPECT_EQ(mesh.faceCount(), 12);
  EXPECT_EQ(mesh.vertexCount(), 8);
  EXPECT_EQ(mesh.topology().components, 1);
  EXPECT_EQ(mesh.repairs().smallComponents, 2);
  EXPECT_EQ(mesh.repairs().smallComponentTriangles, 5);
  EXPECT_EQ(mesh.repairs().isolatedVertices, 7);
  EXPECT_EQ(mesh.repairs().flippedTriangles, 0) << "of those that are left";
  EXPECT_EQ(mesh.inputFace(0), 4);
  EXPECT_EQ(mesh.component(0), 0);
  EXPECT_EQ(errorOf(
                [&] {
                  mesh.fromInput({0, {1, 0, 0}});
                },
                ErrorCode::kInvalidPoint),
            "triangle 0 was dropped and no other triangle has its points");

  EXPECT_EQ(errorOf([&] { shape.mesh({.minComponent = 13}); }, ErrorCode::kInvalidMesh),
            "no component has 13 triangles: the largest has 12");
}

TEST(MeshOptions, AreCheckedForTheirRanges) {
  const auto error = [](const MeshOptions& options) {
    return errorOf([&] { shapes::triangle().mesh(options); }, ErrorCode::kInvalidArgument);
  };
  EXPECT_EQ(error({.weld = -0.5}), "weld is -0.5, not a number from 0 to 1");
  EXPECT_EQ(error({.weld = 1.5}), "weld is 1.5, not a number from 0 to 1");
  EXPECT_EQ(error({.weld = kNan}), "weld is nan, not a number from 0 to 1");
  EXPECT_EQ(error({.minComponent = -1}), "minComponent is -1, not a number from 0");
}

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
  EXPECT_EQ(error({0, 0}, {}), "there are 2 coordinates, not a multiple of three");
  EXPECT_EQ(error(three, {0, 1}), "there are 2 vertex indices, not a multiple of three");
  EXPECT_EQ(error(three, {0, 1, 2, 0, 1, 3}),
            "triangle 1 has vertex index 3, but there are 3 vertices");
  EXPECT_EQ(error(three, {0, -1, 2}), "triangle 0 has vertex index -1, but there are 3 vertices");
  EXPECT_EQ(error({}, {}), "there are no triangles");
  EXPECT_EQ(error({0, 0, 0, 1, 0, 0, 0, kNan, 0}, {0, 1, 2, 0, 0, 1}),
            "no triangle is left: of 2 triangles 1 have a corner that is not finite and 1 have two "
            "corners at one position");
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

// --- Points of the input -------------------------------------------------------------------------

std::string pointError(const TriangleMesh& mesh, const SurfacePoint& p) {
  return errorOf([&] { mesh.fromInput(p); }, ErrorCode::kInvalidPoint);
}

TEST(FromInput, ExchangesTheCornersOfAFlippedFace) {
  const Shape shape = shapes::withFaceTurnedOver(shapes::octahedron(), 3);
  const TriangleMesh mesh = shape.mesh();
  expectTrueToInput(shape, mesh);
  EXPECT_EQ(mesh.fromInput({3, {0.5, 0.375, 0.125}}).bary, Eigen::Vector3d(0.5, 0.125, 0.375));
}

TEST(FromInput, FindsADuplicateOnTheKeptTriangle) {
  Shape shape = shapes::tetrahedron();
  shape.addTriangle(2, 1, 0);  // face 0 the other way up
  const SurfacePoint p = shape.mesh().fromInput({4, {0.5, 0.375, 0.125}});
  EXPECT_EQ(p.face, 0);
  EXPECT_EQ(p.bary, Eigen::Vector3d(0.125, 0.375, 0.5));
}

TEST(FromInput, FindsADegenerateTriangleOnAnEdgeOrVertex) {
  Shape shape = shapes::triangle();
  shape.addTriangle(1, 0, 1);
  shape.addTriangle(2, 2, 2);
  const TriangleMesh mesh = shape.mesh();
  EXPECT_EQ(mesh.fromInput({1, {0.5, 0.375, 0.125}}).bary, Eigen::Vector3d(0.375, 0.625, 0));
  EXPECT_EQ(mesh.fromInput({2, {0.5, 0.375, 0.125}}).bary, Eigen::Vector3d(0, 0, 1));
}

TEST(FromInput, RejectsDroppedTrianglesThatNoKeptOneHolds) {
  Shape shape = shapes::triangle();
  const int far = shape.addVertex({9, 9, 9});
  const int nan = shape.addVertex({kNan, 0, 0});
  shape.addTriangle(0, 0, far);
  shape.addTriangle(0, 1, nan);
  const TriangleMesh mesh = shape.mesh();
  EXPECT_EQ(pointError(mesh, {1, {1, 0, 0}}),
            "triangle 1 was dropped and no other triangle has its points");
  EXPECT_EQ(pointError(mesh, {2, {1, 0, 0}}),
            "triangle 2 was dropped and no other triangle has its points");
}

TEST(FromInput, CleansBarycentricCoordinatesThatAreSlightlyOff) {
  const TriangleMesh mesh = shapes::triangle().mesh();
  const SurfacePoint p = mesh.fromInput({0, {0.5, 0.5 + 9e-7, -9e-7}});
  EXPECT_GE(p.bary.minCoeff(), 0);
  EXPECT_NEAR(p.bary.sum(), 1, kEpsilon);
  EXPECT_EQ(mesh.fromInput({0, {0.25, 0.25, 0.5}}).bary, Eigen::Vector3d(0.25, 0.25, 0.5));
}

TEST(FromInput, NamesTheFaultOfAPoint) {
  const TriangleMesh mesh = shapes::triangle().mesh();
  EXPECT_EQ(pointError(mesh, {0, {1.1, -0.1, 0}}), "the barycentric coordinate -0.1 is negative");
  EXPECT_EQ(pointError(mesh, {0, {0.5, 0.5, 0.25}}),
            "the barycentric coordinates sum to 1.25, not 1");
  EXPECT_EQ(pointError(mesh, {0, {kNan, 0.5, 0.5}}),
            "a barycentric coordinate is not a finite number");
  EXPECT_EQ(pointError(mesh, {1, {1, 0, 0}}), "there is no triangle 1");
  EXPECT_EQ(pointError(mesh, {-1, {1, 0, 0}}), "there is no triangle -1");
}

TEST(FromInputVertex, FindsEveryVertexOfTheInput) {
  const Shape shape = shapes::unwelded(shapes::cube());
  const TriangleMesh mesh = shape.mesh();
  for (int v = 0; v < shape.vertexCount(); ++v) {
    EXPECT_EQ(mesh.position(mesh.fromInputVertex(v)), shape.position(v));
  }
}

TEST(FromInputVertex, FindsTheFanThatNamesTheVertex) {
  // Two triangles that touch with a vertex of their own each: one place, two fans.
  const Shape shape = shapes::joined(shapes::triangle(), shapes::scaled(shapes::triangle(), -1));
  const TriangleMesh mesh = shape.mesh();
  ASSERT_EQ(mesh.repairs().weldedVertices, 1);
  EXPECT_EQ(mesh.fromInputVertex(0).face, 0);
  EXPECT_EQ(mesh.fromInputVertex(3).face, 1);
}

TEST(FromInputVertex, RejectsVerticesThatAreNotOnTheSurface) {
  Shape shape = shapes::triangle();
  shape.addVertex({9, 9, 9});
  const TriangleMesh mesh = shape.mesh();
  const auto error = [&](int v) {
    return errorOf([&] { mesh.fromInputVertex(v); }, ErrorCode::kInvalidPoint);
  };
  EXPECT_EQ(error(3), "no triangle of the surface uses vertex 3");
  EXPECT_EQ(error(4), "there is no vertex 4");
  EXPECT_EQ(error(-1), "there is no vertex -1");
}

}  // namespace
}  // namespace gvd
