// SPDX-License-Identifier: MIT
#include "gvd/diagram.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

#include "base/random.h"
#include "diagram/complex/near_labels.h"
#include "diagram_checks.h"
#include "equality.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mechanical_shapes.h"
#include "mesh/incidence.h"
#include "mesh/slits.h"
#include "random_case.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::areSame;
using checks::identity;
using checks::isConsistent;
using checks::trace;
using checks::traceByBruteForce;
using shapes::centroid;
using shapes::randomMesh;
using shapes::randomSiteCount;

class RandomMeshes : public ::testing::TestWithParam<int> {};

TEST_P(RandomMeshes, GiveConsistentDiagrams) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  for (const Metric metric : {Metric::kDgpc, Metric::kExact})
    EXPECT_TRUE(isConsistent(mesh, trace(mesh, sites, metric).diagram));
}

/// How many sites to try where brute force is to be compared: only small meshes get very many.
int siteCountForBruteForce(const TriangleMesh& mesh, int seed) {
  const int most = mesh.vertexCount() <= 80 ? 2 * mesh.vertexCount() : 40;
  return std::min(most, randomSiteCount(mesh, seed));
}

TEST_P(RandomMeshes, KnowTheNearestSitesOfBruteForce) {
  const auto mesh = randomMesh(GetParam());
  const int count = siteCountForBruteForce(mesh, GetParam());
  const auto sites = sampleUniform(mesh, count, GetParam());
  const auto field = trace(mesh, sites, Metric::kExact).field;
  const auto expected = traceByBruteForce(mesh, sites).field;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const LabelledDistance a = nearestOf(field->at(v)), b = nearestOf(expected->at(v));
    EXPECT_EQ(a.label, b.label) << "vertex " << v;
    if (b.label < 0) continue;
    EXPECT_NEAR(a.distance, b.distance, 1e-12 * b.distance) << "vertex " << v;
  }
}

TEST_P(RandomMeshes, KnowTheExactDistancesOfBruteForce) {
  const auto mesh = randomMesh(GetParam());
  const int count = std::min(20, randomSiteCount(mesh, GetParam()));
  const auto sites = sampleUniform(mesh, count, GetParam());
  const auto field = trace(mesh, sites, Metric::kExact).field;
  const auto expected = traceByBruteForce(mesh, sites).field;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    std::map<int, double> here;
    for (const LabelledDistance& d : expected->at(v)) here[d.label] = d.distance;
    for (const LabelledDistance& d : field->at(v))
      EXPECT_NEAR(d.distance, here.at(d.label), 1e-9 * mesh.boundingDiagonal()) << "vertex " << v;
  }
}

/// Along an edge, the labels that are least somewhere if squared distances are linear; to be the
/// only ones that a diagram shows there, they have to be known in the faces on both sides.
TEST_P(RandomMeshes, KnowInAFaceWhatOwnsPartOfItsEdges) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
    const auto field = trace(mesh, sites, metric).field;
    const auto find = [&](int v, int label) {
      const auto known = field->at(v);
      return std::find_if(known.begin(), known.end(),
                          [&](const LabelledDistance& d) { return d.label == label; });
    };
    const auto isKnown = [&](int v, int label) { return find(v, label) != field->at(v).end(); };
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      const int tail = mesh.tail(h), tip = mesh.tip(h);
      const int apex = mesh.tail(TriangleMesh::previous(h));
      for (const LabelledDistance& d : field->at(tail)) {
        if (!isKnown(tip, d.label)) {
          EXPECT_NE(d.label, nearestOf(field->at(tail)).label) << "halfedge " << h;
          continue;
        }
        // What the others leave of the edge.
        const double atTip = find(tip, d.label)->distance;
        double from = 0, to = 1;
        for (const LabelledDistance& other : field->at(tail)) {
          if (other.label == d.label || !isKnown(tip, other.label)) continue;
          const double otherAtTip = find(tip, other.label)->distance;
          const bool isLower = other.label < d.label;
          const double lagAtTail = d.distance * d.distance - other.distance * other.distance;
          const double lagAtTip = atTip * atTip - otherAtTip * otherAtTip;
          const bool losesTail = lagAtTail > 0 || (lagAtTail == 0 && isLower);
          const bool losesTip = lagAtTip > 0 || (lagAtTip == 0 && isLower);
          if (losesTail && losesTip) from = 2;
          if (losesTail == losesTip) continue;
          double& end = losesTail ? from : to;
          const double tie = lagAtTail / (lagAtTail - lagAtTip);
          end = losesTail ? std::max(from, tie) : std::min(to, tie);
        }
        if (from > to || isSideOfSlit(mesh, h)) continue;
        EXPECT_TRUE(isKnown(apex, d.label))
            << "label " << d.label << " owns " << from << " to " << to << " of halfedge " << h;
      }
    }
  }
}

TEST_P(RandomMeshes, KnowNothingOfTheOrderOfSites) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  std::vector<int> order = identity(static_cast<int>(sites.size()));
  shapes::Random random(GetParam());
  for (size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
  std::vector<SurfacePoint> permuted(sites.size());
  for (size_t i = 0; i < sites.size(); ++i) permuted[order[i]] = sites[i];
  const Diagram a = trace(mesh, sites).diagram, b = trace(mesh, permuted).diagram;
  EXPECT_TRUE(areSame(mesh, a, b, order, 1e-12));
}

TEST_P(RandomMeshes, MayBeTurnedMovedAndScaled) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  const Diagram expected = trace(mesh, sites).diagram;
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(1, 2, 3).normalized());
    std::vector<double> positions;
    std::vector<int> triangles;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Eigen::Vector3d p = scale * (turn * mesh.position(v) + Eigen::Vector3d(0.3, -0.2, 0.5));
      positions.insert(positions.end(), {p[0], p[1], p[2]});
    }
    for (int h = 0; h < mesh.halfedgeCount(); ++h) triangles.push_back(mesh.tail(h));
    const TriangleMesh moved(positions, triangles);
    ASSERT_EQ(moved.faceCount(), mesh.faceCount());
    const Diagram d = trace(moved, sites).diagram;
    EXPECT_TRUE(isConsistent(moved, d)) << "scale " << scale;
    for (int l = 0; l < expected.siteCount; ++l)
      EXPECT_NEAR(d.regionArea[l] / moved.area(), expected.regionArea[l] / mesh.area(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMeshes, ::testing::Range(0, 208));

/// In a convex part of the plane interpolation is exact. On curved meshes, and where paths turn
/// around corners, it may show labels that are far behind in truth, and brute force knows more of
/// these.
class FlatMeshes : public ::testing::TestWithParam<int> {
 protected:
  /// The diagram of brute force, and the one to test.
  struct Both {
    TriangleMesh mesh;
    Diagram expected, found;
  };
  static Both trace(const shapes::Shape& shape, Metric metric) {
    Both both{shape.mesh(), {}, {}};
    const int count = siteCountForBruteForce(both.mesh, GetParam());
    const auto sites = sampleUniform(both.mesh, count, GetParam());
    both.expected = checks::traceByBruteForce(both.mesh, sites, metric).diagram;
    both.found = checks::trace(both.mesh, sites, metric).diagram;
    return both;
  }
  static int columns() { return 2 + GetParam() % 8; }
  static int rows() { return 1 + GetParam() / 8 % 8; }
};

TEST_P(FlatMeshes, GiveTheExactDiagramOfBruteForce) {
  const int seed = GetParam(), points = 10 * columns();
  for (const shapes::Shape& shape : {shapes::grid(columns(), rows(), 0.24, seed),
                                     shapes::randomTriangulation(points, 5 * points, seed)}) {
    const Both both = trace(shape, Metric::kExact);
    EXPECT_TRUE(
        areSame(both.mesh, both.expected, both.found, identity(both.found.siteCount), 1e-11));
  }
}

/// DGPC goes to a required vertex in one step from those around it.
TEST_P(FlatMeshes, GiveNearlyTheApproximateDiagramOfBruteForce) {
  for (const double jitter : {0.0, 0.1}) {
    const auto [mesh, expected, found] =
        trace(shapes::grid(columns(), rows(), jitter, GetParam()), Metric::kDgpc);
    for (int label = 0; label < found.siteCount; ++label)
      EXPECT_NEAR(found.regionArea[label], expected.regionArea[label], 1e-3 * mesh.area());
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FlatMeshes, ::testing::Range(0, 64));

TEST(Diagram, OfOneSiteOnAClosedSurfaceHasNoLoop) {
  const auto mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_EQ(d.loops.size(), 0);
  EXPECT_TRUE(d.segments.empty());
  EXPECT_NEAR(d.regionArea[0], mesh.area(), 1e-12 * mesh.area());
}

TEST(Diagram, OfOneSiteOnADiskIsOutlinedByTheBoundary) {
  const auto mesh = shapes::grid(3, 2).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  const Diagram d = trace(mesh, sites).diagram;
  ASSERT_EQ(d.loops.size(), 1);
  EXPECT_EQ(d.loops[0].size(), 10u);
  EXPECT_TRUE(isConsistent(mesh, d));
}

TEST(Diagram, LeavesOtherComponentsUnreachable) {
  const auto mesh = shapes::joined(shapes::octahedron(),
                                   shapes::moved(shapes::octahedron(), Eigen::Vector3d(5, 0, 0)))
                        .mesh();
  const std::vector<SurfacePoint> sites = {centroid(0), centroid(3)};
  const Diagram d = trace(mesh, sites).diagram;
  for (int f = 0; f < mesh.faceCount(); ++f)
    EXPECT_EQ(d.faceLabel[f] == Diagram::kUnreachable, mesh.component(f) != mesh.component(0));
  EXPECT_TRUE(isConsistent(mesh, d));
}

TEST(Diagram, GivesCoincidentSitesToTheLowerLabel) {
  const auto mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {centroid(40), centroid(7), centroid(7)};
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_GT(d.regionArea[1], 0);
  EXPECT_EQ(d.regionArea[2], 0);
  EXPECT_TRUE(isConsistent(mesh, d));
}

TEST(Diagram, CutsACubeAlongEdgesBetweenOppositeFaceCentres) {
  // The bisector of two opposite centres runs over the middle of the other four faces.
  const auto mesh = shapes::cube().mesh();
  std::vector<SurfacePoint> sites;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const int h = 3 * f;  // the middle of each face's diagonal, found by its length
    for (int i = 0; i < 3; ++i)
      if (mesh.length(h + i) > 1.2 && mesh.twin(h + i) > h + i) {
        Eigen::Vector3d bary = Eigen::Vector3d::Zero();
        bary[i] = bary[(i + 1) % 3] = 0.5;
        sites.push_back({f, bary});
      }
  }
  ASSERT_EQ(sites.size(), 6u);
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_TRUE(isConsistent(mesh, d));
  for (const double area : d.regionArea) EXPECT_NEAR(area, 1.0, 1e-9);
  EXPECT_EQ(d.voronoiPoints.size(), 8u);
  for (const auto& v : d.voronoiPoints) {
    EXPECT_EQ(v.labels.size(), 3u);
    EXPECT_EQ(d.points[v.point].bary.maxCoeff(), 1.0) << "a Voronoi point at a corner of the cube";
  }
}

TEST(Diagram, JoinsCocircularSitesInOneVoronoiPoint) {
  for (const int n : {4, 6, 8, 24}) {
    const auto mesh = shapes::vertexFan(n, 2 * 3.141592653589793).mesh();
    std::vector<SurfacePoint> sites;
    for (int f = 0; f < n; ++f) sites.push_back({f, {0.5, 0.25, 0.25}});
    const Diagram d = trace(mesh, sites).diagram;
    EXPECT_TRUE(isConsistent(mesh, d)) << n;
    ASSERT_EQ(d.voronoiPoints.size(), 1u) << n;
    ASSERT_EQ(static_cast<int>(d.voronoiPoints[0].labels.size()), n);
    const auto& labels = d.voronoiPoints[0].labels;
    for (int i = 0; i + 1 < n; ++i)
      EXPECT_TRUE(std::abs(labels[i] - labels[i + 1]) == 1) << "the cyclic order is the sites'";
  }
}

/// Sites 1e-11 apart in faces as thin: on both sides of one edge, between the same two vertices,
/// runs a bisector of other regions, and between the two another one turns beside the edge.
TEST(Diagram, KeepsBothBisectorsBesideAThinRegion) {
  const std::vector<double> positions = {0.30000000000000021,
                                         0.70000000000000018,
                                         0,
                                         4.4408920985006262e-16,
                                         0.1,
                                         0,
                                         0.89999999999999969,
                                         0.69999999999999973,
                                         0.090000000000000011,
                                         0.3,
                                         0.7,
                                         0,
                                         0.89999999999999991,
                                         0.7,
                                         0.090000000000000011,
                                         0.6,
                                         0.1,
                                         0.090000000000000011};
  const std::vector<int> triangles = {0, 1, 2, 0, 2, 3, 1, 4, 2, 3, 2, 5, 2, 4, 5};
  const TriangleMesh mesh(positions, triangles);
  const std::vector<SurfacePoint> sites = {
      {2, {2.8285470703762107e-12, 0.28284671053088811, 0.71715328946628332}},
      {4, {0.71715340615759871, 0.28284659383782462, 4.5766537018318763e-12}},
      {3, {4.2134979853870699e-12, 0.99999999999197564, 3.810828832845928e-12}},
      {1, {3.5780832650393628e-12, 0.99999999999284372, 3.5780832650393616e-12}}};
  EXPECT_TRUE(checks::isConsistent(mesh, trace(mesh, sites, Metric::kDgpc).diagram));
}

/// At the tip of a spike, the distances of two labels are equal up to rounding. One of them becomes
/// known there later: the other one's distance, now less, makes it own part of an edge.
TEST(Diagram, LooksAgainAtLabelsThatTieWithALaterOne) {
  const std::vector<double> positions = {3, 3, 2, 0, 0, 0, 2, 0, 1, 3, 3, 3, 1, 1, 1, -1e30, 1, 3};
  const std::vector<int> triangles = {0, 2, 3, 1, 3, 2, 0, 3, 4, 1, 4, 3,
                                      0, 4, 5, 1, 5, 4, 0, 5, 2, 1, 2, 5};
  const TriangleMesh mesh(positions, triangles);
  const std::vector<SurfacePoint> sites = {
      {2, {0.0430908203125, 0.0052490234375, 0.95166015625}},
      {0, {0.66802978515625, 0, 0.33197021484375}},
      {3, {0, 0.0017852783203125, 0.9982147216796875}},
      {0, {0.124237060546875, 0.36181640625, 0.513946533203125}},
      {0, {1, 0, 0}},
      {1, {0.471954345703125, 0.367462158203125, 0.16058349609375}}};
  EXPECT_TRUE(checks::isConsistent(mesh, trace(mesh, sites).diagram));
}

TEST(Diagram, HandlesManySitesInOneFace) {
  const auto mesh = shapes::triangle().mesh();
  shapes::Random random(3);
  std::vector<SurfacePoint> sites;
  for (int i = 0; i < 50; ++i) {
    const double a = random.uniform(), b = random.uniform() * (1 - a);
    sites.push_back({0, {a, b, 1 - a - b}});
  }
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_TRUE(isConsistent(mesh, d));
  for (const double area : d.regionArea) EXPECT_GT(area, 0);
}

/// Merged points leave lines on which no two regions meet; their ends belong to nothing.
TEST(Diagram, HasNoPointThatNothingUses) {
  const auto mesh = shapes::perforatedPlate(2, 2).mesh();
  const std::vector<SurfacePoint> sites = {
      {71, {0, 0, 1}},
      {34, {0.80756957118011363, 0.025521006821002151, 0.16690942199888423}},
      {135, {0.1966704560789887, 0.6737012805873529, 0.12962826333365843}},
      {216, {1, 0, 0}},
      {202, {0.0057697656951554155, 0.29069311688112542, 0.70353711742371916}},
      {253, {0, 1, 0}},
      {42, {0.32357093581505203, 0.67642906418494797, 0}}};
  EXPECT_TRUE(isConsistent(mesh, trace(mesh, sites).diagram));
}

/// A vertex far away makes faces so thin that a corner between three regions is on the side of its
/// face but for rounding. The face beyond has put a point there, not the same to the last bit.
TEST(Diagram, GivesEachPlaceOnce) {
  shapes::Shape shape;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d{0, 1, 1e30},
                                   {0, 0, 1},
                                   {1, 0, 0},
                                   {0, 0, 0},
                                   {1, 0, 1},
                                   {0, 1, 0},
                                   {0, 0.19547346429421841, 0.8683120471038891}})
    shape.addVertex(p);
  shape.triangles = {0, 1, 2, 0, 2, 3, 3, 2, 4, 2, 5, 6, 2, 6, 4};
  const TriangleMesh mesh = shape.mesh();
  const std::vector<SurfacePoint> sites = {
      {3, {0.6, 0.4, 0}}, {0, {0, 0.5, 0.5}}, {1, {0, 0.5, 0.5}}};
  const Diagram diagram = checks::trace(mesh, sites).diagram;
  for (size_t i = 0; i < diagram.points.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const SurfacePoint& p = diagram.points[i];
      const auto other = pointInFace(mesh, diagram.points[j], p.face);
      EXPECT_FALSE(other && other->bary == p.bary) << j << " and " << i;
    }
}

/// On a spike, all segments of a Voronoi point near the apex lead to the merged point there.
TEST(Diagram, LeavesOutVoronoiPointsThatNoRegionReaches) {
  shapes::Shape spike;
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d{3, 3, 2}, {0, 0, 0}, {0, 0, 1}, {3, 1, 1}, {-1e30, 1, 3}})
    spike.addVertex(p);
  spike.triangles = {0, 2, 3, 1, 3, 2, 0, 3, 4, 1, 4, 3, 0, 4, 2, 1, 2, 4};
  const TriangleMesh mesh = spike.mesh();
  std::vector<SurfacePoint> sites = {{0, {1, 0, 0}}, {0, {0, 0, 1}}};
  for (const double share : {0.0234527587890625, 0.01171875, 0.00390625})
    sites.push_back({0, {share, 0, 1 - share}});
  sites.push_back({0, {0, 0.0390625, 0.9609375}});
  const Diagram d = trace(mesh, sites, Metric::kExact).diagram;
  EXPECT_TRUE(isConsistent(mesh, d));
  EXPECT_EQ(d.voronoiPoints.size(), 5u);
}

/// Each corner knows thousands of labels, and few of them own part of the diagonal.
TEST(Diagram, DividesTwoFacesAmongThousandsOfSites) {
  const auto mesh = shapes::grid(1, 1).mesh();
  const auto sites = sampleUniform(mesh, 3000, 1);
  const Diagram expected = traceByBruteForce(mesh, sites).diagram;
  for (const Metric metric : {Metric::kExact, Metric::kDgpc}) {
    const Diagram found = trace(mesh, sites, metric).diagram;
    EXPECT_TRUE(isConsistent(mesh, found));
    EXPECT_TRUE(areSame(mesh, expected, found, identity(found.siteCount), 1e-11));
  }
}

TEST(Diagram, IsTheSameInSlices) {
  for (int seed = 0; seed < 60; ++seed) {
    const RandomCase c = randomCase(seed);
    const auto mesh = c.mesh();
    const auto sites = c.sitesOn(mesh);
    const int count = static_cast<int>(sites.size());
    const auto traced = trace(mesh, sites);
    for (const int detail : {0, 1, 2})
      for (const long budget : {1, 7, 100}) {
        const auto tracing = startDiagram(mesh, *traced.field, count, {.detail = detail});
        while (!tracing->step(budget)) {
        }
        EXPECT_TRUE(tracing->take() == traceDiagram(mesh, *traced.field, count, {.detail = detail}))
            << "seed " << seed << ", detail " << detail << ", budget " << budget;
      }
  }
}

/// The mixed faces of which all cells have one label and no bisector ends on their outline.
std::vector<int> mixedFacesOfOneRegion(const TriangleMesh& mesh, const Diagram& d) {
  std::vector<char> endsSegment(d.points.size());
  for (const auto& s : d.segments)
    for (const int p : s.points) endsSegment[p] = d.points[p].bary.maxCoeff() < 1;
  std::vector<int> first(mesh.faceCount(), -1);
  std::vector<char> isDivided(mesh.faceCount());
  for (int i = 0; i < d.cells.size(); ++i) {
    int& label = first[d.cellFace[i]];
    if (label < 0) label = d.cellLabel[i];
    isDivided[d.cellFace[i]] |= label != d.cellLabel[i];
    for (const int p : d.cells[i]) isDivided[d.cellFace[i]] |= endsSegment[p];
  }
  std::vector<int> faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (d.faceLabel[f] == Diagram::kMixed && !isDivided[f]) faces.push_back(f);
  return faces;
}

TEST(Diagram, InDetailStillLabelsFacesOfOneRegion) {
  for (int seed = 0; seed < 100; ++seed) {
    const RandomCase c = randomCase(seed);
    const auto mesh = c.mesh();
    for (const int detail : {0, 1, 2})
      EXPECT_EQ(
          mixedFacesOfOneRegion(mesh, trace(mesh, c.sitesOn(mesh), Metric::kDgpc, detail).diagram),
          std::vector<int>())
          << "seed " << seed << ", detail " << detail;
  }
}

TEST(Diagram, KeepsRegionsConsistentWithDetail) {
  const auto mesh = shapes::bumpySurface(1, 2, 0.2, 5).mesh();
  const auto sites = sampleUniform(mesh, 12, 5);
  for (const int detail : {1, 2, 3})
    EXPECT_TRUE(isConsistent(mesh, trace(mesh, sites, Metric::kDgpc, detail).diagram, detail));
}

std::array<SurfacePoint, 2> endsOf(const TriangleMesh& mesh, const Diagram& d,
                                   const Diagram::Segment& s) {
  const auto inFace = [&](int point) {
    return SurfacePoint{s.face, baryInFace(mesh, d.points[point], s.face)};
  };
  return {inFace(s.points[0]), inFace(s.points[1])};
}

TEST(Diagram, HasNoLongerSegmentsThanItsDetailAllows) {
  for (const auto& [name, shape, genus] : shapes::mechanicalShapes()) {
    const auto mesh = shape.mesh();
    const auto sites = sampleUniform(mesh, 12, 3);
    for (const Metric metric : {Metric::kDgpc, Metric::kExact})
      for (const int detail : {1, 2}) {
        const Diagram d = trace(mesh, sites, metric, detail).diagram;
        EXPECT_TRUE(isConsistent(mesh, d, detail)) << name;
        const double most =
            std::ldexp(std::sqrt(2.0) * mesh.meanEdgeLength(), -detail) * (1 + 1e-9);
        for (const Diagram::Segment& s : d.segments)
          ASSERT_LE(lengthOf(mesh, endsOf(mesh, d, s)), most) << name << ", detail " << detail;
      }
  }
}

/// By how much the middles of segments are nearer to some other label than to those of the segment,
/// on average.
double meanErrorOfSegments(const TriangleMesh& mesh, const checks::Traced& traced) {
  const Diagram& d = traced.diagram;
  std::vector<LabelledPoint> middles;
  for (const Diagram::Segment& s : d.segments) {
    const auto [a, b] = endsOf(mesh, d, s);
    for (const int label : s.labels) middles.push_back({label, {s.face, (a.bary + b.bary) / 2}});
  }
  const auto distances = finished(traced.field->startDistancesAt(middles));
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < middles.size(); ++i) {
    if (distances[i] == kInfinity) continue;  // unknown at the corners of the face
    sum += distances[i] - traced.field->nearest(middles[i].point).distance;
    ++count;
  }
  return sum / count;
}

/// Around a cone all triangles are alike: when the part of one that keeps a whole side is cut, the
/// two diagonals are equally long, and rounding chose one. Areas changed by 5e-6.
TEST(Detail, DoesNotDependOnTheFirstCornerOfATriangle) {
  const shapes::Shape cone = shapes::vertexFan(8, 4);
  const TriangleMesh mesh = cone.mesh();
  const auto sites = sampleUniform(mesh, 9, 1);
  for (const int first : {1, 2}) {
    shapes::Shape turned = cone;
    auto turnedSites = sites;
    for (int t = 0; t < cone.faceCount(); t += 2)
      for (int i = 0; i < 3; ++i)
        turned.triangles[3 * t + i] = cone.triangles[3 * t + (i + first) % 3];
    for (SurfacePoint& p : turnedSites)
      if (p.face % 2 == 0) std::rotate(p.bary.begin(), p.bary.begin() + first, p.bary.end());
    const TriangleMesh turnedMesh = turned.mesh();
    for (const int detail : {1, 2, 3}) {
      const auto areas = trace(mesh, sites, Metric::kExact, detail).diagram.regionArea;
      const auto turnedAreas =
          trace(turnedMesh, turnedSites, Metric::kExact, detail).diagram.regionArea;
      for (std::size_t l = 0; l < sites.size(); ++l)
        EXPECT_NEAR(turnedAreas[l], areas[l], 1e-12) << "detail " << detail << ", site " << l;
    }
  }
}

TEST(Diagram, InDetailIsFineOnLongThinFacesToo) {
  const auto mesh = shapes::mechanicalShape("plate with nine round holes").mesh();
  const auto sites = sampleUniform(mesh, 12, 3);
  const double coarse = meanErrorOfSegments(mesh, trace(mesh, sites));
  const double fine = meanErrorOfSegments(mesh, trace(mesh, sites, Metric::kExact, 2));
  EXPECT_LT(fine, coarse / 16);
}

/// In a plane, with sites all around an element, many of them far.
TEST(Diagram, InDetailAsksForAllLabelsThatAreNearestInAnElement) {
  const TieTolerance ties(shapes::grid(1, 1, 0, 1).mesh());
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  long nearCount = 0, knownCount = 0;
  for (int round = 0; round < 300; ++round) {
    const double width = std::pow(10.0, -3 * (round % 3));  // down to needles
    std::array<Eigen::Vector2d, 3> corners;
    for (auto& corner : corners) corner = {place(random), width * place(random)};
    std::vector<Eigen::Vector2d> sites(40);
    for (auto& site : sites) site = 4 * Eigen::Vector2d(place(random), place(random));
    const auto distance = [&](int label, const Eigen::Vector2d& p) {
      return (sites[label] - p).norm();
    };
    std::array<std::vector<LabelledDistance>, 3> known;
    std::array<double, 3> lengths;
    for (int i = 0; i < 3; ++i) {
      lengths[i] = (corners[cornerAfter(i)] - corners[i]).norm();
      for (int label = 0; label < 40; ++label)
        // Every fourth is not known at the first corner.
        if (i > 0 || label % 4 > 0) known[i].push_back({label, distance(label, corners[i])});
    }
    std::vector<NearLabel> nearLabels;
    findNearLabels({known[0], known[1], known[2]}, lengths, ties, nearLabels);
    std::set<int> near;
    for (const auto& found : nearLabels) {
      near.insert(found.label);
      EXPECT_EQ(found.isKnown, (std::array{found.label % 4 > 0, true, true}));
    }
    nearCount += static_cast<long>(near.size());
    knownCount += 40;
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d bary = drawBarycentric(random);
      const Eigen::Vector2d p = bary[0] * corners[0] + bary[1] * corners[1] + bary[2] * corners[2];
      int nearest = 0;
      for (int label = 1; label < 40; ++label)
        if (distance(label, p) < distance(nearest, p)) nearest = label;
      EXPECT_TRUE(near.contains(nearest)) << "round " << round;
    }
  }
  EXPECT_LT(nearCount, knownCount / 2);
}

TEST(Diagram, RefusesUnboundedDetailAndSitesThatAreNotCounted) {
  const auto mesh = shapes::grid(3, 3, 0.3, 1).mesh();
  const auto distances = finished(propagate(mesh, sampleUniform(mesh, 3, 1), Metric::kExact));
  for (const int detail : {-1, DiagramOptions::kMostDetail + 1}) {
    EXPECT_THROW(traceDiagram(mesh, *distances, 3, {.detail = detail}), Error) << detail;
    EXPECT_THROW(propagationShare({.detail = detail}), Error) << detail;
  }
  EXPECT_THROW(traceDiagram(mesh, *distances, 2), Error);
  EXPECT_EQ(traceDiagram(mesh, *distances, 3).siteCount, 3);
}

/// A label known at the one corner where it is nearest, beside others that are known at all.
TEST(Diagram, RefusesAFieldThatLacksNearestLabels) {
  class Lacking final : public checks::NoDistances {
   public:
    explicit Lacking(int others) {
      for (int v = 0; v < 3; ++v) {
        for (int label = 0; label < others; ++label) known_[v].push_back({label, 2});
        known_[v].push_back({others + v, 1});
      }
    }
    std::span<const LabelledDistance> at(int v) const override { return known_[v]; }

   private:
    std::array<std::vector<LabelledDistance>, 3> known_;
  };
  const auto mesh = shapes::triangle().mesh();
  EXPECT_THROW(traceDiagram(mesh, Lacking(0), 3), std::logic_error);
  EXPECT_THROW(traceDiagram(mesh, Lacking(4), 7), std::logic_error);
}

}  // namespace
}  // namespace gvd
