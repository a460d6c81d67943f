// SPDX-License-Identifier: MIT
#include "gvd/straightest.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

/// The x axis of a point's frame in space, and its y axis.
std::pair<Vector3d, Vector3d> axes(const TriangleMesh& mesh, int face) {
  const Vector3d a = mesh.position(mesh.tail(3 * face));
  const Vector3d x = (mesh.position(mesh.tail(3 * face + 1)) - a).normalized();
  const Vector3d normal = x.cross(mesh.position(mesh.tail(3 * face + 2)) - a).normalized();
  return {x, normal.cross(x)};
}

/// A vector of the tangent plane in space, in the frame of a face.
Vector2d components(const TriangleMesh& mesh, int face, const Vector3d& v) {
  const auto [x, y] = axes(mesh, face);
  return {x.dot(v), y.dot(v)};
}

Vector3d inSpace(const TriangleMesh& mesh, int face, const Vector2d& v) {
  const auto [x, y] = axes(mesh, face);
  return v.x() * x + v.y() * y;
}

Vector2d rotated(const Vector2d& v, double angle) { return Eigen::Rotation2Dd(angle) * v; }

/// The components of a vector carried along a geodesic.
Vector2d carried(const Vector2d& v, const StraightestGeodesic& way) {
  return rotated(v, std::atan2(way.frame.y(), way.frame.x()));
}

void expectOnSurface(const SurfacePoint& p) {
  EXPECT_GE(p.bary.minCoeff(), 0);
  EXPECT_NEAR(p.bary.sum(), 1, 1e-12);
}

class Plane : public ::testing::TestWithParam<int> {};

TEST_P(Plane, GeodesicsAreLinesAndFramesStayAsTheyAre) {
  const auto mesh = shapes::randomTriangulation(60, 40, GetParam()).mesh();
  const auto starts = sampleUniform(mesh, 50, 1), ends = sampleUniform(mesh, 50, 2);
  for (size_t i = 0; i < starts.size(); ++i) {
    const int face = starts[i].face;
    const Vector3d from = mesh.position(starts[i]), to = mesh.position(ends[i]);
    const auto way = walkStraight(mesh, starts[i], components(mesh, face, to - from));
    expectOnSurface(way.end);
    EXPECT_LT((mesh.position(way.end) - to).norm(), 1e-9) << i;
    EXPECT_NEAR(way.length, (to - from).norm(), 1e-12);
    EXPECT_FALSE(way.metBoundary);
    const Vector3d x = inSpace(mesh, face, {1, 0}), moved = inSpace(mesh, way.end.face, way.frame);
    // Needles of area 1e-7 leave that much of a doubt about directions.
    EXPECT_LT((x - moved).norm(), 1e-6) << i;
  }
}

TEST_P(Plane, FromVertexToVertex) {
  const auto mesh = shapes::grid(6, 5, GetParam() % 2 ? 0.2 : 0, GetParam()).mesh();
  for (int a = 0; a < mesh.vertexCount(); a += 3)
    for (int b = 0; b < mesh.vertexCount(); b += 5) {
      const SurfacePoint start = pointAtVertex(mesh, a);
      const Vector3d path = mesh.position(b) - mesh.position(a);
      const auto way = walkStraight(mesh, start, components(mesh, start.face, path));
      EXPECT_LT((mesh.position(way.end) - mesh.position(b)).norm(), 1e-9) << a << " to " << b;
    }
}

TEST_P(Plane, StopsAtTheBoundaryOrSlidesAlongIt) {
  const auto mesh = shapes::randomTriangulation(60, 40, GetParam()).mesh();
  for (const SurfacePoint& start : sampleUniform(mesh, 50, GetParam())) {
    const Vector3d from = mesh.position(start), path(5, 0.3 * (1 - from.y()), 0);
    const Vector2d move = components(mesh, start.face, path);
    const auto stopped = walkStraight(mesh, start, move);
    EXPECT_TRUE(stopped.metBoundary);
    const Vector3d hit = from + path * (1 - from.x()) / path.x();
    EXPECT_LT((mesh.position(stopped.end) - hit).norm(), 1e-9);
    const auto slid = walkStraight(mesh, start, move, AtBoundary::kSlide);
    EXPECT_TRUE(slid.metBoundary);
    const double rest = path.norm() - (hit - from).norm();
    const double top = std::min(1.0, hit.y() + rest * path.y() / path.norm());
    EXPECT_LT((mesh.position(slid.end) - Vector3d(1, top, 0)).norm(), 1e-9);
    const Vector3d x = inSpace(mesh, start.face, {1, 0});
    EXPECT_LT((x - inSpace(mesh, slid.end.face, slid.frame)).norm(), 1e-6);
  }
}

TEST_P(Plane, FromEdgesAtAnyAngleToThem) {
  const auto mesh = shapes::randomTriangulation(60, 40, GetParam()).mesh();
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    for (const double angle : {0.0, 1e-17, -1e-15, 1e-13, -1e-12, 1e-11, -1e-7, 0.1, -0.1}) {
      const SurfacePoint start{TriangleMesh::faceOf(h),
                               0.4 * Vector3d::Unit(h % 3) + 0.6 * Vector3d::Unit((h + 1) % 3)};
      const Vector3d along = mesh.position(mesh.tip(h)) - mesh.position(mesh.tail(h));
      for (const double edges : {0.3, -0.3, 0.7, -0.7}) {
        const Vector3d path = edges * (along + angle * Vector3d(-along.y(), along.x(), 0));
        const Vector3d to = mesh.position(start) + path;
        if (to.head<2>().minCoeff() < 0 || to.head<2>().maxCoeff() > 1) continue;
        const auto way = walkStraight(mesh, start, components(mesh, start.face, path));
        EXPECT_LT((mesh.position(way.end) - to).norm(), 1e-9) << h << ' ' << angle << ' ' << edges;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Plane, ::testing::Range(0, 10));

TEST(WalkStraight, LeavesTheBoundaryWhereItTurnsAway) {
  // The L's inner corner is (1,1): down along x = 1 from above, straight on leads into the surface.
  const auto mesh = shapes::ell(3).mesh();
  const Vector3d from(0.5, 1.5, 0), path(2, -1, 0);
  SurfacePoint start;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.position(mesh.tail(3 * f + i));
    corners.row(2).setOnes();
    const Vector3d bary = corners.inverse() * Vector3d(from.x(), from.y(), 1);
    if (bary.minCoeff() > -1e-12) start = {f, bary.cwiseMax(0)};
  }
  // It meets x = 1 at (1, 1.25) after a quarter of the way; of the rest the part along y remains.
  const auto way =
      walkStraight(mesh, start, components(mesh, start.face, path), AtBoundary::kSlide);
  EXPECT_LT((mesh.position(way.end) - Vector3d(1, 0.5, 0)).norm(), 1e-9);
  EXPECT_NEAR(way.length, path.norm() / 4 + 0.75, 1e-9);
  EXPECT_TRUE(way.metBoundary);
}

/// The direction of a halfedge in the frame of its face, which is intrinsic: mollification
/// lengthens edges, so that the angles of positions may be others.
Vector2d directionOf(const TriangleMesh& mesh, int h) {
  const TriangleMesh::Face& face = mesh.face(TriangleMesh::faceOf(h));
  const std::array<Vector2d, 3> corners = {Vector2d(0, 0), Vector2d(face.lengths[0], 0),
                                           apexOf(face, 0)};
  return (corners[(h + 1) % 3] - corners[h % 3]).normalized();
}

/// Walks from points of an edge towards each of its ends, given in each of its faces.
void expectExactWalksAlong(const TriangleMesh& mesh, int halfedge) {
  for (const int h : {halfedge, mesh.twin(halfedge)})
    for (const double share : {0.3, 0.5, 0.9}) {
      if (h < 0) continue;
      const int face = TriangleMesh::faceOf(h), end = (h + 1) % 3;
      const Vector3d to = Vector3d::Unit(end);
      const SurfacePoint start{face, (1 - share) * Vector3d::Unit(h % 3) + share * to};
      const Vector3d along = mesh.position(mesh.tip(h)) - mesh.position(mesh.tail(h));
      const double rounding = 1e-14 * std::max(mesh.longestEdge(mesh.tail(h)), 1.0);
      for (const double walked : {0.99 * (1 - share), -0.99 * share}) {
        const auto way = walkStraight(mesh, start, walked * mesh.length(h) * directionOf(mesh, h));
        const Vector3d expected = mesh.position(start) + walked * along;
        EXPECT_LT((mesh.position(way.end) - expected).norm(), rounding) << h << ' ' << share;
        EXPECT_NEAR(way.length, std::abs(walked) * mesh.length(h), rounding);
        EXPECT_FALSE(way.metBoundary);
      }
    }
}

TEST(WalkStraight, IsExactAlongEdges) {
  std::vector<TriangleMesh> meshes = {
      shapes::cube().mesh(), shapes::tetrahedron().mesh(), shapes::gradedDisk(30, 5, 0.5).mesh(),
      shapes::torus(12, 7).mesh(), shapes::randomTriangulation(60, 40, 1, 6).mesh()};
  for (int seed = 0; seed < 10; ++seed) meshes.push_back(shapes::randomMesh(seed));
  for (const TriangleMesh& mesh : meshes)
    for (int h = 0; h < mesh.halfedgeCount(); ++h)
      if (h > mesh.twin(h)) expectExactWalksAlong(mesh, h);
}

TEST(WalkStraight, AlongEdgesThroughVertices) {
  // Lines of a plane grid, its boundary included, and its diagonals: from the middle of every edge
  // past vertices to a point of another edge.
  const auto mesh = shapes::grid(5, 4).mesh();
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const Vector3d a = mesh.position(mesh.tail(h)), b = mesh.position(mesh.tip(h));
    const SurfacePoint start{TriangleMesh::faceOf(h),
                             0.5 * (Vector3d::Unit(h % 3) + Vector3d::Unit((h + 1) % 3))};
    for (const double edges : {0.5, 1.2, 2.25}) {
      const Vector3d to = mesh.position(start) + edges * (b - a);
      if (to.head<2>().minCoeff() < 0 || to.head<2>().maxCoeff() > 1) continue;
      const auto way = walkStraight(mesh, start, components(mesh, start.face, to - (a + b) / 2));
      EXPECT_LT((mesh.position(way.end) - to).norm(), 1e-14) << h << ' ' << edges;
    }
  }
}

TEST(WalkStraight, AlongAnEdgeOfACubeAndOverItsCorner) {
  // From (0,0,.7) down to the corner, then between two sides of the bottom, 3π/4 from the edge.
  const auto mesh = shapes::cube().mesh();
  const Vector3d from(0, 0, 0.7);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Vector3d bary = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      const Vector3d corner = mesh.position(mesh.tail(3 * f + i));
      if (corner.head<2>() == Vector2d::Zero()) bary[i] = corner.z() == 0 ? 0.3 : 0.7;
    }
    if (bary.sum() != 1) continue;
    const auto near = walkStraight(mesh, {f, bary}, components(mesh, f, Vector3d(0, 0, -0.35)));
    EXPECT_LT((mesh.position(near.end) - Vector3d(0, 0, 0.35)).norm(), 1e-15);
    const auto far = walkStraight(mesh, {f, bary}, components(mesh, f, Vector3d(0, 0, -1.2)));
    EXPECT_LT((mesh.position(far.end) - Vector3d(1, 1, 0) * 0.5 / std::sqrt(2)).norm(), 1e-15);
  }
}

TEST(WalkStraight, GoesAroundACubeAndComesBack) {
  const auto mesh = shapes::cube().mesh();
  for (const SurfacePoint& start : sampleUniform(mesh, 100, 1)) {
    const auto [x, y] = axes(mesh, start.face);
    // Along an axis of space, which lies in the start's face: four sides of length 1.
    const Vector3d axis = Vector3d::Unit(std::abs(x.x()) > 0.9 || std::abs(y.x()) > 0.9 ? 0 : 1);
    const auto way = walkStraight(mesh, start, 4 * components(mesh, start.face, axis));
    EXPECT_LT((mesh.position(way.end) - mesh.position(start)).norm(), 1e-12);
    const Vector3d before = inSpace(mesh, start.face, {1, 0});
    EXPECT_LT((inSpace(mesh, way.end.face, way.frame) - before).norm(), 1e-12);
  }
}

TEST(WalkStraight, LeavesEqualAnglesOnBothSidesOfAVertex) {
  for (const double angleSum : {2.0, 4.5, 2 * pi, 8.0, 12.0}) {
    const auto mesh = shapes::vertexFan(8, angleSum).mesh();
    const int middle = 0, h = mesh.outgoing(middle);
    // In along an edge, to half the angle sum: with 8 equal corners out along the edge opposite.
    const SurfacePoint rim = pointAtVertex(mesh, mesh.tip(h));
    const SurfacePoint start{TriangleMesh::faceOf(h),
                             0.5 * (Vector3d::Unit(h % 3) + Vector3d::Unit((h + 1) % 3))};
    const Vector3d inward = mesh.position(middle) - mesh.position(rim);
    const auto way = walkStraight(mesh, start, components(mesh, start.face, inward));
    int opposite = h;
    for (int i = 0; i < 4; ++i) opposite = mesh.rotate(opposite);
    const Vector3d expected = 0.5 * (mesh.position(middle) + mesh.position(mesh.tip(opposite)));
    EXPECT_LT((mesh.position(way.end) - expected).norm(), 1e-9) << angleSum;
    // The frame keeps its angle to the way.
    const Vector2d direction = components(mesh, way.end.face, expected - mesh.position(middle));
    const Vector2d tangent = carried(components(mesh, start.face, inward), way);
    EXPECT_LT((direction.normalized() - tangent.normalized()).norm(), 1e-9) << angleSum;
  }
}

TEST(WalkStraight, TurnsFramesByTheCurvatureWalkedAround) {
  const double angleSum = 5;
  const auto mesh = shapes::vertexFan(10, angleSum).mesh();
  // A closed polygon around the middle: from the centre of each face to that of the next.
  SurfacePoint at{TriangleMesh::faceOf(mesh.outgoing(0)), Vector3d::Constant(1.0 / 3)};
  const int first = at.face;
  Vector2d v(1, 0);
  const auto apexIn = [&](int face) {
    int corner = 3 * face;
    while (mesh.tail(corner) != 0) ++corner;
    return corner;
  };
  for (int i = 0; i < 10; ++i) {
    // Each leg turns by the corner angle: perpendicular to the symmetry axis, tilted by half of it.
    const int corner = apexIn(at.face);
    const Vector3d apex = mesh.position(0);
    const Vector3d out = mesh.position(at) - apex;
    const Vector2d radial = components(mesh, at.face, out);
    const double corners = mesh.cornerAngle(corner);
    const Vector2d target = rotated(radial, corners);
    const auto way = walkStraight(mesh, at, target - radial);
    v = carried(v, way);
    at = way.end;
  }
  EXPECT_EQ(at.face, first);
  EXPECT_LT((at.bary - Vector3d::Constant(1.0 / 3)).norm(), 1e-9);
  EXPECT_LT((v - rotated({1, 0}, 2 * pi - angleSum)).norm(), 1e-9);
}

TEST(WalkStraight, ComesBackWhereItCameFrom) {
  for (int seed = 0; seed < 20; ++seed) {
    const auto mesh = shapes::bumpySurface(seed % 4, 1, 0.4, seed).mesh();
    shapes::Random random(seed);
    for (const SurfacePoint& start : sampleUniform(mesh, 40, seed)) {
      const Vector2d move = 3 * rotated({1, 0}, random.uniform(0, 2 * pi));
      const auto there = walkStraight(mesh, start, move);
      expectOnSurface(there.end);
      EXPECT_NEAR(there.length, 3, 1e-12);
      const auto back = walkStraight(mesh, there.end, -carried(move, there));
      EXPECT_LT((mesh.position(back.end) - mesh.position(start)).norm(), 1e-8);
    }
  }
}

TEST(WalkStraight, ApproachesGreatCircles) {
  const auto mesh = shapes::icosphere(5).mesh();
  for (const SurfacePoint& start : sampleUniform(mesh, 20, 1)) {
    const Vector3d from = mesh.position(start).normalized();
    const auto [x, y] = axes(mesh, start.face);
    const auto way = walkStraight(mesh, start, {1, 0});
    const Vector3d tangent = (x - x.dot(from) * from).normalized();
    const Vector3d expected = std::cos(1.0) * from + std::sin(1.0) * tangent;
    EXPECT_LT((mesh.position(way.end).normalized() - expected).norm(), 5e-3);
  }
}

TEST(WalkStraight, EndsOnAnyMesh) {
  // Faces of no area, a cap among them; long ways over few faces; every kind of start.
  shapes::Shape shape = shapes::triangle();
  shape.addTriangle(1, 0, shape.addVertex({0.5, 0, 0}));
  shape.addTriangle(0, 3, shape.addVertex({0.25, -1, 0}));
  shape.addTriangle(3, 1, shape.addVertex({0.75, -1, 0}));
  const std::vector<TriangleMesh> meshes = {shape.mesh(), shapes::tetrahedron().mesh(),
                                            shapes::gradedDisk(30, 5, 0.5).mesh(),
                                            shapes::moebiusStrip(9).mesh()};
  shapes::Random random(5);
  for (const TriangleMesh& mesh : meshes)
    for (int f = 0; f < mesh.faceCount(); ++f)
      for (const Vector3d& bary :
           {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(0.5, 0.5, 0), Vector3d(0.2, 0, 0.8),
            Vector3d(1e-14, 0.5, 0.5 - 1e-14), Vector3d(0.2, 0.3, 0.5)})
        for (const AtBoundary atBoundary : {AtBoundary::kStop, AtBoundary::kSlide})
          for (const double length : {1e-9, 0.3, 1000.0}) {
            const Vector2d move = length * rotated({1, 0}, random.uniform(0, 2 * pi));
            const auto way = walkStraight(mesh, {f, bary}, move, atBoundary);
            expectOnSurface(way.end);
            EXPECT_NEAR(way.frame.norm(), 1, 1e-12);
            EXPECT_LE(way.length, length * (1 + 1e-12));
            if (!way.metBoundary) {
              EXPECT_NEAR(way.length, length, 1e-9 * length);
            }
          }
}

TEST(WalkStraight, PassesThroughFacesWithoutArea) {
  // The cap lies on the side 0-1 of the triangle; behind it is one more face. The cap has a height
  // of some 1e-6 (mollification), which the walk needs to get through it.
  shapes::Shape shape = shapes::triangle();
  shape.addTriangle(1, 0, shape.addVertex({0.5, 0, 0}));
  shape.addTriangle(0, 3, shape.addVertex({0.25, -1, 0}));
  // Turned to fit: (3, 0) runs against (0, 3) of the cap.
  const auto mesh = shape.mesh();
  const SurfacePoint start{0, Vector3d(0.5, 0.2, 0.3)};
  ASSERT_EQ(mesh.position(start), Vector3d(0.2, 0.3, 0));
  const auto way = walkStraight(mesh, start, components(mesh, 0, Vector3d(0, -0.5, 0)));
  EXPECT_LT((mesh.position(way.end) - Vector3d(0.2, -0.2, 0)).norm(), 1e-5);
}

TEST(WalkStraight, GoesNowhereWithoutAFiniteMove) {
  const auto mesh = shapes::cube().mesh();
  const SurfacePoint start{3, Vector3d(0.2, 0.3, 0.5)};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector2d& move : {Vector2d(0, 0), Vector2d(nan, 1), Vector2d(1 / 0.0, 0)}) {
    const auto way = walkStraight(mesh, start, move);
    EXPECT_EQ(way.end.face, start.face);
    EXPECT_EQ(way.end.bary, start.bary);
    EXPECT_EQ(way.frame, Vector2d(1, 0));
    EXPECT_EQ(way.length, 0);
  }
}

TEST(WalkStraight, LeavesAConeAlongItsFirstEdgeInTheDirectionsOfTheGap) {
  const auto mesh = shapes::tetrahedron().mesh();  // angle sums of π
  const int h = mesh.outgoing(0);
  ASSERT_EQ(h % 3, 0);
  for (const double angle : {1.05 * pi, 1.3 * pi, 1.5 * pi, 1.95 * pi}) {
    const auto way = walkStraight(mesh, pointAtVertex(mesh, 0), 0.5 * rotated({1, 0}, angle));
    const Vector3d along = (mesh.position(mesh.tip(h)) - mesh.position(0)).normalized();
    EXPECT_LT((mesh.position(way.end) - mesh.position(0) - 0.5 * along).norm(), 1e-12) << angle;
  }
}

TEST(WalkStraight, GoesAsFarAsItsCrossingsWhateverIsAskedFor) {
  const auto mesh = shapes::cube().mesh();
  const auto walked = [&](double length) {
    return walkStraight(mesh, {0, {0.2, 0.3, 0.5}}, length * Vector2d(0.8, 0.6)).length;
  };
  EXPECT_GT(walked(1e9), 1e4);
  EXPECT_NEAR(walked(1e15), walked(1e9), 1e-3);
}

TEST(WalkStraight, RefusesAStartThatIsNotOnTheMesh) {
  const auto mesh = shapes::cube().mesh();
  EXPECT_THROW(walkStraight(mesh, {12, Vector3d(1, 0, 0)}, {1, 0}), Error);
  EXPECT_THROW(walkStraight(mesh, {-1, Vector3d(1, 0, 0)}, {1, 0}), Error);
  EXPECT_THROW(walkStraight(mesh, {0, Vector3d(0.5, 0.5, 0.5)}, {1, 0}), Error);
}

TEST(WalkStraight, EndsWhereItWindsAroundASpikeForEver) {
  const TriangleMesh mesh = shapes::vertexFan(3, 1e-9).mesh();
  const auto end = walkStraight(mesh, {0, {0.2, 0.4, 0.4}}, {0, 1}, AtBoundary::kSlide);
  EXPECT_GE(end.end.bary.minCoeff(), 0);
  EXPECT_LE(end.length, 1);
}

}  // namespace
}  // namespace gvd
