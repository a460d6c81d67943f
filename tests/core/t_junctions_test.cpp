// SPDX-License-Identifier: MIT
//
// T-junctions: vertices within sides of other triangles, as programs that cut solids leave.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "gvd/subdivision.h"
#include "gvd/triangle_mesh.h"
#include "mesh_checks.h"
#include "pipeline_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::expectInvariants;
using checks::expectTrueToInput;
using shapes::Random;
using shapes::Shape;

constexpr MeshOptions kJoin = {.weld = 1e-6};

/// A square of two triangles above one with a vertex in the middle of the common side, moved by
/// `gap` away from it.
Shape withTJunction(double gap) {
  Shape shape = shapes::grid(1, 1);
  const int a = shape.addVertex({0.5, -gap, 0});
  const int b = shape.addVertex({0, -1, 0}), c = shape.addVertex({1, -1, 0});
  shape.addTriangle(0, b, a);
  shape.addTriangle(b, c, a);
  shape.addTriangle(a, c, 1);
  return shape;
}

/// Divides random triangles at random points of their sides, but not their neighbours. A side
/// divided from both sides has T-junctions on both.
Shape withDividedSides(Shape shape, int count, std::uint64_t seed) {
  Random random(seed);
  for (; count > 0; --count) {
    const int t = random.below(shape.faceCount()), i = random.below(3);
    int corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = shape.triangles[3 * t + (i + k) % 3];
    const auto [a, b, c] = corners;
    const double share = random.uniform(0.2, 0.8);
    const int m = shape.addVertex((1 - share) * shape.position(a) + share * shape.position(b));
    shape.triangles[3 * t + i] = m;
    shape.addTriangle(a, m, c);
  }
  return shape;
}

// --- Found ---------------------------------------------------------------------------------------

TEST(TJunctions, AreFoundWithinRounding) {
  EXPECT_TRUE(withTJunction(0).mesh().topology().hasTJunctions);
  EXPECT_TRUE(withTJunction(1e-6).mesh().topology().hasTJunctions);
  EXPECT_FALSE(withTJunction(3e-6).mesh().topology().hasTJunctions);
  EXPECT_FALSE(withTJunction(0).mesh().topology().hasOpenSeams);
}

TEST(TJunctions, AreFoundInLongBoundaries) {
  const auto topologyOf = [](double shift) {
    const Shape sheet = shapes::grid(3000, 1);
    const Shape beside = shapes::moved(sheet, {shift / 3000, 1, 0});
    return shapes::joined(sheet, beside).mesh().topology();
  };
  EXPECT_TRUE(topologyOf(0.5).hasTJunctions);
  EXPECT_FALSE(topologyOf(0).hasTJunctions);  // welded
}

TEST(TJunctions, AreNeitherSeamsNorCutEdges) {
  EXPECT_FALSE(
      shapes::jittered(shapes::unwelded(shapes::cube()), 1e-7, 1).mesh().topology().hasTJunctions);
  const TriangleMesh moebius = shapes::moebiusStrip(20).mesh();
  EXPECT_FALSE(moebius.topology().hasTJunctions);
  EXPECT_FALSE(shapes::grid(6, 6).mesh().topology().hasTJunctions);
  Shape flat =
      shapes::triangle();  // beside a face without area, whose long side is on the boundary
  flat.addTriangle(1, 0, flat.addVertex({-1, 0, 0}));
  EXPECT_FALSE(flat.mesh().topology().hasTJunctions);
}

// --- Joined --------------------------------------------------------------------------------------

TEST(TJunctions, AreJoinedWithinTheTolerance) {
  const TriangleMesh apart = withTJunction(0).mesh();
  EXPECT_EQ(apart.topology().components, 2);
  EXPECT_EQ(apart.repairs().joinedVertices, 0);
  for (const double gap : {0.0, 1e-6}) {
    const Shape shape = withTJunction(gap);
    const TriangleMesh mesh = shape.mesh(kJoin);
    expectInvariants(mesh);
    expectTrueToInput(shape, mesh);
    EXPECT_EQ(mesh.repairs().joinedVertices, 1);
    EXPECT_EQ(mesh.faceCount(), 6);
    EXPECT_EQ(mesh.topology().components, 1);
    EXPECT_FALSE(mesh.topology().hasTJunctions);
    EXPECT_NEAR(mesh.area(), 2, 1e-5);
  }
  EXPECT_EQ(withTJunction(3e-6).mesh(kJoin).repairs().joinedVertices, 0);
}

/// All triangles of the input keep their indices; what lies on a face that joins is given on the
/// side that it continues.
TEST(TJunctions, AreJoinedByFacesAlongASide) {
  const Shape shape = withTJunction(0);
  const TriangleMesh mesh = shape.mesh(kJoin);
  for (int f = 0; f < 5; ++f) {
    EXPECT_FALSE(mesh.isJoining(f));
    EXPECT_EQ(mesh.inputFace(f), f);
  }
  ASSERT_TRUE(mesh.isJoining(5));
  EXPECT_EQ(mesh.inputFaceCount(), 5);
  for (int i = 0; i < 3; ++i) {
    const SurfacePoint corner = {5, Eigen::Vector3d::Unit(i)};
    const SurfacePoint given = mesh.toInput(corner);
    EXPECT_EQ(given.face, mesh.inputFace(5));
    EXPECT_LT((mesh.position(mesh.fromInput(given)) - mesh.position(corner)).norm(), 1e-15);
  }
}

TEST(TJunctions, AreJoinedWhereSheetsMeetInShiftedSides) {
  for (const int cells : {1, 2, 7, 300}) {
    const Shape sheet = shapes::grid(cells, 1);
    const Shape beside = shapes::moved(sheet, {0.375 / cells, 1, 0});
    const TriangleMesh mesh = shapes::joined(sheet, beside).mesh(kJoin);
    expectInvariants(mesh);
    EXPECT_EQ(mesh.repairs().joinedVertices, 2 * cells);
    EXPECT_EQ(mesh.topology().components, 1);
    EXPECT_EQ(mesh.topology().boundaryLoops, 1);
    EXPECT_EQ(mesh.repairs().nonManifoldEdges, 0);
  }
}

/// Many vertices along one side: lines cross few of the flat triangles, whose heights add up.
TEST(TJunctions, OfOneSideHardlyLengthenPaths) {
  const Shape coarse = shapes::grid(1, 1), fine = shapes::moved(shapes::grid(256, 4), {0, 1, 0});
  const TriangleMesh mesh = shapes::joined(coarse, fine).mesh(kJoin);
  EXPECT_EQ(mesh.repairs().joinedVertices, 255);
  EXPECT_EQ(mesh.topology().components, 1);
  const SurfacePoint site = mesh.fromInput({0, {0.5, 0.25, 0.25}});
  const auto field = finished(propagate(mesh, {&site, 1}, Metric::kExact));
  for (int v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_NEAR(field->at(v).front().distance, (mesh.position(v) - mesh.position(site)).norm(),
                3e-5);
}

/// Of a side that is as long as the limit, the two copies may differ by rounding: then only one is
/// halved.
TEST(TJunctions, OfSubdividedSeamsAreJoined) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Shape torn = shapes::jittered(shapes::unwelded(shapes::cube()), 1e-7, seed);
    const auto parts =
        subdivide(torn.positions, torn.triangles, {.maxEdge = 1 / torn.mesh().boundingDiagonal()});
    const TriangleMesh mesh(parts.positions, parts.triangles, kJoin);
    EXPECT_GT(mesh.repairs().joinedVertices, 0);
    EXPECT_EQ(mesh.topology().components, 1);
    EXPECT_EQ(mesh.topology().boundaryLoops, 0);
  }
}

TEST(TJunctions, OfClosedSurfacesAreAllJoined) {
  for (const Shape& whole :
       {shapes::cube(), shapes::icosphere(2), shapes::torus(12, 8), shapes::perforatedPlate(2)}) {
    const TriangleMesh clean = whole.mesh();
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Shape shape = withDividedSides(whole, 1 + static_cast<int>(seed) * 3, seed);
      const TriangleMesh mesh = shape.mesh(kJoin);
      expectInvariants(mesh);
      EXPECT_GT(mesh.repairs().joinedVertices, 0);
      EXPECT_EQ(mesh.topology().components, 1);
      EXPECT_EQ(mesh.topology().boundaryLoops, 0);
      EXPECT_EQ(mesh.topology().genus, clean.topology().genus);
      EXPECT_NEAR(mesh.area(), clean.area(), 1e-5 * clean.area());

      const std::vector<SurfacePoint> sites = sampleUniform(mesh, 5, seed);
      Random random(seed);
      EXPECT_EQ(checks::complaintAboutPipeline(mesh, sites, random, {}), "");
    }
  }
}

}  // namespace
}  // namespace gvd
