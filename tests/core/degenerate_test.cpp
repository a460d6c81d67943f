// SPDX-License-Identifier: MIT
//
// Diagrams with regions of any shape, number and size, each on a small mesh on which one thing
// degenerates, with the combinatorics written out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "degenerate_diagrams.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

using shapes::Shape;

// --- Regions and faces ---------------------------------------------------------------------------

TEST_P(Degenerate, NarrowRegionCrossesFacesThatOwnNoneOfItsCorners) {
  // All vertices have an x that is a multiple of 0.25; the middle region is 0.365 < x < 0.375.
  const auto mesh = shapes::grid(4, 4).mesh();
  const Diagram d =
      diagram(mesh, {inPlane(mesh, 0.36, 0.6), inPlane(mesh, 0.37, 0.6), inPlane(mesh, 0.38, 0.6)});
  EXPECT_EQ(std::count(d.faceLabel.begin(), d.faceLabel.end(), 1), 0);
  EXPECT_EQ(d.loopLabel, (Labels{0, 1, 2}));
  EXPECT_EQ(d.arcs.size(), 2);
  EXPECT_EQ(neighbours(d), (std::set<std::pair<int, int>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(d.voronoiPoints.empty());
  expectAreas(mesh, d, {0.365, 0.01, 0.625});
}

TEST_P(Degenerate, BisectorRunsAlongEdgesBetweenRegionTriangles) {
  const auto mesh = shapes::grid(2, 3).mesh();
  const Diagram d = diagram(mesh, {inPlane(mesh, 0.75, 0.4), inPlane(mesh, 0.25, 0.4)});
  EXPECT_EQ(d.cells.size(), 0);
  EXPECT_TRUE(d.indifferentFaces.empty());
  ASSERT_EQ(d.segments.size(), 3u);
  for (const auto& s : d.segments) {
    EXPECT_EQ(s.labels, (std::array<int, 2>{0, 1}));
    // Site 0 is on the right side of the square, and on the left of the segments.
    EXPECT_LT(mesh.position(d.points[s.points[1]]).y(), mesh.position(d.points[s.points[0]]).y());
  }
  EXPECT_EQ(d.arcs.size(), 1);
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

TEST_P(Degenerate, RegionMayLieInsideOneFace) {
  const auto mesh = shapes::triangle().mesh();
  const Diagram d =
      diagram(mesh, {inPlane(mesh, 0.3, 0.3), inPlane(mesh, 0.4, 0.3), inPlane(mesh, 0.3, 0.4),
                     inPlane(mesh, 0.2, 0.3), inPlane(mesh, 0.3, 0.2)});
  EXPECT_EQ(meetings(d), (std::vector<Labels>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
  EXPECT_EQ(d.arcs.size(), 8);
  EXPECT_EQ(loopCount(d, 0), 1);
  EXPECT_EQ(d.loops[0].size(), 4u);
  EXPECT_NEAR(d.regionArea[0], 0.01, 1e-12);
}

TEST_P(Degenerate, SitesInOneFaceMeetAgainOnTheFaceAcross) {
  const auto mesh = shapes::octahedron().mesh();
  const Diagram d =
      diagram(mesh, {{0, {0.5, 0.25, 0.25}}, {0, {0.25, 0.5, 0.25}}, {0, {0.25, 0.25, 0.5}}});
  EXPECT_EQ(meetings(d), (std::vector<Labels>{{0, 1, 2}, {0, 2, 1}}));
  EXPECT_EQ(d.arcs.size(), 3);
  EXPECT_EQ(d.loopLabel, (Labels{0, 1, 2}));
  if (!isExact()) return;
  for (const auto& v : d.voronoiPoints)
    EXPECT_NEAR(d.points[v.point].bary.maxCoeff(), 1.0 / 3, 1e-9);
  expectAreas(mesh, d, {1.0 / 3, 1.0 / 3, 1.0 / 3});
}

TEST_P(Degenerate, SitesMayOutnumberVerticesTwoToOne) {
  // 16 vertices, 32 sites in 8 columns and 4 rows: equal rectangles that meet in fours.
  const auto mesh = shapes::grid(3, 3).mesh();
  Sites sites;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column)
      sites.push_back(inPlane(mesh, (column + 0.5) / 8, (row + 0.5) / 4));
  ASSERT_EQ(static_cast<int>(sites.size()), 2 * mesh.vertexCount());
  const Diagram d = diagram(mesh, sites);
  std::vector<Labels> expected;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 7; ++column) {
      const int low = 8 * row + column;
      expected.push_back({low, low + 1, low + 9, low + 8});
    }
  EXPECT_EQ(meetings(d), expected);
  EXPECT_EQ(d.loopLabel, ascending(32));
  EXPECT_EQ(d.arcs.size(), 4 * 7 + 3 * 8);
  expectAreas(mesh, d, std::vector<double>(32, 1.0 / 32));
}

// --- One site, and sites at one place ------------------------------------------------------------

TEST_P(Degenerate, OneSiteOwnsItsComponent) {
  struct Expected {
    const char* name;
    Shape shape;
    int boundaryLoops;
  };
  const Expected cases[] = {{"tetrahedron", shapes::tetrahedron(), 0},
                            {"cube", shapes::cube(), 0},
                            {"torus", shapes::torus(6, 4), 0},
                            {"three holes", shapes::perforatedPlate(3), 0},
                            {"triangle", shapes::triangle(), 1},
                            {"annulus", shapes::annulus(6, 1), 2},
                            {"cylinder", shapes::cylinder(5, 2), 2},
                            {"saddle", doubleTurn(), 1},
                            {"cone", shapes::vertexFan(5, kPi), 1},
                            {"Moebius strip, cut", shapes::moebiusStrip(8), 1}};
  for (const Expected& expected : cases) {
    const auto mesh = expected.shape.mesh();
    for (const SurfacePoint& site : {centroid(0), pointAtVertex(mesh, 1)}) {
      const Diagram d = diagram(mesh, {site});
      EXPECT_EQ(d.loops.size(), expected.boundaryLoops) << expected.name;
      EXPECT_EQ(d.faceLabel, Labels(mesh.faceCount(), 0)) << expected.name;
      EXPECT_TRUE(d.segments.empty() && d.indifferentFaces.empty()) << expected.name;
      expectAreas(mesh, d, {1});
    }
  }
}

TEST_P(Degenerate, CoincidentSitesLeaveAllToTheLowest) {
  const auto mesh = shapes::octahedron().mesh();
  const int h = 0, twin = mesh.twin(0);
  const auto onEdge = [](int halfedge, double share) {
    SurfacePoint p{TriangleMesh::faceOf(halfedge), Eigen::Vector3d::Zero()};
    p.bary[halfedge % 3] = 1 - share;
    p.bary[(halfedge + 1) % 3] = share;
    return p;
  };
  Sites byAllFaces;
  for (int side = 0; side < mesh.halfedgeCount(); ++side)
    if (mesh.tail(side) == 2)
      byAllFaces.push_back({TriangleMesh::faceOf(side), Eigen::Vector3d::Unit(side % 3)});
  ASSERT_EQ(byAllFaces.size(), 4u);
  for (const Sites& together :
       {Sites{centroid(3), centroid(3)}, Sites{onEdge(h, 0.25), onEdge(twin, 0.75)}, byAllFaces}) {
    const Diagram d = diagram(mesh, together);
    EXPECT_EQ(d.faceLabel, Labels(8, 0));
    EXPECT_TRUE(d.indifferentFaces.empty());
    EXPECT_EQ(d.loops.size(), 0);
    EXPECT_TRUE(d.segments.empty());
  }
}

/// As when places in metres are looked for on a model in millimetres. When each of k such sites
/// spread, they took k² times as long.
TEST_P(Degenerate, TakesThousandsOfCoincidentSites) {
  const auto mesh = shapes::icosphere(4).mesh();
  Sites sites(3000, centroid(40));
  sites.push_back(centroid(7));
  const Diagram d = diagram(mesh, sites);
  EXPECT_GT(d.regionArea[0], 0);
  EXPECT_GT(d.regionArea[3000], 0);
  EXPECT_NEAR(d.regionArea[0] + d.regionArea[3000], mesh.area(), 1e-9);
}

// --- Regions of any topology ---------------------------------------------------------------------

/// A square of side 4 with a narrow spike of height 6 in the middle; vertex 8 is its tip.
Shape spike() {
  Shape shape;
  for (const double size : {2.0, 0.25})
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      shape.addVertex({size * x, size * y, 0});
  const int tip = shape.addVertex({0, 0, 6});
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    shape.addQuad(i, j, 4 + j, 4 + i);
    shape.addTriangle(4 + i, 4 + j, tip);
  }
  return shape;
}

TEST_P(Degenerate, RegionMayHaveAHole) {
  const auto mesh = spike().mesh();
  const Diagram d = diagram(mesh, {pointAtVertex(mesh, 0), pointAtVertex(mesh, 8)});
  EXPECT_EQ(d.loopLabel, (Labels{0, 0, 1}));
  ASSERT_EQ(d.arcs.size(), 1);
  EXPECT_TRUE(isClosed(d, 0));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

TEST_P(Degenerate, RegionsOfATubeAreRings) {
  const auto mesh = shapes::cylinder(5, 10, 0.2, 10).mesh();
  const Diagram d =
      diagram(mesh, {pointAtVertex(mesh, 5), pointAtVertex(mesh, 27), pointAtVertex(mesh, 48)});
  EXPECT_EQ(d.loopLabel, (Labels{0, 0, 1, 1, 2, 2}));
  ASSERT_EQ(d.arcs.size(), 2);
  EXPECT_TRUE(isClosed(d, 0) && isClosed(d, 1));
  EXPECT_EQ(neighbours(d), (std::set<std::pair<int, int>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

TEST_P(Degenerate, TwoSitesDivideATorusInTwoRings) {
  const auto mesh = shapes::torus(12, 5, 1, 0.25).mesh();
  const Diagram d = diagram(mesh, {pointAtVertex(mesh, 0), pointAtVertex(mesh, 6)});
  EXPECT_EQ(d.loopLabel, (Labels{0, 0, 1, 1}));
  ASSERT_EQ(d.arcs.size(), 2);
  EXPECT_TRUE(isClosed(d, 0) && isClosed(d, 1));
  EXPECT_TRUE(d.voronoiPoints.empty());
  if (isExact()) expectAreas(mesh, d, {0.5, 0.5});
}

TEST_P(Degenerate, RegionsMayMeetAlongSeveralArcs) {
  const auto mesh = shapes::annulus(12, 1).mesh();
  const Diagram d = diagram(mesh, {pointAtVertex(mesh, 0), pointAtVertex(mesh, 6)});
  ASSERT_EQ(d.arcs.size(), 2);
  EXPECT_FALSE(isClosed(d, 0) || isClosed(d, 1));
  EXPECT_EQ(neighbours(d), (std::set<std::pair<int, int>>{{0, 1}}));
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

TEST_P(Degenerate, RegionMayTouchItself) {
  // A square tube of circumference 4, unrolled: site 0 at (0, 4), its region comes around to (2, 4)
  // from both sides; sites 1 and 2, at (2, 6) and (2, 2), are as far from there.
  const auto mesh = shapes::cylinder(4, 8, std::sqrt(0.5), 8).mesh();
  const auto at = [&](int x, int y) { return pointAtVertex(mesh, 4 * y + x); };
  const Diagram d = diagram(mesh, {at(0, 4), at(2, 6), at(2, 2)});
  ASSERT_EQ(meetings(d), (std::vector<Labels>{{0, 1, 0, 2}}));
  const Eigen::Vector3d meeting = mesh.position(d.points[d.voronoiPoints[0].point]);
  EXPECT_LE((meeting - mesh.position(4 * 4 + 2)).norm(), 1e-9);
  EXPECT_EQ(neighbours(d), (std::set<std::pair<int, int>>{{0, 1}, {0, 2}}));
}

// --- Places and regions too small for doubles ----------------------------------------------------

/// Coordinates of one place in a face, the second moved to the first step by step.
Sites inRow(int face, const Eigen::Vector3d& bary, double step, int count) {
  Sites sites;
  for (int i = 0; i < count; ++i)
    sites.push_back({face, bary + i * step * Eigen::Vector3d(1, -1, 0)});
  return sites;
}

TEST_P(Degenerate, SitesMayBeAsNearAsDoublesAllow) {
  // The bisectors' places are rounded by more than they are apart, in any order.
  for (const Shape& shape : {shapes::triangle(), shapes::annulus(3, 2), shapes::icosphere(1)}) {
    const auto mesh = shape.mesh();
    for (const double step : {1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-13, 1e-15})
      for (const int face : {0, mesh.faceCount() - 1})
        diagram(mesh, inRow(face, {0.376, 0.139, 0.485}, step, 5));
  }
}

TEST_P(Degenerate, SliverThatNeighboursDoNotKnowIsCompleted) {
  // The middle one of three regions ends in the second triangle before it reaches its third corner,
  // where no distance of it is known.
  const Shape shape{{0.30901699437494723, -0.95105651629515364, 0, 1, 0, 0, 0.5, 0, 0,
                     0.15450849718747361, -0.47552825814757682, 0},
                    {0, 1, 2, 0, 2, 3}};
  diagram(shape.mesh(), {{0, {0.3755540988364594, 0.13878240259572872, 0.48566349856781188}},
                         {0, {0.37555409827659963, 0.13878240315558849, 0.48566349856781188}},
                         {0, {0.37555409787694871, 0.13878240355523941, 0.48566349856781188}}});
}

TEST_P(Degenerate, RegionWithoutWidthMeetsNoOthers) {
  // Sites 0 and 1 are 1e-13 apart. They tie along a part of the mesh boundary, up to where it is
  // site 2's; beside it, site 1 is nearer. Rounded, the place where the three meet would be a
  // vertex.
  const Shape shape{{1,
                     0,
                     0,
                     0.50000000000000011,
                     0.8660254037844386,
                     0,
                     0.37500000000000011,
                     0.649519052838329,
                     0,
                     0.75,
                     0,
                     0,
                     0.25000000000000006,
                     0.4330127018922193,
                     0,
                     0.5,
                     0,
                     0,
                     -0.37500000000000033,
                     -0.64951905283832878,
                     0,
                     0.37500000000000011,
                     -0.649519052838329,
                     0,
                     0.25000000000000006,
                     -0.4330127018922193,
                     0},
                    {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5, 6, 7, 8, 7, 3, 5, 7, 5, 8}};
  const auto mesh = shape.mesh();
  Sites sites = {{4, {0.0047256121233337067, 0.94892912812720809, 0.046345259749458245}},
                 {4, {0.0047256121232086587, 0.94892912812733314, 0.046345259749458245}},
                 {0, {0.26968914621540807, 0.45277087137517524, 0.27753998240941669}}};
  for (SurfacePoint& site : sites) site = mesh.fromInput(site);
  const Diagram d = diagram(mesh, sites);
  EXPECT_EQ(d.regionArea[0], 0);
  EXPECT_EQ(d.voronoiPoints.size(), 0u);
}

TEST_P(Degenerate, ComponentsTinyAgainstTheirDistanceAreDivided) {
  const Shape shape{{0, 0, 0, 1e-15, 0, 0, 0, 1e-15, 0, 1, 0, 0, 1, 1e-15, 0, 1, 0, 1e-15},
                    {0, 1, 2, 3, 4, 5}};
  const auto mesh = shape.mesh();
  const Diagram d = diagram(mesh, {{0, {0.6, 0.2, 0.2}}, {0, {0.2, 0.6, 0.2}}});
  EXPECT_GT(d.regionArea[0], 0.2 * mesh.faceArea(0));
  EXPECT_GT(d.regionArea[1], 0.2 * mesh.faceArea(0));
}

TEST_P(Degenerate, NearestSiteIsKnownAtTheCornersAround) {
  // Sites 1 and 2 are 1e-13 apart: they tie almost everywhere, but at vertex 2, where site 2 is
  // nearer by just more than that. Vertex 4 is told of no more than site 2.
  const auto mesh =
      Shape{{3143.5931657749657, 2848.1954249291321, 3989.4103741438503, 5604.2056568982543,
             2765.6879183665528, 4206.6248473271662, 5220.1450349309598, 2906.4694481133361,
             4384.0239769186937, 4814.5897380122151, 3527.8169141236863, 6233.7382628299019,
             5093.7962951532645, 3918.9323372937865, 6578.3346477749083, 6632.6323403390525,
             2957.2289425417507, 5416.6668010861067, 6401.8100365571499, 3391.4374112406394,
             5878.7806808697169, 6126.1986420149451, 3788.7680687097391, 7265.1174082035823,
             5876.6368653654436, 4180.7484927744745, 7797.9444439755543},
            {0, 1, 2, 3, 4, 2, 3, 2, 1, 5, 6, 7, 5, 7, 3, 5, 3, 1, 2, 4, 6, 7, 6, 8, 4, 8, 6}}
          .mesh();
  Sites sites = {{3, {0.74506801130388389, 0.12599745520001612, 0.12893453349609996}},
                 {0, {0.20014365004055734, 0.081806872680733944, 0.71804947727870871}},
                 {0, {0.20014365004047452, 0.081806872680816767, 0.71804947727870871}},
                 {3, {0.34800058101319753, 0.44232603806748116, 0.20967338091932131}},
                 {8, {0.50885405608547651, 0.34452899540614762, 0.14661694850837592}}};
  for (SurfacePoint& site : sites) site = mesh.fromInput(site);
  const auto field = checks::trace(mesh, sites, GetParam()).field;
  for (int f = 0; f < mesh.faceCount(); ++f)
    for (const double x : {0.1, 0.3, 0.5})
      for (const double y : {0.1, 0.25, 0.4}) {
        const SurfacePoint p{f, {x, y, 1 - x - y}};
        const LabelledDistance nearest = field->nearest(p);
        const LabelledPoint labelled = {nearest.label, p};
        EXPECT_NEAR(field->distancesAt({labelled})[0], nearest.distance, 1e-9) << p.bary;
      }
}

TEST_P(Degenerate, RegionOfNoWidthAlongAnEdgeJoinsNothing) {
  // The sites tie at the vertices 0 and 1. Ties go to site 0, and with them, but for its width, the
  // edge between them, which two parts of region 1 have on their sides.
  const Shape shape{{0, 1, 0, 0, 0, -1, -1, 1, -1, 1, 0, 0, -1, 0, 0},
                    {0, 1, 2, 3, 1, 0, 0, 2, 4, 1, 4, 2}};
  const auto mesh = shape.mesh();
  const Diagram d = diagram(mesh, {pointAtVertex(mesh, 4), pointAtVertex(mesh, 2)});
  if (!isExact()) return;
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  EXPECT_EQ(d.arcs.size(), 1);
  EXPECT_EQ(d.faceLabel[0], 1);
  EXPECT_EQ(d.faceLabel[1], 1);
}

// --- Components and boundaries -------------------------------------------------------------------

TEST_P(Degenerate, ComponentsHaveDiagramsOfTheirOwn) {
  const auto mesh = shapes::joined(shapes::joined(shapes::octahedron(),
                                                  shapes::moved(shapes::grid(2, 2), {3, 0, 0})),
                                   shapes::moved(shapes::triangle(), {6, 0, 0}))
                        .mesh();
  // The octahedron is divided in two, the square is one region, the triangle has no site.
  const Diagram d = diagram(mesh, {centroid(0), centroid(6), centroid(8)});
  EXPECT_EQ(neighbours(d), (std::set<std::pair<int, int>>{{0, 1}}));
  EXPECT_EQ(d.loopLabel, (Labels{0, 1, 2}));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (mesh.component(f) == 1) {
      EXPECT_EQ(d.faceLabel[f], 2);
    } else if (mesh.component(f) == 2) {
      EXPECT_EQ(d.faceLabel[f], Diagram::kUnreachable);
    }
  }
  EXPECT_NEAR(d.regionArea[2], 1, 1e-12);
}

TEST_P(Degenerate, LoopsPassEveryBoundaryVertex) {
  const auto mesh = shapes::grid(4, 4).mesh();
  const Diagram d = diagram(mesh, {inPlane(mesh, 0.3, 0.5), inPlane(mesh, 0.5, 0.5)});
  std::set<int> passed;
  for (int l = 0; l < d.loops.size(); ++l)
    for (const int p : d.loops[l]) {
      Eigen::Index corner;
      if (d.points[p].bary.maxCoeff(&corner) == 1)
        passed.insert(mesh.tail(3 * d.points[p].face + static_cast<int>(corner)));
    }
  for (int v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_EQ(passed.contains(v), mesh.onBoundary(v)) << "vertex " << v;
}

TEST_P(Degenerate, MoebiusStripIsDividedWhereItWasNotCut) {
  const auto mesh = shapes::moebiusStrip(12).mesh();
  ASSERT_EQ(mesh.repairs().orientationCuts, 1);
  ASSERT_EQ(mesh.topology().boundaryLoops, 1);
  const Diagram d = diagram(mesh, {centroid(4), centroid(16)});
  EXPECT_EQ(d.loopLabel, (Labels{0, 1}));
  ASSERT_EQ(d.arcs.size(), 1);
  EXPECT_FALSE(isClosed(d, 0));
  EXPECT_TRUE(d.voronoiPoints.empty());
}

/// Of DGPC distances, those within faces do not tie.
TEST(DegenerateInDetail, AllThatMeetAtACornerOfOneElementMeetInOnePoint) {
  // Six sites around the middle of an edge of an icosahedron, whose regions meet there and in the
  // middle of the opposite edge: there, four of them within one part of a face.
  const auto mesh = shapes::subdivided(shapes::icosphere(0)).mesh();
  for (int middle = 0; middle < mesh.vertexCount(); ++middle) {
    if (mesh.fan(middle).size() != 6) continue;
    Sites sites;
    for (const int h : mesh.fan(middle)) {
      Eigen::Vector3d bary = Eigen::Vector3d::Constant(0.25);
      bary[h % 3] = 0.5;
      sites.push_back({TriangleMesh::faceOf(h), bary});
    }
    const Diagram d = checks::trace(mesh, sites, Metric::kExact, 1).diagram;
    EXPECT_EQ(meetings(d), (std::vector<Labels>{{0, 1, 2, 3, 4, 5}, {0, 5, 4, 3, 2, 1}})) << middle;
  }
}

TEST(DegenerateInDetail, RegionOfNoWidthAlongTheBoundaryIsNoLoop) {
  // The sites tie at a corner of a hole, and along the side of the hole that begins there. Ties go
  // to site 0, so it owns that side, but nothing beside it: there, its region has no width.
  Shape shape = shapes::grid(3, 3);
  const auto hole = shape.triangles.begin() + 24;  // the square in the middle
  shape.triangles.erase(hole, hole + 6);
  const auto mesh = shape.mesh();
  const Sites sites = {pointAtVertex(mesh, 6), pointAtVertex(mesh, 1)};
  for (const int detail : {0, 1, 2}) {
    const Diagram d = checks::trace(mesh, sites, Metric::kExact, detail).diagram;
    EXPECT_EQ(d.loopLabel, (Labels{0, 1})) << "detail " << detail;
  }
}

TEST_P(Degenerate, SidesOfACutAreSplitOnTheirOwn) {
  // A tetrahedron with a triangle more on its edge from 0 to 1, which is therefore cut. The sites
  // lie on both sides of the cut, alike, so they share the tetrahedron evenly.
  const Shape shape{{-1, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 1, 0, 0, -1},
                    {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 0, 1, 4}};
  const auto mesh = shape.mesh();
  ASSERT_EQ(mesh.repairs().nonManifoldEdges, 1);
  const Sites sites{{0, {0.45, 0.1, 0.45}}, {1, {0.45, 0.45, 0.1}}};
  const auto traced = checks::trace(mesh, sites, GetParam(), 1);
  EXPECT_TRUE(isConsistent(mesh, traced.diagram, 1));
  EXPECT_NEAR(traced.diagram.regionArea[0], traced.diagram.regionArea[1], 1e-12);
}

}  // namespace
}  // namespace gvd
