// SPDX-License-Identifier: MIT
#include "gvd/closest_point.h"

#include <gtest/gtest.h>

#include <limits>

#include "error_checks.h"
#include "gvd/error.h"
#include "mesh/nearest_on_triangle.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::errorOf;
using Eigen::Vector3d;

Vector3d randomPlace(shapes::Random& random, double radius) {
  return radius * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

/// By a look at every face.
double leastDistance(const TriangleMesh& mesh, const Vector3d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (int h = 0; h < mesh.halfedgeCount(); h += 3) {
    const std::array corners = {mesh.position(mesh.tail(h)), mesh.position(mesh.tail(h + 1)),
                                mesh.position(mesh.tail(h + 2))};
    const SurfacePoint p = {h / 3, nearestOnTriangle(place, corners).bary};
    least = std::min(least, (mesh.position(p) - place).norm());
  }
  return least;
}

TEST(ClosestPointQuery, FindsWhatLookingAtEveryFaceFinds) {
  shapes::Random random(7);
  for (int seed = 1; seed <= 40; ++seed) {
    const TriangleMesh mesh = shapes::randomMesh(seed);
    const ClosestPointQuery query(mesh);
    const Vector3d centre = mesh.position(0);
    for (int i = 0; i < 50; ++i) {
      const Vector3d place = centre + randomPlace(random, mesh.boundingDiagonal());
      const auto [point, distance] = query.closestTo(place);
      EXPECT_GE(point.bary.minCoeff(), 0);
      EXPECT_NEAR(point.bary.sum(), 1, 1e-12);
      const double rounding = 1e-12 * mesh.boundingDiagonal();
      EXPECT_NEAR((mesh.position(point) - place).norm(), distance, rounding);
      EXPECT_NEAR(distance, leastDistance(mesh, place), rounding);
    }
  }
}

TEST(ClosestPointQuery, OfAPointOnTheSurfaceIsThatPoint) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 5, 0.3, 3).mesh();
  const ClosestPointQuery query(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const auto [point, distance] = query.closestTo(mesh.position(v));
    EXPECT_EQ(distance, 0);
    EXPECT_EQ(mesh.position(point), mesh.position(v));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
    EXPECT_EQ(query.closestTo(mesh.position({f, Vector3d(0.5, 0.3, 0.2)})).point.face, f);
}

TEST(ClosestPointQuery, OfFacesThatAreAsFarIsOnTheLowest) {
  // The origin is as far from all eight faces, and from nothing else that is as near.
  const TriangleMesh mesh = shapes::octahedron().mesh();
  const auto [point, distance] = ClosestPointQuery(mesh).closestTo(Vector3d::Zero());
  EXPECT_EQ(point.face, 0);
  EXPECT_NEAR(distance, 1 / std::sqrt(3), 1e-15);
}

TEST(ClosestPointQuery, RefusesWhatHasNoDistance) {
  const TriangleMesh mesh = shapes::icosphere(1).mesh();
  const ClosestPointQuery query(mesh);
  EXPECT_NEAR(query.closestTo({1e100, 0, 0}).distance, 1e100, 1e88);
  for (const double x :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300})
    errorOf([&] { query.closestTo({0, x, 0}); }, ErrorCode::kInvalidPoint);
}

}  // namespace
}  // namespace gvd
