// SPDX-License-Identifier: MIT
//
// Points in terms of the input's triangles and vertices, and back.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "error_checks.h"
#include "gvd/error.h"
#include "gvd/triangle_mesh.h"
#include "mesh_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::errorOf;
using checks::expectTrueToInput;
using shapes::Shape;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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
