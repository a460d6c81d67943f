// SPDX-License-Identifier: MIT
#include "gvd/subdivision.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "error_checks.h"
#include "gvd/diagram.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mechanical_shapes.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::errorOf;
using Eigen::Vector3d;
using shapes::Shape;

Shape shapeOf(const SubdividedTriangles& parts) { return {parts.positions, parts.triangles}; }

double longestEdge(const Shape& shape) {
  double longest = 0;
  for (int t = 0; t < shape.faceCount(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = shape.triangles[3 * t + i], b = shape.triangles[3 * t + cornerAfter(i)];
      longest = std::max(longest, (shape.position(a) - shape.position(b)).norm());
    }
  return longest;
}

Vector3d areaVector(const Shape& shape, int t) {
  const int* const v = &shape.triangles[3 * t];
  const Vector3d a = shape.position(v[0]);
  return (shape.position(v[1]) - a).cross(shape.position(v[2]) - a) / 2;
}

/// Of an isosceles triangle with two long sides; rounding chose between equal diagonals.
TEST(Subdivision, DoesNotDependOnTheFirstCorner) {
  shapes::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const double angle = 6 * random.uniform();
    const Vector3d x(std::cos(angle), std::sin(angle), 0), y(-x.y(), x.x(), 0);
    Shape shape;
    for (const Vector3d& p : {Vector3d(-0.3 * x), Vector3d(0.3 * x), Vector3d(y)})
      shape.addVertex(p);
    const auto isFromFirst = [&](int a, int b, int c) {
      const auto parts = subdivide(shape.positions, {{a, b, c}}, {.maxEdge = 0.6});
      EXPECT_EQ(parts.triangles.size(), 9);
      for (int t = 0; t < 9; t += 3) {
        const std::array part = {parts.triangles[t], parts.triangles[t + 1],
                                 parts.triangles[t + 2]};
        const bool hasBoth = std::count(part.begin(), part.end(), 0) > 0 &&
                             std::count(part.begin(), part.end(), 1) > 0;
        if (!hasBoth) continue;
        const int middle = *std::max_element(part.begin(), part.end());
        return parts.ends[middle - 3] == std::array{1, 2};
      }
      return false;
    };
    EXPECT_TRUE(isFromFirst(0, 1, 2)) << i;
    EXPECT_TRUE(isFromFirst(1, 2, 0)) << i;
    EXPECT_TRUE(isFromFirst(2, 0, 1)) << i;
  }
}

TEST(Subdivision, KeepsTheSurfaceAndItsTopology) {
  for (const auto& [name, shape, genus] : shapes::mechanicalShapes()) {
    SCOPED_TRACE(name);
    const TriangleMesh whole = shape.mesh();
    for (const double share : {0.3, 0.07}) {
      const auto parts = subdivide(shape.positions, shape.triangles, {.maxEdge = share});
      const Shape fine = shapeOf(parts);
      EXPECT_LE(longestEdge(fine), share * whole.boundingDiagonal() * (1 + 1e-12));
      const TriangleMesh mesh = fine.mesh();
      EXPECT_EQ(mesh.faceCount(), fine.faceCount());
      EXPECT_EQ(mesh.topology().boundaryLoops, 0);
      EXPECT_EQ(mesh.topology().genus, genus);
      EXPECT_EQ(mesh.repairs().weldedVertices, whole.repairs().weldedVertices);
      EXPECT_EQ(mesh.repairs().mollifiedTriangles, 0);
      EXPECT_NEAR(mesh.area(), whole.area(), 1e-12 * whole.area());
    }
  }
}

TEST(Subdivision, NamesWhatEachPartAndMidpointComesFrom) {
  const Shape shape = shapes::mechanicalShapes().front().shape;
  const auto parts = subdivide(shape.positions, shape.triangles, {.maxEdge = 0.1});
  const Shape fine = shapeOf(parts);
  ASSERT_EQ(parts.parents.size(), static_cast<std::size_t>(fine.faceCount()));
  EXPECT_TRUE(std::is_sorted(parts.parents.begin(), parts.parents.end()));
  std::vector<Vector3d> sums(shape.faceCount(), Vector3d::Zero());
  for (int t = 0; t < fine.faceCount(); ++t) {
    const Vector3d own = areaVector(fine, t), all = areaVector(shape, parts.parents[t]);
    EXPECT_GT(own.dot(all), 0) << "turned over";
    sums[parts.parents[t]] += own;
  }
  for (int t = 0; t < shape.faceCount(); ++t)
    EXPECT_LE((sums[t] - areaVector(shape, t)).norm(), 1e-12 * sums[t].norm());
  ASSERT_EQ(fine.vertexCount(), shape.vertexCount() + static_cast<int>(parts.ends.size()));
  for (int v = 0; v < fine.vertexCount(); ++v) {
    if (v < shape.vertexCount()) {
      EXPECT_EQ(fine.position(v), shape.position(v));
      continue;
    }
    const auto [a, b] = parts.ends[v - shape.vertexCount()];
    EXPECT_LT(std::max(a, b), v);
    EXPECT_EQ(fine.position(v), (fine.position(a) + fine.position(b)) / 2);
  }
}

TEST(Subdivision, LeavesTrianglesWithoutLongSidesAlone) {
  const Shape shape = shapes::grid(3, 3);
  const auto parts = subdivide(shape.positions, shape.triangles, {.maxEdge = 0.5});
  EXPECT_EQ(parts.positions, shape.positions);
  EXPECT_EQ(parts.triangles, shape.triangles);
  EXPECT_TRUE(parts.ends.empty());
}

TEST(Subdivision, PutsMidpointsOfSeamsAtTheSamePlace) {
  // Each triangle has vertices of its own, as in STL.
  Shape apart;
  const Shape shape = shapes::icosphere(1);
  for (const int v : shape.triangles) apart.triangles.push_back(apart.addVertex(shape.position(v)));
  const Shape fine = shapeOf(subdivide(apart.positions, apart.triangles, {.maxEdge = 0.05}));
  const TriangleMesh mesh = fine.mesh();
  EXPECT_GT(mesh.faceCount(), 4 * shape.faceCount());
  EXPECT_EQ(mesh.topology().boundaryLoops, 0);
  EXPECT_EQ(mesh.topology().eulerCharacteristic, 2);
}

TEST(Subdivision, LeavesTrianglesThatAreNotFiniteToTheMesh) {
  Shape shape = shapes::triangle();
  for (const double x :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    shape.addTriangle(0, 1, shape.addVertex({x, 0, 0}));
  const TriangleMesh mesh =
      shapeOf(subdivide(shape.positions, shape.triangles, {.maxEdge = 0.2})).mesh();
  EXPECT_EQ(mesh.repairs().nonFiniteTriangles, 2);
  EXPECT_NEAR(mesh.area(), 0.5, 1e-15);
}

/// The share of random points whose nearest site is not the label of the face that they are in.
/// Points in mixed faces do not count.
double wrongShare(const Shape& shape) {
  const TriangleMesh mesh = shape.mesh();
  const auto sites = sampleUniform(mesh, 10, 4);
  const auto distances = finished(propagate(mesh, sites, Metric::kExact));
  const Diagram diagram = traceDiagram(mesh, *distances, 10);
  int wrong = 0, points = 0;
  for (const SurfacePoint& p : sampleUniform(mesh, 5000, 5)) {
    const int label = diagram.faceLabel[p.face];
    if (label < 0) continue;
    ++points;
    wrong += label != distances->nearest(p).label;
  }
  return static_cast<double>(wrong) / points;
}

DiagramAccuracy accuracyOf(const Shape& shape, int detail) {
  const TriangleMesh mesh = shape.mesh();
  const auto sites = sampleUniform(mesh, 10, 4);
  const auto field = finished(propagate(mesh, sites, Metric::kExact));
  return accuracy(mesh, *field, traceDiagram(mesh, *field, 10, {.detail = detail}));
}

TEST(Subdivision, EndsWhereCoordinatesAreHardlyFineEnough) {
  Shape shape = shapes::triangle();
  for (int v = 0; v < 3; ++v) shape.setPosition(v, 1e-14 * shape.position(v) + Vector3d(1, 1, 1));
  const auto parts = subdivide(shape.positions, shape.triangles, {.maxEdge = 1e-3});
  EXPECT_LE(parts.triangles.size(), 300u);
}

TEST(Subdivision, LetsDiagramsFindRegionsBetweenTheCornersOfLongTriangles) {
  const auto [name, shape, genus] = shapes::mechanicalShapes().front();
  ASSERT_EQ(name, "plate with a round hole");
  EXPECT_GE(wrongShare(shape), 0.05);
  EXPECT_EQ(wrongShare(shapeOf(subdivide(shape.positions, shape.triangles, {.maxEdge = 0.03}))), 0);
}

TEST(Subdivision, HelpsAsTheAccuracyProposes) {
  const Shape shape = shapes::mechanicalShapes().front().shape;
  const auto [mislabelled, maxEdge] = accuracyOf(shape, 0);
  EXPECT_GE(mislabelled, 0.05);
  const Shape finer = shapeOf(subdivide(shape.positions, shape.triangles, {.maxEdge = maxEdge}));
  EXPECT_LE(accuracyOf(finer, 1).mislabelled, 0.01);
  EXPECT_LE(accuracyOf(finer, 1).maxEdge, maxEdge / 2 * (1 + 1e-12));
}

TEST(Subdivision, RejectsWhatItCannotDo) {
  const Shape shape = shapes::grid(2, 2);
  const auto error = [&](SubdivisionOptions options) {
    return errorOf([&] { subdivide(shape.positions, shape.triangles, options); },
                   ErrorCode::kInvalidArgument);
  };
  EXPECT_EQ(error({.maxEdge = 0}), "maxEdge is 0, not above 0 and at most 1");
  EXPECT_EQ(error({.maxEdge = std::numeric_limits<double>::quiet_NaN()}),
            "maxEdge is NaN, not above 0 and at most 1");
  EXPECT_EQ(error({.maxEdge = 0.1, .maxTriangles = 0}), "maxTriangles is 0, not positive");
  EXPECT_EQ(error({.maxEdge = 0.1, .maxTriangles = 40}),
            "with no edge longer than 0.1 of the diagonal, there would be more than 40 triangles");
  EXPECT_EQ(error({.maxEdge = 1e-300, .maxTriangles = 1000000}),
            "with no edge longer than 1e-300 of the diagonal, there would be more than 1000000 "
            "triangles");
  EXPECT_EQ(errorOf(
                [&] {
                  subdivide(shape.positions, {0, 1, 9}, {.maxEdge = 0.1});
                },
                ErrorCode::kInvalidMesh),
            "triangle 0 has vertex index 9, but the number of vertices is 9");
}

}  // namespace
}  // namespace gvd
