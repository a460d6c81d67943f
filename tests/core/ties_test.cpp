// SPDX-License-Identifier: MIT
//
// Diagrams of sites that tie: behind saddles, on circles and on symmetric solids, with the
// combinatorics written out.

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "degenerate_diagrams.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

using shapes::Shape;

// --- Saddles and cones ---------------------------------------------------------------------------

TEST_P(Degenerate, SaddleHidesSitesFromFacesBehindIt) {
  // Sites at 30° and 90°. Between 270° and 570° all shortest paths pass the saddle: a tie in faces
  // 5 to 8, which go to the lower label. The bisector runs along the edges at 60° and 300°.
  const auto mesh = doubleTurn().mesh();
  const Diagram d = diagram(mesh, {centroid(0), centroid(1)});
  EXPECT_EQ(d.faceLabel, (Labels{0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(d.indifferentFaces, (Labels{5, 6, 7, 8}));
  EXPECT_EQ(d.cells.size(), 0);
  EXPECT_EQ(d.segments.size(), 2u);
  ASSERT_EQ(d.arcs.size(), 1);
  EXPECT_FALSE(isClosed(d, 0));
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

/// A room, a passage that leaves it at (2, 1), and two more turns of the passage, in the plane.
Shape roomWithPassage() {
  Shape shape;
  for (int y = 0; y <= 4; ++y)
    for (int x = 0; x <= 6; ++x) shape.addVertex(Eigen::Vector3d(x, y, 0));
  const auto addSquare = [&](int x, int y) {
    const int v = 7 * y + x;
    shape.addQuad(v, v + 1, v + 8, v + 7);
  };
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}})
    addSquare(x, y);
  for (const auto& [x, y] : {std::pair(3, 2), {3, 3}, {4, 3}, {5, 3}}) addSquare(x, y);
  return shapes::subdivided(shape);
}

TEST_P(Degenerate, TiesAreCarriedFromCornerToCorner) {
  // The sites are as far from (2, 1), and see less of the passage than what is above a slope of
  // 50°.
  const auto mesh = roomWithPassage().mesh();
  Sites sites;
  for (const double angle : {50.0, 60.0, 71.0}) {
    const double radians = angle * kPi / 180;
    sites.push_back(inPlane(mesh, 2 - 0.7 * std::cos(radians), 1 - 0.7 * std::sin(radians)));
  }
  Labels expected;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    bool isBehind = true;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d p = mesh.position(mesh.tail(3 * f + i));
      const double slope = std::tan(50 * kPi / 180);
      isBehind &= p.x() >= 2 && p.y() >= 1 && p.y() - 1 <= slope * (p.x() - 2);
    }
    const Eigen::Vector3d middle = mesh.position(centroid(f));
    if (isBehind || (middle.x() > 3 && middle.y() > 2)) expected.push_back(f);
  }
  ASSERT_GT(expected.size(), 40u);
  const Diagram d = diagram(mesh, sites);
  EXPECT_EQ(d.indifferentFaces, expected);
  EXPECT_EQ(diagram(mesh, {sites[2], sites[0], sites[1]}).indifferentFaces, expected);
  for (const int f : expected) EXPECT_EQ(d.faceLabel[f], 0);
  // Another site in the place of one of them takes no part.
  EXPECT_TRUE(diagram(mesh, {sites[1], sites[1]}).indifferentFaces.empty());
}

TEST_P(Degenerate, SaddleIsVoronoiPointOfSitesAllAroundIt) {
  for (const int stride : {1, 2, 3, 4}) {
    const auto mesh = doubleTurn().mesh();
    Sites sites;
    for (int f = 0; f < mesh.faceCount(); f += stride) sites.push_back(centroid(f));
    const int n = static_cast<int>(sites.size());
    const Diagram d = diagram(mesh, sites);
    EXPECT_EQ(meetings(d), std::vector<Labels>{ascending(n)}) << n << " sites";
    EXPECT_EQ(d.arcs.size(), n);
    expectAreas(mesh, d, std::vector<double>(n, 1.0 / n));
  }
}

TEST_P(Degenerate, SaddleBetweenTwoOppositeSitesIsPassedByTheirBisector) {
  const auto mesh = doubleTurn().mesh();
  const Diagram d = diagram(mesh, {centroid(0), centroid(6)});
  EXPECT_TRUE(d.voronoiPoints.empty());
  EXPECT_EQ(d.arcs.size(), 1);
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  if (isExact()) expectAreas(mesh, d, {0.5, 0.5});
}

TEST_P(Degenerate, BisectorPassesAConesApexAlongEdges) {
  // Six corners of 30°; sites at 15° and 105°, the bisector at 60° and 150°.
  const auto mesh = shapes::vertexFan(6, kPi).mesh();
  const Diagram d = diagram(mesh, {centroid(0), centroid(3)});
  EXPECT_EQ(d.faceLabel, (Labels{0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(d.cells.size(), 0);
  EXPECT_EQ(d.segments.size(), 2u);
  EXPECT_EQ(d.arcs.size(), 1);
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
}

TEST_P(Degenerate, ConesApexIsVoronoiPointOfSitesAllAroundIt) {
  for (const double angle : {0.5 * kPi, kPi, 1.9 * kPi})
    for (const int n : {3, 4, 7, 24}) {
      const auto mesh = shapes::vertexFan(n, angle).mesh();
      Sites sites;
      for (int f = 0; f < n; ++f) sites.push_back(centroid(f));
      const Diagram d = diagram(mesh, sites);
      EXPECT_EQ(meetings(d), std::vector<Labels>{ascending(n)}) << n << " sites, " << angle;
      EXPECT_EQ(d.faceLabel, ascending(n));
      EXPECT_EQ(d.cells.size(), 0);
    }
}

// --- Cocircular sites ----------------------------------------------------------------------------

void expectOneVoronoiPoint(const TriangleMesh& mesh, const Diagram& d, const Eigen::Vector3d& place,
                           double maxBary) {
  const int n = d.siteCount;
  ASSERT_EQ(meetings(d), std::vector<Labels>{ascending(n)}) << n << " sites";
  const SurfacePoint& p = d.points[d.voronoiPoints[0].point];
  EXPECT_LE((mesh.position(p) - place).norm(), 1e-9);
  EXPECT_NEAR(p.bary.maxCoeff(), maxBary, 1e-9);
  EXPECT_EQ(d.arcs.size(), n);
  EXPECT_EQ(neighbours(d).size(), static_cast<size_t>(n));
  EXPECT_EQ(d.loopLabel, ascending(n));
}

Sites onCircle(const TriangleMesh& mesh, double x, double y, double radius, int n) {
  Sites sites;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + 0.3) / n;
    sites.push_back(inPlane(mesh, x + radius * std::cos(angle), y + radius * std::sin(angle)));
  }
  return sites;
}

TEST_P(Degenerate, CocircularSitesMeetOnceInAFace) {
  const auto mesh = shapes::triangle().mesh();
  for (int n = 4; n <= 24; ++n)
    expectOneVoronoiPoint(mesh, diagram(mesh, onCircle(mesh, 0.3, 0.3, 0.2, n)), {0.3, 0.3, 0},
                          0.4);
}

TEST_P(Degenerate, CocircularSitesMeetOnceOnAnEdge) {
  const auto mesh = shapes::grid(1, 1).mesh();
  for (int n = 4; n <= 24; ++n)
    expectOneVoronoiPoint(mesh, diagram(mesh, onCircle(mesh, 0.5, 0.5, 0.3, n)), {0.5, 0.5, 0},
                          0.5);
}

TEST_P(Degenerate, CocircularSitesMeetOnceOnAVertex) {
  const auto mesh = shapes::grid(2, 2).mesh();
  for (int n = 4; n <= 24; ++n)
    expectOneVoronoiPoint(mesh, diagram(mesh, onCircle(mesh, 0.5, 0.5, 0.3, n)), {0.5, 0.5, 0}, 1);
}

// --- Symmetric solids ----------------------------------------------------------------------------

Sites atAllVertices(const TriangleMesh& mesh) {
  Sites sites;
  for (int v = 0; v < mesh.vertexCount(); ++v) sites.push_back(pointAtVertex(mesh, v));
  return sites;
}

Sites atAllCentroids(const TriangleMesh& mesh) {
  Sites sites;
  for (int f = 0; f < mesh.faceCount(); ++f) sites.push_back(centroid(f));
  return sites;
}

TEST_P(Degenerate, CornersOfACubeMeetInTheMiddleOfItsSquares) {
  const auto mesh = shapes::cube().mesh();
  const Diagram d = diagram(mesh, atAllVertices(mesh));
  ASSERT_EQ(d.voronoiPoints.size(), 6u);
  for (const auto& v : d.voronoiPoints) {
    EXPECT_EQ(v.labels.size(), 4u);
    EXPECT_NEAR(d.points[v.point].bary.maxCoeff(), 0.5, 1e-12) << "the middle of a diagonal";
  }
  EXPECT_EQ(d.arcs.size(), 12);
  EXPECT_EQ(neighbours(d).size(), 12u);
  EXPECT_EQ(d.loopLabel, ascending(8));
  expectAreas(mesh, d, std::vector<double>(8, 1.0 / 8));
}

TEST_P(Degenerate, VoronoiPointOnAnEdgeIsExactlyOnIt) {
  for (const Shape& shape : {shapes::cube(), shapes::subdivided(shapes::cube())}) {
    const auto mesh = shape.mesh();
    for (const int detail : {0, 1}) {
      const Diagram d = checks::trace(mesh, atAllVertices(mesh), GetParam(), detail).diagram;
      EXPECT_TRUE(isConsistent(mesh, d, detail)) << "named in faces of their segments";
      ASSERT_FALSE(d.voronoiPoints.empty());
      for (const auto& v : d.voronoiPoints)
        EXPECT_EQ(d.points[v.point].bary.minCoeff(), 0) << d.points[v.point].bary.transpose();
    }
  }
}

TEST_P(Degenerate, VerticesOfASolidMeetInTheMiddleOfItsFaces) {
  for (const Shape& shape : {shapes::tetrahedron(), shapes::octahedron(), shapes::icosphere(0)}) {
    const auto mesh = shape.mesh();
    const int n = mesh.vertexCount();
    const Diagram d = diagram(mesh, atAllVertices(mesh));
    ASSERT_EQ(static_cast<int>(d.voronoiPoints.size()), mesh.faceCount());
    for (const auto& v : d.voronoiPoints) {
      EXPECT_EQ(v.labels.size(), 3u);
      EXPECT_NEAR(d.points[v.point].bary.maxCoeff(), 1.0 / 3, 1e-9);
    }
    EXPECT_EQ(d.arcs.size(), mesh.topology().edges);
    EXPECT_EQ(d.loopLabel, ascending(n));
    expectAreas(mesh, d, std::vector<double>(n, 1.0 / n));
  }
}

TEST_P(Degenerate, FacesOfASolidAreTheRegionsOfTheirMiddles) {
  for (const Shape& shape : {shapes::tetrahedron(), shapes::octahedron(), shapes::icosphere(0)}) {
    const auto mesh = shape.mesh();
    const int n = mesh.faceCount();
    const Diagram d = diagram(mesh, atAllCentroids(mesh));
    EXPECT_EQ(d.faceLabel, ascending(n));
    EXPECT_EQ(d.cells.size(), 0);
    EXPECT_EQ(static_cast<int>(d.voronoiPoints.size()), mesh.vertexCount());
    const size_t degree = 3 * n / mesh.vertexCount();
    for (const auto& v : d.voronoiPoints) EXPECT_EQ(v.labels.size(), degree);
    EXPECT_EQ(d.arcs.size(), mesh.topology().edges);
    EXPECT_EQ(static_cast<int>(d.segments.size()), mesh.topology().edges);
    EXPECT_EQ(d.loopLabel, ascending(n));
  }
}

}  // namespace
}  // namespace gvd
