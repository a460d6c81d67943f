// SPDX-License-Identifier: MIT
#include "gvd/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gvd/error.h"
#include "shapes.h"

namespace gvd {
namespace {

double totalGaussian(const TriangleMesh& mesh) {
  const auto gaussian = vertexCurvatures(mesh).gaussian;
  double sum = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    sum += gaussian[mesh.tail(h)] * mesh.faceArea(TriangleMesh::faceOf(h)) / 3;
  return sum;
}

/// Σ ρ · area over the vertices, over the area.
double meanDensity(const TriangleMesh& mesh, const std::vector<double>& density) {
  double sum = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    sum += density[mesh.tail(h)] * mesh.faceArea(TriangleMesh::faceOf(h)) / 3;
  return sum / mesh.area();
}

TEST(VertexCurvatures, OfTheUnitSphereAreOne) {
  const auto curvatures = vertexCurvatures(shapes::icosphere(4).mesh());
  for (const double k : curvatures.gaussian) EXPECT_NEAR(k, 1, 0.2);
  for (const double h : curvatures.mean) EXPECT_NEAR(h, 1, 0.2);
}

TEST(VertexCurvatures, OfACylinderAreHalfItsInverseRadius) {
  const auto mesh = shapes::cylinder(60, 20, 2, 4).mesh();
  const auto curvatures = vertexCurvatures(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_NEAR(curvatures.gaussian[v], 0, 1e-9);
    EXPECT_NEAR(curvatures.mean[v], 0.25, 0.01);
  }
}

/// Two triangles on both sides of an edge, one of them cut in two at a vertex within the edge.
/// The mean curvature there was 1.5: the face that fills the gap had no normal.
TEST(VertexCurvatures, AreNoneInThePlaneAtAVertexWithinAnEdge) {
  for (const double height : {0.0, 1e-160, 1e-12, 1e-9}) {
    shapes::Shape shape;
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
          Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0.25, 0, height)})
      shape.addVertex(p);
    shape.addTriangle(0, 3, 1);
    shape.addTriangle(0, 4, 2);
    shape.addTriangle(4, 1, 2);
    const auto joined = vertexCurvatures(shape.mesh({.weld = 1e-8}));
    EXPECT_NEAR(joined.mean[4], 0, 1e-8) << height;
    shape.addTriangle(0, 1, 4);
    EXPECT_NEAR(vertexCurvatures(shape.mesh()).mean[4], 0, 1e-8) << height;
  }
}

TEST(VertexCurvatures, OfClosedSurfacesSumToTwoPiTimesTheEulerCharacteristic) {
  for (int genus = 0; genus < 4; ++genus) {
    const auto mesh = shapes::bumpySurface(genus, 2, 0.3, genus).mesh();
    EXPECT_NEAR(totalGaussian(mesh), 2 * std::numbers::pi * (2 - 2 * genus), 1e-9);
  }
}

TEST(CurvatureDensity, IsOneWhereCurvatureIsTheSameEverywhere) {
  for (const auto& shape : {shapes::grid(6, 6, 0.2, 1), shapes::icosphere(4)}) {
    for (const double rho : curvatureDensity(shape.mesh())) EXPECT_NEAR(rho, 1, 0.1);
  }
}

TEST(CurvatureDensity, IsOneOnALongFlatStrip) {
  shapes::Shape strip = shapes::grid(4, 2000);
  for (size_t i = 0; i < strip.positions.size(); i += 3) {
    const double x = strip.positions[i], y = strip.positions[i + 1];
    strip.positions[i] = 2000 * (0.36 * x - 0.8 * y);
    strip.positions[i + 1] = 2000 * (0.48 * x + 0.6 * y);
    strip.positions[i + 2] = 2000 * 0.8 * x;
  }
  for (const double rho : curvatureDensity(strip.mesh())) ASSERT_EQ(rho, 1);
}

TEST(CurvatureDensity, IsLargeWhereTheSurfaceIsBent) {
  // The edges of a plate are bent, its large sides flat.
  const auto mesh = shapes::perforatedPlate(0, 8).mesh();
  CurvatureDensityOptions options;
  options.smoothing = 0;
  const auto density = curvatureDensity(mesh, options);
  EXPECT_NEAR(meanDensity(mesh, density), 1, 1e-9);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double defect = std::abs(2 * std::numbers::pi - mesh.angleSum(v));
    if (defect > 0.1) {
      EXPECT_GT(density[v], 1) << v;
    }
  }
  EXPECT_NEAR(*std::min_element(density.begin(), density.end()), 0.1 / 1.1, 1e-6);
}

TEST(CurvatureDensity, DoesNotDependOnUnits) {
  const auto shape = shapes::bumpySurface(1, 2, 0.3, 1);
  const auto expected = curvatureDensity(shape.mesh());
  const auto scaled = curvatureDensity(shapes::scaled(shape, 1e4).mesh());
  for (size_t v = 0; v < expected.size(); ++v)
    EXPECT_NEAR(scaled[v], expected[v], 1e-9 * expected[v]);
}

TEST(CurvatureDensity, IsPositiveAndFiniteOnAnyMesh) {
  shapes::Shape cap = shapes::triangle();
  cap.addTriangle(1, 0, cap.addVertex({0.5, 0, 0}));
  for (const auto& shape : {cap, shapes::gradedDisk(30, 5, 0.5), shapes::moebiusStrip(9),
                            shapes::randomTriangulation(60, 40, 1)}) {
    for (const double rho : curvatureDensity(shape.mesh())) {
      EXPECT_GT(rho, 0);
      EXPECT_TRUE(std::isfinite(rho));
    }
  }
}

TEST(CurvatureDensity, SmoothsNoiseAway) {
  const auto mesh = shapes::bumpySurface(0, 4, 0.4, 3).mesh();
  const auto range = [&](int smoothing) {
    CurvatureDensityOptions options;
    options.smoothing = smoothing;
    const auto density = curvatureDensity(mesh, options);
    return *std::max_element(density.begin(), density.end()) /
           *std::min_element(density.begin(), density.end());
  };
  EXPECT_LT(range(4), range(0));
  EXPECT_LT(range(32), range(4));
}

TEST(CurvatureDensity, RejectsOptionsThatMakeNoSense) {
  const auto mesh = shapes::cube().mesh();
  CurvatureDensityOptions options;
  options.smoothing = -1;
  EXPECT_THROW(curvatureDensity(mesh, options), Error);
  options = {};
  options.floor = 0;
  EXPECT_THROW(curvatureDensity(mesh, options), Error);
}

}  // namespace
}  // namespace gvd
