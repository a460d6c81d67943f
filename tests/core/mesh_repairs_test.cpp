// SPDX-License-Identifier: MIT
//
// The repairs that make a manifold of any list of triangles, and their options.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "error_checks.h"
#include "gvd/error.h"
#include "gvd/triangle_mesh.h"
#include "mechanical_shapes.h"
#include "mesh/building/vertex_welding.h"
#include "mesh_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::cleanMesh;
using checks::errorOf;
using checks::expectTrueToInput;
using checks::repairCount;
using checks::repairedMesh;
using shapes::Shape;
using std::numbers::pi;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

TEST(Repairs, KeepTwoCubesClosedThatShareAnEdge) {
  // The edge at x = y = 1 between the cubes at (0,0,0) and (1,1,0), of which one is inside out in
  // part.
  Shape second = shapes::moved(shapes::cube(), {1, 1, 0});
  for (int f = 0; f < 3; ++f) second = shapes::withFaceTurnedOver(second, f);
  const TriangleMesh mesh = repairedMesh(shapes::joined(shapes::cube(), second));
  EXPECT_EQ(mesh.repairs().weldedVertices, 2);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
  EXPECT_EQ(mesh.repairs().splitVertices, 2);
  EXPECT_EQ(mesh.repairs().flippedTriangles, 3);
  EXPECT_EQ(mesh.topology().components, 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
}

TEST(Repairs, KeepASurfaceWholeThatHasAFin) {
  // Decimated scans have such fins: a triangle given in both orientations.
  Shape shape = shapes::octahedron();
  const int a = shape.triangles[0], b = shape.triangles[1], tip = shape.addVertex({2, 2, 2});
  shape.addTriangle(a, b, tip);
  shape.addTriangle(b, a, tip);
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().duplicateTriangles, 1);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
  EXPECT_EQ(mesh.topology().components, 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 1) << "that of the fin";
}

TEST(Repairs, KeepTwoBlocksClosedThatTouchInFaces) {
  // Of the second one, which lies on the first, the squares in between have the other diagonal.
  const std::vector<double> lines = {0, 1, 2};
  const Shape block =
      shapes::boxes({lines, lines, lines}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}});
  Shape above = shapes::moved(block, {0, 0, 1});
  for (int f : {0, 5, 7}) above = shapes::withFaceTurnedOver(above, f);
  for (double scale : {1.0, 1e59, 1e-59}) {
    const TriangleMesh mesh = repairedMesh(shapes::scaled(shapes::joined(block, above), scale));
    EXPECT_EQ(mesh.repairs().nonManifoldEdges, 12);
    EXPECT_EQ(mesh.repairs().splitVertices, 9);
    EXPECT_EQ(mesh.topology().components, 2);
    EXPECT_EQ(mesh.topology().boundaryLoops, 0);
    EXPECT_EQ(mesh.topology().genus, 0);
  }
  EXPECT_THROW(repairedMesh(shapes::scaled(shapes::joined(block, above), 1e300)), Error);
}

TEST(Repairs, JoinSheetsAtAnEdgeIfTheirSidesAlternate) {
  // Any side of each of four may be the front.
  for (int turned = 0; turned < 16; ++turned) {
    Shape shape = book(4);
    for (int f = 0; f < 4; ++f)
      if (turned >> f & 1) shape = shapes::withFaceTurnedOver(shape, f);
    const bool alternate = turned == 0b0101 || turned == 0b1010;
    EXPECT_EQ(repairedMesh(shape).topology().components, alternate ? 2 : 4) << turned;
  }
}

TEST(Repairs, KeepAComponentClosedThatMeetsItselfInAnEdge) {
  // A row of five cubes, of which the first and the last share an edge only.
  const std::vector<double> lines = {0, 1, 2};
  const Shape shape =
      shapes::boxes({lines, lines, lines}, {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}});
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
  EXPECT_EQ(mesh.topology().components, 1);
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
  EXPECT_EQ(mesh.topology().genus, 0);
}

TEST(Repairs, CutAStripThatWouldBecomeOneSided) {
  // The ends of a twisted strip meet in one edge, at which a third triangle is.
  Shape shape = shapes::moebiusStrip(12);
  shape.addTriangle(0, 1, shape.addVertex({0, 0, 5}));
  const TriangleMesh mesh = repairedMesh(shape);
  EXPECT_EQ(mesh.repairs().nonManifoldEdges, 1);
  EXPECT_EQ(mesh.repairs().orientationCuts, 0);
  EXPECT_EQ(mesh.topology().components, 2);
  EXPECT_EQ(mesh.topology().boundaryLoops, 2);
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

// --- Options -------------------------------------------------------------------------------------

TEST(Weld, JoinsWhatRoundingHasTornApart) {
  for (const double scale : {1e-30, 1.0, 1e30}) {
    const Shape torn =
        shapes::scaled(shapes::jittered(shapes::unwelded(shapes::cube()), 1e-7, 1), scale);
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

TEST(OpenSeams, AreFoundBesideAShortEdge) {
  // The last vertex is near the first one, which an edge joins it to, and the second one.
  Shape shape;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d{0, 0, 0}, {4e-6, 0, 0}, {2e-6, 0, 0}})
    shape.addVertex(p);
  shape.addTriangle(0, 2, shape.addVertex({0, 1, 0}));
  shape.addTriangle(1, shape.addVertex({2, -1, 0}), shape.addVertex({2, 0, 0}));
  EXPECT_TRUE(shape.mesh().topology().hasOpenSeams);
}

TEST(OpenSeams, AreNeitherShortEdgesNorCutEdges) {
  Shape shape = shapes::grid(1, 1);
  const int near = shape.addVertex({1 + 1e-9, 0, 0});
  shape.addTriangle(1, near, 3);
  EXPECT_FALSE(shape.mesh().topology().hasOpenSeams);
  Shape kite;  // with a short inner edge, whose ends are on the boundary
  for (const Eigen::Vector3d& p : {Eigen::Vector3d{0, 0, 0}, {0, 1e-7, 0}, {1, 0, 0}, {-1, 0, 0}})
    kite.addVertex(p);
  kite.addQuad(0, 2, 1, 3);
  EXPECT_FALSE(kite.mesh().topology().hasOpenSeams);
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
  EXPECT_EQ(error({.weld = kNan}), "weld is NaN, not a number from 0 to 1");
  EXPECT_EQ(error({.minComponent = -1}), "minComponent is -1, not a number of 0 or more");
}

}  // namespace
}  // namespace gvd
