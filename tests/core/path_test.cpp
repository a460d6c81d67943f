// SPDX-License-Identifier: MIT
//
// Paths to sites. That the distances are right is tested elsewhere; here, that the paths are as
// long.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "equality.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mechanical_shapes.h"
#include "mesh/incidence.h"
#include "random_case.h"
#include "shapes.h"

namespace gvd {
namespace {

constexpr double kTolerance = 1e-9;

using Path = std::vector<SurfacePoint>;

std::unique_ptr<DistanceField> fieldOf(const TriangleMesh& mesh,
                                       const std::vector<SurfacePoint>& sites, Metric metric) {
  return finished(propagate(mesh, sites, metric));
}

/// The vertices and random points, in faces and on edges.
std::vector<SurfacePoint> pointsOf(const TriangleMesh& mesh, int count, int seed) {
  std::vector<SurfacePoint> points = sampleUniform(mesh, count, seed);
  for (int i = 0; i < count; i += 3) {
    points[i].bary[i / 3 % 3] = 0;
    points[i].bary /= points[i].bary.sum();
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) points.push_back(pointAtVertex(mesh, v));
  return points;
}

/// In faces, on edges and at vertices.
std::vector<SurfacePoint> sitesOf(const TriangleMesh& mesh, int count, int seed) {
  std::vector<SurfacePoint> sites = sampleUniform(mesh, count, seed);
  for (int i = 0; i < count; ++i) {
    if ((seed + i) % 3 == 1) {
      sites[i].bary[i % 3] = 0;
      sites[i].bary /= sites[i].bary.sum();
    } else if ((seed + i) % 3 == 2) {
      sites[i].bary = Eigen::Vector3d::Unit(i % 3);
    }
  }
  return sites;
}

/// Whether a path begins and ends where it should, all between are crossings or vertices, and none
/// is met twice in succession. That points in succession share a face shows in a finite length.
void expectPolyline(const TriangleMesh& mesh, const Path& path, const SurfacePoint& from,
                    const SurfacePoint& site) {
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), from);
  if (path.size() > 1) {
    EXPECT_EQ(path.back(), site);
  }
  EXPECT_LT(lengthOf(mesh, path), kInfinity);
  for (size_t i = 1; i < path.size(); ++i) EXPECT_GT(lengthOf(mesh, {&path[i - 1], 2}), 0);
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    EXPECT_LE(path[i].bary.minCoeff(), 0);
    EXPECT_GE(path[i].bary.minCoeff(), 0);
    EXPECT_NEAR(path[i].bary.sum(), 1, 1e-15);
  }
}

/// Checks the exact paths of all points to their nearest sites. Returns how many there are.
int checkExact(const TriangleMesh& mesh, const std::vector<SurfacePoint>& sites,
               const std::vector<SurfacePoint>& points) {
  const auto field = fieldOf(mesh, sites, Metric::kExact);
  int count = 0;
  for (const SurfacePoint& p : points) {
    const LabelledDistance nearest = field->nearest(p);
    if (nearest.label < 0) {
      EXPECT_TRUE(field->path(0, p).empty());
      continue;
    }
    ++count;
    const Path path = field->path(nearest.label, p);
    expectPolyline(mesh, path, p, sites[nearest.label]);
    EXPECT_NEAR(lengthOf(mesh, path), nearest.distance, kTolerance * nearest.distance)
        << "from face " << p.face << ", " << p.bary.transpose();
  }
  return count;
}

/// Checks that the paths between points are as long as distances that have spread everywhere.
/// Returns how many there are.
int checkBetween(const TriangleMesh& mesh, const std::vector<SurfacePoint>& ends,
                 const std::vector<SurfacePoint>& points) {
  int count = 0;
  for (const SurfacePoint& to : ends) {
    const auto field = fieldOf(mesh, {to}, Metric::kExact);
    for (const SurfacePoint& from : points) {
      const Path path = shortestPath(mesh, from, to);
      const double distance = field->distance(0, from);
      if (distance == kInfinity) {
        EXPECT_TRUE(path.empty());
        continue;
      }
      ++count;
      expectPolyline(mesh, path, from, to);
      EXPECT_NEAR(lengthOf(mesh, path), distance, kTolerance * distance)
          << "from face " << from.face << ", " << from.bary.transpose();
    }
  }
  return count;
}

/// Sums over paths of DGPC.
struct Lengths {
  double relative = 0;  ///< of | length - distance | / distance
  int count = 0;
};

void addApproximate(const TriangleMesh& mesh, const std::vector<SurfacePoint>& sites,
                    const std::vector<SurfacePoint>& points, Lengths& lengths) {
  const auto field = fieldOf(mesh, sites, Metric::kDgpc);
  for (const SurfacePoint& p : points) {
    const LabelledDistance nearest = field->nearest(p);
    if (nearest.label < 0) continue;
    const Path path = field->path(nearest.label, p);
    expectPolyline(mesh, path, p, sites[nearest.label]);
    if (!(nearest.distance > 1e-9)) continue;
    lengths.relative += std::abs(lengthOf(mesh, path) - nearest.distance) / nearest.distance;
    ++lengths.count;
  }
}

/// Saddles, inner corners, boundaries with holes, closed surfaces, much refined and thin faces.
std::vector<TriangleMesh> meshes() {
  std::vector<TriangleMesh> result = {
      shapes::subdivided(shapes::subdivided(shapes::vertexFan(8, 8.5))).mesh(),
      shapes::ell(3).mesh(),
      shapes::spiral(30).mesh(),
      shapes::annulus(12, 3).mesh(),
      shapes::gradedDisk(20, 8, 0.5).mesh(),
      shapes::withoutRandomFaces(shapes::icosphere(2), 40, 5).mesh(),
      shapes::perforatedPlate(3, 2).mesh(),
      shapes::bumpySurface(2, 2, 0.5, 7).mesh(),
      shapes::torus(16, 10).mesh(),
      shapes::cube().mesh(),
      shapes::cylinder(9, 5).mesh()};
  for (int seed = 0; seed < 60; ++seed) result.push_back(shapes::randomMesh(seed));
  return result;
}

TEST(ExactPath, IsAsLongAsTheDistance) {
  int seed = 0;
  for (const TriangleMesh& mesh : meshes()) {
    SCOPED_TRACE("mesh " + std::to_string(seed));
    for (const int count : {1, 5}) {
      const int checked =
          checkExact(mesh, sitesOf(mesh, count, seed), pointsOf(mesh, 60, seed + 100));
      EXPECT_GT(checked, 0);
    }
    ++seed;
  }
}

/// Symmetric, folded, of needles, of loose triangles; sites on top of each other.
TEST(ExactPath, IsAsLongAsTheDistanceInDegenerateCases) {
  for (int seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomCase random = randomCase(seed);
    const TriangleMesh mesh = random.mesh();
    checkExact(mesh, random.sitesOn(mesh), pointsOf(mesh, 20, seed));
  }
}

TEST(ExactPath, IsAsLongAsTheDistanceOnMechanicalParts) {
  for (const auto& part : shapes::mechanicalShapes()) {
    SCOPED_TRACE(part.name);
    const TriangleMesh mesh = part.shape.mesh();
    if (mesh.faceCount() > 4000) continue;
    checkExact(mesh, sitesOf(mesh, 3, 1), pointsOf(mesh, 60, 2));
  }
}

/// Sites that are nearer to a side of their face than rounding of the lengths of edges: seen from
/// across the side, the unfolded site may appear in front of it.
TEST(ExactPath, IsAsLongAsTheDistanceToSitesBesideAnEdge) {
  const TriangleMesh mesh = shapes::scaled(shapes::cube(), {1e-3, 1, 18}).mesh();
  const std::vector<SurfacePoint> points = pointsOf(mesh, 20, 1);
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    for (const double share : {0.001, 0.3}) {
      SurfacePoint site{TriangleMesh::faceOf(h), Eigen::Vector3d::Constant(1e-12)};
      site.bary[h % 3] = 1 - share - 1e-12;
      site.bary[cornerAfter(h % 3)] = share;
      checkExact(mesh, {site}, points);
    }
}

/// Across a flat grid of needles: a line that is turned by a needle's short side keeps its
/// direction.
TEST(ExactPath, IsAsLongAsTheDistanceAcrossNeedles) {
  const TriangleMesh mesh = shapes::scaled(shapes::grid(2, 3), {1e-8, 1, 0}).mesh();
  const auto at = [](int face, double a, double b) {
    return SurfacePoint{face, {a, b, 1 - a - b}};
  };
  for (int from = 0; from < mesh.faceCount(); ++from)
    for (int to = 0; to < mesh.faceCount(); ++to)
      for (const double share : {1e-3, 0.4}) {
        const SurfacePoint p = at(from, 0.3, share), q = at(to, share, 0.3);
        EXPECT_NEAR(lengthOf(mesh, shortestPath(mesh, p, q)),
                    (mesh.position(p) - mesh.position(q)).norm(), 1e-12)
            << "faces " << from << " and " << to << ", share " << share;
      }
}

/// Across faces as thin as rounding, a line may pass a vertex on the wrong side.
TEST(ExactPath, IsAsLongAsTheDistanceWhereLinesMissVertices) {
  const auto check = [](const shapes::Shape& shape, const SurfacePoint& site,
                        const SurfacePoint& p) {
    const TriangleMesh mesh = shape.mesh();
    EXPECT_GT(mesh.repairs().mollifiedTriangles, 0);
    const auto field = fieldOf(mesh, {site}, Metric::kExact);
    const double distance = field->nearest(p).distance;
    EXPECT_NEAR(lengthOf(mesh, field->path(0, p)), distance, kTolerance * distance);
  };
  check(shapes::gradedDisk(29, 12, 0.23704349334795904),
        {683, {3.9751855593537413e-15, 0.69514553940693524, 0.30485446059306076}},
        {172, {0.87868458142357586, 0.0087586272786056574, 0.11255679129781848}});
  check(shapes::gradedDisk(22, 6, 0.21892956296433008), {13, {0, 0, 1}},
        {214, {0.12938328106953612, 0.59686678683303418, 0.2737499320974297}});
  check(shapes::scaled(shapes::bumpySurface(0, 1, 0.6, 5049), {1, 1e-6, 1e-5}),
        {8, {0.38440549676592461, 4.2119120942676014e-05, 0.61555238411313273}},
        {15, {0, 0.86515342514673765, 0.13484657485326235}});
}

/// Around a box that is 1e-8 thick, to its vertices: the last piece to a vertex may be so short
/// beside the halfedge that it crosses, and shows the way back to the site all the same.
TEST(ExactPath, FollowsAShortLastPieceBack) {
  const TriangleMesh mesh = shapes::scaled(shapes::cube(), {1e-8, 1, 1}).mesh();
  for (const SurfacePoint& site : sampleUniform(mesh, 40, 1)) {
    const auto field = fieldOf(mesh, {site}, Metric::kExact);
    const Eigen::Vector3d origin = mesh.position(mesh.tail(3 * site.face));
    const Eigen::Vector3d x = (mesh.position(mesh.tip(3 * site.face)) - origin).normalized();
    const Eigen::Vector3d apex = mesh.position(mesh.tail(3 * site.face + 2)) - origin;
    const Eigen::Vector3d y = (apex - x.dot(apex) * x).normalized();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Path path = field->path(0, pointAtVertex(mesh, v));
      EXPECT_NEAR(lengthOf(mesh, path), field->at(v).front().distance, 1e-13);
      const Eigen::Vector3d way =
          (mesh.position(path[path.size() - 2]) - mesh.position(site)).normalized();
      const Eigen::Vector2d direction = field->direction(0, v);
      EXPECT_NEAR(direction.x(), x.dot(way), 1e-10);
      EXPECT_NEAR(direction.y(), y.dot(way), 1e-10);
    }
  }
}

/// Also to sites that are not the nearest, as far as they are known.
TEST(ExactPath, LeadsToEveryKnownSite) {
  for (int seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TriangleMesh mesh = shapes::randomMesh(seed);
    const auto sites = sitesOf(mesh, 6, seed);
    const auto field = fieldOf(mesh, sites, Metric::kExact);
    for (int v = 0; v < mesh.vertexCount(); ++v)
      for (const LabelledDistance& known : field->at(v)) {
        const Path path = field->path(known.label, pointAtVertex(mesh, v));
        expectPolyline(mesh, path, pointAtVertex(mesh, v), sites[known.label]);
        EXPECT_NEAR(lengthOf(mesh, path), known.distance, kTolerance * known.distance);
      }
  }
}

TEST(ShortestPath, IsAsLongAsTheDistance) {
  int seed = 0;
  for (const TriangleMesh& mesh : meshes()) {
    SCOPED_TRACE("mesh " + std::to_string(seed));
    EXPECT_GT(checkBetween(mesh, sitesOf(mesh, 3, seed), sitesOf(mesh, 60, seed + 100)), 0);
    ++seed;
  }
}

TEST(ShortestPath, IsAsLongAsTheDistanceInDegenerateCases) {
  for (int seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomCase random = randomCase(seed);
    const TriangleMesh mesh = random.mesh();
    checkBetween(mesh, sitesOf(mesh, 2, seed), pointsOf(mesh, 20, seed));
  }
}

TEST(ShortestPath, IsBetweenPointsOfTheMesh) {
  const TriangleMesh mesh = shapes::cube().mesh();
  const SurfacePoint point = {0, {0.2, 0.3, 0.5}}, nowhere;
  EXPECT_THROW(startShortestPath(mesh, nowhere, point), Error);
  EXPECT_THROW(startShortestPath(mesh, point, nowhere), Error);
  EXPECT_EQ(shortestPath(mesh, point, point).size(), 1u);
}

TEST(ShortestPath, IsEmptyBetweenComponents) {
  const TriangleMesh mesh =
      shapes::joined(shapes::triangle(), shapes::moved(shapes::cube(), {5, 0, 0})).mesh();
  EXPECT_TRUE(shortestPath(mesh, {0, {0.2, 0.3, 0.5}}, {1, {0.2, 0.3, 0.5}}).empty());
  EXPECT_TRUE(shortestPath(mesh, {1, {1, 0, 0}}, {0, {0.2, 0.3, 0.5}}).empty());
}

/// Windows that begin just beside the apex of a flat face go on beside it, even if another window
/// has a shorter way to the apex. Found with the paths between random points of wild meshes.
TEST(ShortestPath, IsTheSameInBothDirectionsThroughFlatFaces) {
  const TriangleMesh mesh =
      shapes::Shape{{0.29999999999999999, 0.69999999999999996, 0,
                     0.89999999999999969, 0.69999999999999973, 0.90000000000000002,
                     0.33148571757586387, 0.53338371723219613, 0.014150906736873248,
                     0.89999999999999947, 0.69999999999999951, 0.90000000000000002,
                     0.90000000000000013, 0.70000000000000018, 0.90000000000000002,
                     0.59999999999999953, 0.10000000000000001, 0.90000000000000002,
                     0.60000000000000042, 0.10000000000000001, 0.90000000000000002,
                     0.19010287455857044, 0.71485055488800431, 0.90966852521472852},
                    {0, 1, 2, 3, 2, 1, 0, 4, 5, 3, 5, 4, 3, 6, 5, 3, 7, 6, 0, 7, 1, 3, 1, 7}}
          .mesh();
  const SurfacePoint a{0, {0.55739304336724038, 0.23514544684552241, 0.20746150978723721}};
  const SurfacePoint b{2, {0.018595576278197523, 0.71550005997796173, 0.26590436374384074}};
  const double there = lengthOf(mesh, shortestPath(mesh, a, b));
  EXPECT_NEAR(lengthOf(mesh, shortestPath(mesh, b, a)), there, 1e-9 * there);
}

TEST(ExactPath, TurnsAtTheInnerCornerOfAnL) {
  for (int n = 1; n < 6; ++n) {
    const TriangleMesh mesh = shapes::ell(n).mesh();
    const auto vertexAt = [&](double x, double y) {
      for (int v = 0; v < mesh.vertexCount(); ++v)
        if ((mesh.position(v) - Eigen::Vector3d(x, y, 0)).norm() < 1e-12) return v;
      return -1;
    };
    for (const auto& [from, to] : {std::pair(std::array{2.0, 1.0}, std::array{1.0, 2.0}),
                                   std::pair(std::array{2.0, 0.0}, std::array{0.0, 2.0})}) {
      const int a = vertexAt(from[0], from[1]), b = vertexAt(to[0], to[1]);
      ASSERT_TRUE(a >= 0 && b >= 0);
      const auto field = fieldOf(mesh, {pointAtVertex(mesh, b)}, Metric::kExact);
      const Path path = field->path(0, pointAtVertex(mesh, a));
      const double expected = from[1] == 1 ? 2 : 2 * std::sqrt(2.0);
      EXPECT_NEAR(lengthOf(mesh, path), expected, 1e-14);
      const int corner = vertexAt(1, 1);
      EXPECT_TRUE(std::any_of(path.begin(), path.end(), [&](const SurfacePoint& p) {
        for (int i = 0; i < 3; ++i)
          if (p.bary[i] == 1 && mesh.tail(3 * p.face + i) == corner) return true;
        return false;
      }));
    }
  }
}

/// Straight lines that pass the inner corner beyond the boundary, by so little that they are no
/// longer than the way over the corner.
TEST(ExactPath, TurnsAtAnInnerCornerThatItIsHardlyBeside) {
  const TriangleMesh mesh = shapes::ell(1).mesh();
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    for (const double share : {0.1, 0.5}) {
      SurfacePoint p{TriangleMesh::faceOf(h), Eigen::Vector3d::Constant(2.4e-7)};
      p.bary[cornerAfter(h % 3)] *= share;
      p.bary[h % 3] = 1 - 2.4e-7 * (1 + share);
      for (int v = 0; v < mesh.vertexCount(); ++v) checkExact(mesh, {pointAtVertex(mesh, v)}, {p});
    }
}

TEST(ExactPath, CrossesTheEdgesOfACube) {
  const TriangleMesh mesh = shapes::cube().mesh();
  // From the middle of one face to that of a neighbour: straight across the middle of their edge.
  const auto middles = [&](int axis, double side) {
    std::vector<SurfacePoint> points;
    for (int f = 0; f < mesh.faceCount(); ++f)
      for (int i = 0; i < 3; ++i) {
        SurfacePoint p{f, Eigen::Vector3d(0.5, 0.5, 0.5)};
        p.bary[i] = 0;
        Eigen::Vector3d middle(0.5, 0.5, 0.5);
        middle[axis] = side;
        if ((mesh.position(p) - middle).norm() < 1e-12) points.push_back(p);
      }
    return points;
  };
  const std::vector<SurfacePoint> top = middles(2, 1), beside = middles(0, 1);
  ASSERT_EQ(top.size(), 2u);  // on the diagonal of the square, named in both faces
  ASSERT_EQ(beside.size(), 2u);
  for (const SurfacePoint& site : top) {
    const auto field = fieldOf(mesh, {site}, Metric::kExact);
    for (const SurfacePoint& p : beside) {
      const Path path = field->path(0, p);
      expectPolyline(mesh, path, p, site);
      ASSERT_EQ(path.size(), 3u);
      EXPECT_NEAR((mesh.position(path[1]) - Eigen::Vector3d(1, 0.5, 1)).norm(), 0, 1e-15);
      EXPECT_NEAR(lengthOf(mesh, path), 1, 1e-15);
    }
  }
}

class PathByBoth : public ::testing::TestWithParam<Metric> {};

TEST_P(PathByBoth, IsStraightInTheSitesFace) {
  const TriangleMesh mesh = shapes::icosphere(1).mesh();
  const SurfacePoint site{3, {0.2, 0.3, 0.5}};
  const auto field = fieldOf(mesh, {site}, GetParam());
  for (const Eigen::Vector3d& bary :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(0.1, 0.2, 0.7)}) {
    const Path path = field->path(0, {3, bary});
    ASSERT_EQ(path.size(), 2u);
    EXPECT_EQ(path[0], (SurfacePoint{3, bary}));
    EXPECT_EQ(path[1], site);
  }
}

/// Whichever face names them.
TEST_P(PathByBoth, IsOnePointAtTheSite) {
  const TriangleMesh mesh = shapes::grid(3, 3).mesh();
  for (const SurfacePoint& site : {SurfacePoint{4, {0.2, 0.3, 0.5}},
                                   SurfacePoint{4, {0.25, 0.75, 0}}, SurfacePoint{4, {0, 0.5, 0.5}},
                                   SurfacePoint{4, {0.25, 0, 0.75}}, SurfacePoint{4, {1, 0, 0}}}) {
    const auto field = fieldOf(mesh, {site}, GetParam());
    const Path path = field->path(0, site);
    ASSERT_EQ(path.size(), 1u);
    EXPECT_EQ(path[0], site);
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      SurfacePoint p{TriangleMesh::faceOf(h), Eigen::Vector3d::Zero()};
      const Eigen::Vector3d place = mesh.position(site);
      const double length = mesh.length(h);
      const double share = (place - mesh.position(mesh.tail(h))).norm() / length;
      p.bary[h % 3] = 1 - share;
      p.bary[(h + 1) % 3] = share;
      if (share > 1 || (mesh.position(p) - place).norm() > 1e-12) continue;
      EXPECT_LT(lengthOf(mesh, field->path(0, p)), 1e-12);
    }
  }
}

/// Within rounding of a vertex or an edge, a point is on it: for distances and paths, at both ends.
TEST_P(PathByBoth, TakesPointsWithinRoundingOfAVertexOrEdgeForOnesOnIt) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 2, 0.3, 1).mesh();
  struct Case {
    Eigen::Vector3d given, meant;
  };
  const Case cases[] = {{{1, 1e-20, 0}, {1, 0, 0}},
                        {{1e-15, 1e-300, 1}, {0, 0, 1}},
                        {{0.5, 1e-17, 0.5}, {0.5, 0, 0.5}},
                        {{0.25, 0.75, -1e-9}, {0.25, 0.75, 0}}};
  for (const Case& c : cases) {
    const SurfacePoint given = {7, c.given}, meant = {7, c.meant}, other = {90, {0.2, 0.3, 0.5}};
    const auto one = fieldOf(mesh, {given, other}, GetParam()),
               two = fieldOf(mesh, {meant, other}, GetParam());
    for (int v = 0; v < mesh.vertexCount(); ++v)
      EXPECT_NEAR(nearestOf(one->at(v)).distance, nearestOf(two->at(v)).distance, 1e-14);
    const auto field = fieldOf(mesh, {other}, GetParam());
    EXPECT_EQ(field->nearest(given).distance, field->nearest(meant).distance);
    EXPECT_EQ(field->path(0, given), field->path(0, meant));
  }
}

TEST_P(PathByBoth, IsEmptyWhereTheSiteIsNotKnown) {
  const TriangleMesh mesh =
      shapes::joined(shapes::cube(), shapes::moved(shapes::cube(), {9, 0, 0})).mesh();
  const auto field = fieldOf(mesh, {{0, {1, 0, 0}}}, GetParam());
  EXPECT_TRUE(field->path(0, {mesh.faceCount() - 1, {0, 0, 1}}).empty());
  EXPECT_TRUE(field->path(0, {mesh.faceCount() - 1, {0.2, 0.2, 0.6}}).empty());
  EXPECT_TRUE(field->path(-1, {mesh.faceCount() - 1, {0.2, 0.2, 0.6}}).empty());
  EXPECT_TRUE(field->path(1, {0, {0.2, 0.2, 0.6}}).empty());
}

TEST_P(PathByBoth, IsStraightInThePlane) {
  const TriangleMesh mesh = shapes::grid(12, 9, 0.2, 3).mesh();
  for (const SurfacePoint& site : sitesOf(mesh, 9, 4)) {
    const auto field = fieldOf(mesh, {site}, GetParam());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Path path = field->path(0, pointAtVertex(mesh, v));
      expectPolyline(mesh, path, pointAtVertex(mesh, v), site);
      const double expected = (mesh.position(v) - mesh.position(site)).norm();
      EXPECT_NEAR(lengthOf(mesh, path), expected, 1e-7 * expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, PathByBoth, ::testing::Values(Metric::kExact, Metric::kDgpc));

TEST(ApproximatePath, IsAboutAsLongAsTheDistance) {
  int seed = 0;
  Lengths all;
  for (const TriangleMesh& mesh : meshes()) {
    SCOPED_TRACE("mesh " + std::to_string(seed));
    for (const int count : {1, 5})
      addApproximate(mesh, sitesOf(mesh, count, seed), pointsOf(mesh, 60, seed + 100), all);
    ++seed;
  }
  EXPECT_GT(all.count, 5000);
  EXPECT_LT(all.relative / all.count, 0.03);  // 0.013 as measured
}

/// Where paths bend at inner corners on long thin faces, unfolded distances contradict each other:
/// a path to a site at distance 1.9 on the comb once went to a corner 24 away and back.
TEST(ApproximatePath, MakesNoDetours) {
  for (const shapes::MechanicalShape& part : shapes::mechanicalShapes()) {
    const TriangleMesh mesh = part.shape.mesh();
    for (const int count : {3, 30, 300}) {
      const auto sites = sitesOf(mesh, count, 1);
      const auto field = fieldOf(mesh, sites, Metric::kDgpc);
      for (const SurfacePoint& p : pointsOf(mesh, 100, count)) {
        const LabelledDistance nearest = field->nearest(p);
        const Path path = field->path(nearest.label, p);
        expectPolyline(mesh, path, p, sites[nearest.label]);
        const double length = lengthOf(mesh, path);
        if (length <= 1.1 * nearest.distance) continue;
        const double shortest = lengthOf(mesh, shortestPath(mesh, p, sites[nearest.label]));
        EXPECT_LE(length, shortest * (1 + 1e-9)) << part.name << ", " << count << " sites";
      }
    }
  }
}

TEST(ApproximatePath, IsAPathInDegenerateCases) {
  for (int seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomCase random = randomCase(seed);
    const TriangleMesh mesh = random.mesh();
    Lengths lengths;
    addApproximate(mesh, random.sitesOn(mesh), pointsOf(mesh, 20, seed), lengths);
  }
}

TEST(PathLength, IsInfiniteWhereNoFaceIsShared) {
  const TriangleMesh mesh = shapes::cube().mesh();
  const std::vector<SurfacePoint> apart = {{0, {0.3, 0.3, 0.4}}, {11, {0.3, 0.3, 0.4}}};
  EXPECT_EQ(lengthOf(mesh, apart), kInfinity);
  EXPECT_EQ(lengthOf(mesh, {}), 0);
}

TEST(PathLength, TakesPointsAsAllFunctionsDo) {
  const TriangleMesh mesh = shapes::cube().mesh();
  const int h = 0, twin = mesh.twin(h);
  ASSERT_GE(twin, 0);
  // Within rounding of the edge, which both faces have.
  SurfacePoint middle{0, {0.5, 0.5, 1e-15}};
  const SurfacePoint beyond{TriangleMesh::faceOf(twin), Eigen::Vector3d::Constant(1.0 / 3)};
  EXPECT_LT(lengthOf(mesh, std::vector{middle, beyond}), 1);
  for (const SurfacePoint& absent :
       {SurfacePoint{12, {1, 0, 0}}, SurfacePoint{-1, {1, 0, 0}}, SurfacePoint{0, {0.5, 0.5, 0.5}}})
    EXPECT_THROW(lengthOf(mesh, std::vector{middle, absent}), Error);
}

}  // namespace
}  // namespace gvd
