// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "brute_force.h"
#include "distance/dgpc/unfolding_sweep.h"
#include "distance/edge_bounds.h"
#include "distance/exact/window_sweep.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "gvd/straightest.h"
#include "in_steps.h"
#include "random_case.h"
#include "shapes.h"
#include "strip_between_holes.h"

namespace gvd {
namespace {

std::unique_ptr<DistanceField> inSlices(const TriangleMesh& mesh,
                                        const std::vector<SurfacePoint>& sites, Metric metric,
                                        long budget) {
  const auto propagation = propagate(mesh, sites, metric);
  double progress = 0;
  while (!propagation->step(budget)) {
    EXPECT_GE(propagation->progress(), progress);
    EXPECT_LE(propagation->progress(), 1);
    progress = propagation->progress();
  }
  return propagation->take();
}

/// The same labels with the same distances, bit by bit, at all vertices.
void expectSame(const TriangleMesh& mesh, const DistanceField& field, const DistanceField& expected,
                int seed) {
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const auto found = field.at(v), wanted = expected.at(v);
    ASSERT_EQ(found.size(), wanted.size()) << "seed " << seed << ", vertex " << v;
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].label, wanted[i].label) << "seed " << seed << ", vertex " << v;
      EXPECT_EQ(found[i].distance, wanted[i].distance) << "seed " << seed << ", vertex " << v;
    }
  }
}

class Metrics : public ::testing::TestWithParam<Metric> {};

TEST_P(Metrics, GiveTheSameInSlicesOfAnySize) {
  const auto check = [&](const TriangleMesh& mesh, const std::vector<SurfacePoint>& sites,
                         int seed) {
    const auto whole = inSlices(mesh, sites, GetParam(), 1L << 40);
    for (const long budget : {1L, 7L})
      expectSame(mesh, *inSlices(mesh, sites, GetParam(), budget), *whole, seed);
  };
  for (int seed = 0; seed < 40; ++seed) {
    const RandomCase random = randomCase(seed);
    const TriangleMesh mesh = random.mesh();
    check(mesh, random.sitesOn(mesh), seed);
    // Most labels own no vertex, only parts of edges, so the closure goes many rounds.
    const TriangleMesh tube = shapes::cylinder(40 + seed, 1, 1, 1).mesh();
    check(tube, sampleUniform(tube, 20, seed), seed);
  }
}

/// A vertex may be out of sight of all windows of its neighbours; it is reached all the same,
/// unless nothing connects it to a site.
TEST_P(Metrics, ReachEveryVertexOfAComponentWithASite) {
  for (int seed = 0; seed < 300; ++seed) {
    const TriangleMesh mesh = randomCase(seed).mesh();
    const auto sites = sampleUniform(mesh, 1, seed);
    const auto field = inSlices(mesh, sites, GetParam(), 1);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const int component = mesh.component(TriangleMesh::faceOf(mesh.outgoing(v)));
      EXPECT_EQ(field->at(v).empty(), component != mesh.component(sites[0].face))
          << "seed " << seed << ", vertex " << v;
    }
  }
}

/// A straight line winds around the apex of a cone π / angle times. Windows must not.
TEST(Windows, GoAroundASpikeOnce) {
  constexpr int kFaces = 5;
  constexpr double kAngle = 1e-6;
  const TriangleMesh mesh = shapes::vertexFan(kFaces, kAngle).mesh();
  const auto propagation = propagate(mesh, std::vector{shapes::centroid(0)}, Metric::kExact);
  long halfedges = 1;
  while (!propagation->step(1)) ++halfedges;
  EXPECT_LT(halfedges, 1000);

  std::vector<LabelledPoint> points;
  for (int f = 0; f < kFaces; ++f) points.push_back({0, shapes::centroid(f)});
  const auto field = propagation->take();
  const auto distances = field->distancesAt(points);
  for (int f = 0; f < kFaces; ++f) {
    const double turn = std::min(f, kFaces - f) * kAngle / kFaces;
    EXPECT_NEAR(distances[f], 2.0 / 3 * turn, 1e-6 * kAngle) << "face " << f;
    EXPECT_NEAR(field->nearest(points[f].point).distance, distances[f], 1e-15) << "face " << f;
  }
}

/// The saddle vertex 3 is 1e-11 from vertex 1, with two needles between them.
shapes::Shape saddleAtANeedle() {
  shapes::Shape shape;
  for (const Eigen::Vector3d& p : std::initializer_list<Eigen::Vector3d>{
           {0.1131635393494393, 0.00022632707869095717, -0.33949061801663211},
           {0.10307965959821436, 0.00020615931919642865, -0.30923897879464279},
           {0.7219608851841518, 0.00072236415318080362, 0.7203478131975446},
           {0.10307965959821436, 0.00020615931919642865, -0.30923897879464285},
           {0.8246372767857143, 0.00092641993931361609, 0.26497977120535715},
           {0.031303652823311941, 6.2612904859270374e-05, -0.093905705174037388},
           {0.019531250652343748, 3.9062500351562503e-05, -0.05859375}})
    shape.addVertex(p);
  shape.triangles = {0, 2, 3, 1, 3, 2, 0, 3, 4, 1, 4, 3, 0, 4, 5,
                     1, 5, 4, 0, 5, 6, 1, 6, 5, 0, 6, 2, 1, 2, 6};
  return shape;
}

/// The shortest path turns at vertex 3 and passes vertex 1 through the faces between them. Other
/// sites make it known in another way than the site alone does.
TEST(Windows, LeaveNoGapBesideASaddleAtANeedle) {
  const TriangleMesh mesh = saddleAtANeedle().mesh();
  const std::vector<SurfacePoint> sites = {
      {5, {0.0000152587890625, 0.0000152587890625, 0.999969482421875}},
      {0, {0.996124267578125, 0, 0.003875732421875}},
      {0, {0.000213623046875, 0.0003509521484375, 0.9994354248046875}},
      {8, {0.125, 0.375, 0.5}}};
  const int end = 5;
  const auto alone = inSlices(mesh, {sites[1]}, Metric::kExact, 1000);
  const auto known = inSlices(mesh, sites, Metric::kExact, 1000);
  for (const LabelledDistance& d : known->at(end)) {
    if (d.label == 1) {
      EXPECT_EQ(d.distance, alone->at(end)[0].distance);
    }
  }
  EXPECT_NEAR(alone->at(end)[0].distance, 0.25874513642959723, 1e-15);
}

/// The shortest path crosses a needle 1e-11 before vertex 3, where rounding of the crossing is a
/// large angle, and goes on along the edge to vertex 0.
TEST(Windows, LeaveNoGapBehindASaddleThatPathsReachThroughANeedle) {
  const TriangleMesh mesh = saddleAtANeedle().mesh();
  const SurfacePoint site = {7, {0.1953125, 0.2817535400390625, 0.5229339599609375}};
  const auto field = inSlices(mesh, {site}, Metric::kExact, 1000);
  ASSERT_EQ(mesh.tail(0), 0);
  ASSERT_EQ(mesh.tail(2), 3);
  EXPECT_LE(field->at(0)[0].distance, field->at(3)[0].distance + mesh.length(2) + 1e-15);
}

/// In these faces rounding hides a vertex from its straight path, so the site's label is required
/// there before the other distances are final; it must not forget then that they are.
TEST(Windows, KeepWhatIsFinalWhenAVertexWasMissed) {
  shapes::Shape shape;
  for (const Eigen::Vector3d& p :
       std::initializer_list<Eigen::Vector3d>{{1e30, 0.279018, -0.418527},
                                              {1e30, 0.103795, -0.155692},
                                              {0.000135149, 0.000270299, -0.000405448},
                                              {0.000544957, 0.00108991, 1e30},
                                              {0.00168283, 0.00336565, -0.00504848},
                                              {0, 0, 0},
                                              {0.00446429, 0.00892857, -0.0133929},
                                              {6.53948e-06, 1.3079e-05, -1.96184e-05},
                                              {0.00168065, 0.00336129, -0.00504194}})
    shape.addVertex(p);
  shape.triangles = {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4, 4, 5, 7, 4, 7, 6, 5, 8, 7};
  const TriangleMesh mesh = shape.mesh();
  const auto field =
      inSlices(mesh, {{3, {0.0008544921875, 0.2156982421875, 0.783447265625}}, {6, {0, 1, 0}}},
               Metric::kExact, 1000);
  for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_FALSE(field->at(v).empty()) << v;
}

/// In a long tetrahedron, the way through the middle of an edge to the corner beyond is shorter
/// than to both ends of the edge, and so is another one that comes before it, round the back.
TEST(Dgpc, ReachesACornerThatIsNearerThanBothEndsOfTheSideBefore) {
  const std::vector<double> positions = {0, 0, 0, 12, 0, 0, 6, 1, 0, 6, 0, 1};
  const std::vector<int> triangles = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  const TriangleMesh mesh(positions, triangles);
  const std::vector<SurfacePoint> sites = {{2, {0.475, 0.05, 0.475}}};  // 0.05 from the edge 0-1
  const auto field = inSlices(mesh, sites, Metric::kDgpc, 1L << 40);
  EXPECT_NEAR(field->distance(0, {0, Eigen::Vector3d::Unit(2)}), 1.05, 1e-9);
}

/// A double fan of vertices on one line, which is far from the origin: there, a point between two
/// vertices is rounded by more than the mesh is large. Distances follow from differences, which are
/// the same.
TEST_P(Metrics, AreTheSameFarFromTheOrigin) {
  constexpr int kAround = 100;
  for (int seed = 0; seed < 10; ++seed) {
    shapes::Random random(seed);
    shapes::Shape shape;
    for (int v = 0; v < kAround + 2; ++v) shape.addVertex({0, 0, random.uniform()});
    for (int i = 0; i < kAround; ++i) {
      const int v = 2 + i, next = 2 + (i + 1) % kAround;
      shape.addTriangle(0, v, next);
      shape.addTriangle(1, next, v);
    }
    const TriangleMesh mesh = shape.mesh();
    const TriangleMesh farMesh = shapes::moved(shape, {1e16, -1e16, 0}).mesh();
    const auto sites = sampleUniform(mesh, 5, seed);
    expectSame(farMesh, *inSlices(farMesh, sites, GetParam(), 1L << 40),
               *inSlices(mesh, sites, GetParam(), 1L << 40), seed);
  }
}

/// Almost the largest and smallest that `TriangleMesh` takes: a product of more than four lengths
/// would over- or underflow.
TEST_P(Metrics, GrowWithTheMeshToAnySize) {
  const shapes::Shape shape = shapes::grid(12, 12);
  const std::vector<SurfacePoint> sites = {{0, {0.3, 0.3, 0.4}}};
  const TriangleMesh unscaled = shape.mesh();
  const auto expected = inSlices(unscaled, sites, GetParam(), 1L << 40);
  for (const double scale : {0x1p190, 0x1p-190}) {
    const TriangleMesh mesh = shapes::scaled(shape, scale).mesh();
    const auto field = inSlices(mesh, sites, GetParam(), 1L << 40);
    for (int v = 0; v < mesh.vertexCount(); ++v)
      EXPECT_NEAR(field->at(v)[0].distance / scale, expected->at(v)[0].distance, 1e-12) << v;
  }
}

/// Memory follows the vertices, not the ratio of the distances to the short edges.
TEST_P(Metrics, RunAlongARibbonAHundredMillionTimesAsLongAsWide) {
  constexpr int kQuads = 2500;
  constexpr double kWidth = 2.5e-5;
  shapes::Shape ribbon;
  for (int i = 0; i <= kQuads; ++i)
    for (const double y : {0.0, kWidth}) ribbon.addVertex({static_cast<double>(i), y, 0});
  for (int v = 0; v < 2 * kQuads; v += 2) ribbon.addQuad(v, v + 2, v + 3, v + 1);
  const TriangleMesh mesh = ribbon.mesh();
  const SurfacePoint site = {0, {1, 0, 0}};
  const auto field = inSlices(mesh, {site}, GetParam(), 1000);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double line = (mesh.position(v) - mesh.position(0)).norm();
    ASSERT_NEAR(field->at(v)[0].distance, line, 1e-9 * line) << v;
  }
}

/// A strip, one side of which is nearer to the site. Its vertices once got distances along that
/// side first, and were improved so often by those through the strip that they stayed up to 5 % too
/// long.
TEST(Dgpc, IsExactAlongAStrip) {
  constexpr int kQuads = 1000;
  shapes::Shape strip;
  for (int i = 0; i <= kQuads; ++i)
    for (const double y : {0.0, 1.0}) strip.addVertex({0.003 * i, y, 0});
  for (int v = 0; v < 2 * kQuads; v += 2) strip.addQuad(v, v + 2, v + 3, v + 1);
  const TriangleMesh mesh = strip.mesh();
  dgpc::UnfoldingSweep sweep(mesh);
  long unlimited = std::numeric_limits<long>::max();
  sweep.prepare(unlimited);
  for (const int face : {kQuads, kQuads + 1}) {
    const SurfacePoint site = {face, {0.3, 0.6, 0.1}};
    sweep.start(site);
    long passes = 2L * mesh.vertexCount();
    EXPECT_TRUE(sweep.step(passes)) << face;
    for (int v = 0; v < mesh.vertexCount(); ++v)
      ASSERT_NEAR(sweep.distance(v), (mesh.position(v) - mesh.position(site)).norm(), 1e-11) << v;
  }
}

/// Two vertices 1e-6 apart see the site through opposite faces of their edge, and virtual sources
/// there that contradict each other: each lowered the distance of the other 14 million times.
TEST(Dgpc, NeighboursDoNotLowerTheirDistancesByTurns) {
  const std::vector<double> positions = {6e-7, 0,    7e-7,      0, 3, 3, 0.14, 0.29, -0.43,
                                         0.14, 0.29, -0.430004, 0, 0, 0, 3,    3,    3};
  const std::vector<int> triangles = {0, 2, 3, 1, 3, 2, 0, 3, 4, 1, 4, 3,
                                      0, 4, 5, 1, 5, 4, 0, 5, 2, 1, 2, 5};
  const TriangleMesh mesh(positions, triangles);
  const std::vector<SurfacePoint> sites = {{7, {0.35, 0.58, 0.07}}};
  const auto propagation = propagate(mesh, sites, Metric::kDgpc);
  EXPECT_TRUE(propagation->step(1000));
}

/// On edges, where a label is known at both ends, whichever label is nearer in between; and inside
/// faces.
/// Sites on edges, each named in either face. DGPC once gave one of them two distances at a vertex,
/// 5 % apart: where other sites stop a site, distances depend on the order of its vertices.
TEST_P(Metrics, DoNotDependOnTheFaceThatNamesASite) {
  const TriangleMesh mesh = shapes::grid(3, 4).mesh();
  const std::vector<SurfacePoint> sites = {
      {13, {0.25, 0.75, 0}}, {13, {0.5, 0.5, 0}}, {23, {0.75, 0, 0.25}}};
  const std::vector<SurfacePoint> same = {
      {12, {0.25, 0, 0.75}}, {12, {0.5, 0, 0.5}}, {20, {0, 0.75, 0.25}}};
  const auto expected = finished(propagate(mesh, sites, GetParam()));
  for (int named = 0; named < 8; ++named) {
    std::vector<SurfacePoint> mixed = sites;
    for (int i = 0; i < 3; ++i)
      if ((named >> i & 1) != 0) mixed[i] = same[i];
    const auto field = finished(propagate(mesh, mixed, GetParam()));
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      ASSERT_EQ(field->at(v).size(), expected->at(v).size());
      for (size_t k = 0; k < field->at(v).size(); ++k) {
        EXPECT_EQ(field->at(v)[k].label, expected->at(v)[k].label);
        EXPECT_NEAR(field->at(v)[k].distance, expected->at(v)[k].distance, 1e-12);
      }
    }
  }
}

TEST(Distances, AtPointsAreThoseOfBruteForce) {
  for (int seed = 0; seed < 100; ++seed) {
    const TriangleMesh mesh = shapes::randomMesh(seed);
    const auto sites = sampleUniform(mesh, std::min(20, shapes::randomSiteCount(mesh, seed)), seed);
    const auto field = inSlices(mesh, sites, Metric::kExact, 1000);
    const checks::BruteForce expected(mesh, sites, Metric::kExact);
    const auto isKnown = [&](int v, int label) {
      return std::ranges::any_of(field->at(v), [&](auto& d) { return d.label == label; });
    };
    std::vector<LabelledPoint> points;
    for (int h = 0; h < mesh.halfedgeCount(); ++h)
      for (const LabelledDistance& d : field->at(mesh.tail(h))) {
        if (!isKnown(mesh.tip(h), d.label)) continue;
        SurfacePoint p{TriangleMesh::faceOf(h), Eigen::Vector3d::Zero()};
        p.bary[h % 3] = 0.25;
        p.bary[(h + 1) % 3] = 0.75;
        points.push_back({d.label, p});
        if (isKnown(mesh.tail(TriangleMesh::previous(h)), d.label))
          points.push_back({d.label, {p.face, {0.2, 0.3, 0.5}}});
      }
    const auto found = field->distancesAt(points);
    for (size_t i = 0; i < points.size(); ++i)
      ASSERT_NEAR(found[i], expected.distance(points[i].label, points[i].point),
                  1e-12 * mesh.boundingDiagonal())
          << "seed " << seed;
    EXPECT_EQ(field->distancesAt(points), found) << "asked again, seed " << seed;
  }
}

/// The nearest site is searched for from the point; brute force spreads from the sites.
TEST(Distances, NearestIsTheLeastOfBruteForce) {
  for (int seed = 0; seed < 200; ++seed) {
    const RandomCase random = seed % 2 == 0 ? randomCase(seed) : wildCase(seed);
    const TriangleMesh mesh = random.mesh();
    const std::vector<SurfacePoint> sites = random.sitesOn(mesh);
    if (sites.size() > 20) continue;
    const auto field = inSlices(mesh, sites, Metric::kExact, 1000);
    const checks::BruteForce brute(mesh, sites, Metric::kExact);
    std::vector<LabelledPoint> points;
    for (int f = 0; f < mesh.faceCount(); ++f)
      for (const Eigen::Vector3d& bary : {Eigen::Vector3d(0.2, 0.3, 0.5), {0.25, 0.75, 0}})
        for (int label = 0; label < static_cast<int>(sites.size()); ++label)
          points.push_back({label, {f, bary}});
    const auto distances = brute.distancesAt(points);
    for (size_t i = 0; i < points.size(); i += sites.size()) {
      const auto there = std::span(distances).subspan(i, sites.size());
      const LabelledDistance nearest = field->nearest(points[i].point);
      const double least = *std::ranges::min_element(there);
      if (least == kInfinity) {
        EXPECT_EQ(nearest.label, -1) << "seed " << seed;
        continue;
      }
      const double rounding = 1e-9 * least + 1e-13 * mesh.boundingDiagonal();
      ASSERT_NEAR(nearest.distance, least, rounding) << "seed " << seed;
      ASSERT_NEAR(there[nearest.label], least, rounding) << "seed " << seed;
    }
  }
}

TEST_P(Metrics, KnowTheStraightLineInASitesFace) {
  const auto mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {{3, {0.2, 0.3, 0.5}}};
  const auto field = inSlices(mesh, sites, GetParam(), 100);
  for (const Eigen::Vector3d& bary :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(0.1, 0.2, 0.7)}) {
    const SurfacePoint p{3, bary};
    const double expected = (mesh.position(p) - mesh.position(sites[0])).norm();
    EXPECT_NEAR(field->distance(0, p), expected, 1e-15);
    EXPECT_NEAR(field->nearest(p).distance, expected, 1e-15);
  }
}

/// A coordinate of -2e-7 once put a site off a vertex, or off an edge, and distances went wrong.
TEST_P(Metrics, TakeCoordinatesThatAreSlightlyOff) {
  const auto mesh = shapes::grid(12, 12, 0.2, 1).mesh();
  const double off = 2e-7;
  for (const Eigen::Vector3d& bary :
       {Eigen::Vector3d(1 + off, -off, 0), Eigen::Vector3d(0.3, 0.7 + off, -off),
        Eigen::Vector3d(0.3, 0.5, 0.2 + off)}) {
    const Eigen::Vector3d clean = bary.cwiseMax(0) / bary.cwiseMax(0).sum();
    for (int face = 0; face < mesh.faceCount(); face += 17) {
      const auto found = inSlices(mesh, {{face, bary}}, GetParam(), 100);
      const auto expected = inSlices(mesh, {{face, clean}}, GetParam(), 100);
      expectSame(mesh, *found, *expected, face);
      const SurfacePoint p{(face + 5) % mesh.faceCount(), bary};
      EXPECT_EQ(found->nearest(p).distance, expected->nearest({p.face, clean}).distance);
      EXPECT_EQ(found->distance(0, p), expected->distance(0, {p.face, clean}));
    }
  }
}

TEST_P(Metrics, WantASite) {
  const auto mesh = shapes::icosphere(1).mesh();
  EXPECT_THROW(propagate(mesh, {}, GetParam()), Error);
}

// --- Bounds along edges --------------------------------------------------------------------------

std::vector<double> boundsOf(const TriangleMesh& mesh, const SiteSet& sites) {
  EdgeBounds bounds(mesh, sites);
  checks::makeRoom(bounds);
  for (int label = 0; label < sites.labelCount(); ++label)
    if (sites.contains(label)) bounds.insert(label);
  long unlimited = std::numeric_limits<long>::max();
  bounds.step(unlimited);
  std::vector<double> all;
  for (int v = 0; v < mesh.vertexCount(); ++v) all.push_back(bounds[v]);
  return all;
}

/// A path may change by one rounding step near a removed site and not at all farther on, where a
/// vertex then kept a bound of the site that was gone.
TEST(EdgeBounds, DoNotDependOnSitesThatAreGone) {
  for (const int seed : {200, 361, 571, 1457, 2298, 3175}) {  // not every sequence shows it
    shapes::Random random(seed);
    shapes::Shape shape = shapes::grid(8, 8);
    for (double& x : shape.positions) x *= 0.7 * (1 + seed % 7);
    const TriangleMesh mesh = shape.mesh();
    SiteSet sites(mesh);
    EdgeBounds bounds(mesh, sites);
    checks::makeRoom(sites, bounds);
    for (int change = 0; change < 60; ++change) {
      const int label = random.below(12);
      if (sites.contains(label)) {
        const SurfacePoint site = sites[label];
        sites.remove(label);
        bounds.remove(label, site);
        for (long budget = 3; !bounds.forget(budget); budget = 3) continue;
      } else {
        const double a = random.below(5) / 8.0, b = random.below(4) / 8.0;
        sites.insert(label, {random.below(mesh.faceCount()), {1 - a - b, a, b}});
        bounds.insert(label);
      }
      long unlimited = std::numeric_limits<long>::max();
      bounds.step(unlimited);
      const std::vector<double> expected = boundsOf(mesh, sites);
      for (int v = 0; v < mesh.vertexCount(); ++v)
        ASSERT_EQ(bounds[v], expected[v]) << "seed " << seed << ", change " << change;
    }
  }
}

/// Where faces are much smaller than elsewhere, each vertex still has its turn once or twice.
TEST(EdgeBounds, TakeAFewTurnsPerVertexOnGradedMeshes) {
  shapes::Shape shape = shapes::grid(100, 100);
  for (double& x : shape.positions) x = x * x * x * x;
  const TriangleMesh mesh = shape.mesh();
  SiteSet sites(mesh);
  EdgeBounds bounds(mesh, sites);
  checks::makeRoom(sites, bounds);
  sites.insert(0, {mesh.faceCount() / 2, {0.2, 0.3, 0.5}});
  bounds.insert(0);
  long budget = 3L * mesh.vertexCount();
  EXPECT_TRUE(bounds.step(budget));
}

/// Windows cross a halfedge in few batches, too, whatever the size of the other faces.
TEST(Windows, CrossInAFewBatchesOnGradedMeshes) {
  shapes::Shape shape = shapes::grid(100, 100, 0.24, 1);
  const int first = shape.vertexCount();
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(1e5, 0, 0), Eigen::Vector3d(2e5, 0, 0), Eigen::Vector3d(1e5, 1e5, 0)})
    shape.addVertex(p);
  shape.addTriangle(first, first + 1, first + 2);
  const TriangleMesh alone = shapes::grid(100, 100, 0.24, 1).mesh(), beside = shape.mesh();
  const auto batches = [](const TriangleMesh& mesh) {
    NearestBounds bounds(mesh);
    SiteSet sites(mesh);
    exact::WindowSweep sweep(mesh, sites, bounds);
    checks::makeRoom(bounds, sites, sweep);
    sites.insert(0, {0, {0.2, 0.3, 0.5}});
    exact::LabelState state;
    sweep.start(0, state);
    const long most = std::numeric_limits<long>::max();
    long budget = most;
    sweep.step(budget);
    return most - budget;
  };
  EXPECT_LT(batches(beside), 2 * batches(alone));
}

/// Bounds that do not help, and memory that runs out after a number of calls.
class ScarceBounds final : public exact::SearchBounds {
 public:
  explicit ScarceBounds(long calls) : left_(calls) {}
  double atLeast(int /*vertex*/) const override {
    if (left_-- == 0) throw std::bad_alloc();
    return 0;
  }
  double atMost(int /*vertex*/) const override { return 1e3; }
  bool isSought(int /*label*/) const override { return true; }

 private:
  mutable long left_;
};

TEST(Windows, LeaveNothingToTheNextSearchWhenMemoryRunsOut) {
  const TriangleMesh mesh = shapes::grid(12, 9, 0.4, 1).mesh();
  SiteSet sites(mesh);
  NearestBounds bounds(mesh);
  checks::makeRoom(sites, bounds);
  sites.insert(0, {mesh.faceCount() / 2, {0.2, 0.3, 0.5}});
  const SurfacePoint p{0, {0.2, 0.3, 0.5}}, farther{mesh.faceCount() - 1, {0.2, 0.3, 0.5}};
  const auto search = [&](exact::WindowSweep& sweep, const SurfacePoint& from, long calls) {
    long budget = kUnlimited;
    const exact::LabelState state = sweep.search(from, ScarceBounds(calls), budget);
    return std::pair(sweep.searched().shortest(), state.vertices.size());
  };
  constexpr long kEnough = 1L << 40;
  exact::WindowSweep fresh(mesh, sites, bounds), used(mesh, sites, bounds);
  for (exact::WindowSweep* sweep : {&fresh, &used}) {
    checks::makeRoom(*sweep);
  }
  const auto expected = search(fresh, farther, kEnough);
  EXPECT_LT(expected.first, 2);
  for (const long calls : {1, 10, 30}) {
    EXPECT_THROW(search(used, p, calls), std::bad_alloc);
    EXPECT_EQ(search(used, farther, kEnough), expected) << "after " << calls << " calls";
  }
}

/// A line to an apex along the end of a window says nothing about the lines beside it: a virtual
/// source may lie on it, and their paths pass beside that.
TEST(Windows, KeepLinesBesideAVirtualSourceOnTheLineToAnApex) {
  const TriangleMesh mesh = shapes::stripBetweenHoles().mesh();
  const std::vector<SurfacePoint> sites = {{36, {0.40600219866918641, 0, 0.59399780133081359}},
                                           {46, {0.75124451605227438, 0, 0.24875548394772562}}};
  const auto field = inSlices(mesh, sites, Metric::kExact, 1L << 40);
  const LabelledPoint near{0, {102, {0.5, 0, 0.5}}}, far{0, {92, {0.5, 0.5, 0}}};
  const std::vector<LabelledPoint> both = {far, near};
  const double expected = lengthOf(mesh, shortestPath(mesh, near.point, sites[0]));
  EXPECT_NEAR(field->distancesAt(both)[1], expected, 1e-12);
}

/// Two points at one distance from a corner of a regular tetrahedron, straight below it in two
/// faces, so that the way between them around the corner is as long, and shorter than over it. It
/// crosses an edge so near to its end that rounding at the other end, a share of the edge's length,
/// must not hide it.
TEST(Windows, FindTheWayAroundACornerThatIsVeryNear) {
  const TriangleMesh mesh = shapes::tetrahedron().mesh();
  const int corner = mesh.tail(0);
  for (const double share : {1e-3, 1e-6, 1e-9, 1e-10}) {
    std::vector<SurfacePoint> points;
    for (const int h : mesh.fan(corner)) {
      points.push_back({TriangleMesh::faceOf(h), Eigen::Vector3d::Constant(share)});
      points.back().bary[h % 3] = 1 - 2 * share;
    }
    const double expected = share * std::sqrt(3) * mesh.length(0);
    const auto field = inSlices(mesh, {points[0]}, Metric::kExact, 1L << 40);
    for (const int other : {1, 2}) {
      EXPECT_NEAR(field->nearest(points[other]).distance, expected, 1e-9 * expected) << share;
      EXPECT_NEAR(lengthOf(mesh, field->path(0, points[other])), expected, 1e-9 * expected);
    }
  }
}

/// In the plane, from a site behind a vertex, on an edge, to points beside the vertices that are
/// straight ahead. So near to a site, rounding leaves a gap between the lines that pass the vertex
/// on its two sides.
TEST(Windows, FindTheWayPastAVertexThatIsVeryNear) {
  const TriangleMesh mesh = shapes::scaled(shapes::grid(3, 3), {4.2, 6.8, 0}).mesh();
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    for (const double share : {1e-8, 1e-10, 1e-12}) {
      SurfacePoint site{TriangleMesh::faceOf(h), Eigen::Vector3d::Zero()};
      site.bary[h % 3] = 1 - share;
      site.bary[cornerAfter(h % 3)] = share;
      mesh.visitNeighbours(mesh.tail(h), [&](int neighbour) {
        for (const int outgoing : mesh.fan(neighbour)) {
          SurfacePoint p{TriangleMesh::faceOf(outgoing), Eigen::Vector3d::Constant(4e-7)};
          p.bary[outgoing % 3] = 1 - 8e-7;
          const double expected = (mesh.position(p) - mesh.position(site)).norm();
          EXPECT_NEAR(lengthOf(mesh, shortestPath(mesh, p, site)), expected, 1e-9 * expected);
        }
      });
    }
}

/// In the plane, from sites on an edge that is 1e-5 of its neighbours, so near to its vertex that
/// the neighbours round the difference away: the line to an apex beyond crosses them within
/// rounding of the vertex, and windows go on along its other side all the same.
TEST(Windows, GoOnBesideAVertexThatIsNearerThanRounding) {
  constexpr double kShort = 1e-5;
  const shapes::Shape grid = shapes::grid(4, 4);
  const TriangleMesh plain = grid.mesh();
  for (int h = 0; h < plain.halfedgeCount(); ++h) {
    const int near = plain.tail(h), moved = plain.tip(h);
    if (plain.onBoundary(near) || plain.onBoundary(moved)) continue;
    shapes::Shape shape = grid;
    shape.setPosition(moved, (1 - kShort) * grid.position(near) + kShort * grid.position(moved));
    const TriangleMesh mesh = shape.mesh();
    for (const double share : {1e-10, 1e-11, 1e-12, 1e-13}) {
      SurfacePoint site{TriangleMesh::faceOf(h), Eigen::Vector3d::Zero()};
      site.bary[h % 3] = 1 - share;
      site.bary[cornerAfter(h % 3)] = share;
      const auto field = inSlices(mesh, {site}, Metric::kExact, 1L << 40);
      for (int v = 0; v < mesh.vertexCount(); ++v)
        EXPECT_NEAR(field->at(v).front().distance, (mesh.position(v) - mesh.position(site)).norm(),
                    1e-14)
            << "halfedge " << h << ", share " << share << ", vertex " << v;
    }
  }
}

// --- Directions ----------------------------------------------------------------------------------

/// In the plane they are known: whether the site lies in a face, on an edge or at a vertex.
TEST_P(Metrics, PointStraightAtVerticesOfThePlane) {
  const auto mesh = shapes::grid(7, 6, 0.2, 3).mesh();
  const auto isInside = [&](const SurfacePoint& p) {
    const Eigen::Vector3d place = mesh.position(p);
    return place.head<2>().minCoeff() > 0 && place.head<2>().maxCoeff() < 1;
  };
  int checked = 0;
  for (int face = 0; face < mesh.faceCount(); ++face) {
    for (const Eigen::Vector3d& bary :
         {Eigen::Vector3d(0.2, 0.3, 0.5), Eigen::Vector3d(0, 0.25, 0.75),
          Eigen::Vector3d(0.25, 0, 0.75), Eigen::Vector3d(0.25, 0.75, 0), Eigen::Vector3d(0, 1, 0),
          Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
      const SurfacePoint site{face, bary};
      if (!isInside(site)) continue;
      const auto field = inSlices(mesh, {site}, GetParam(), 1L << 40);
      const Eigen::Vector2d x =
          (mesh.position(mesh.tip(3 * face)) - mesh.position(mesh.tail(3 * face))).head<2>();
      const Eigen::Vector2d axis = x.normalized();
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Vector2d way = (mesh.position(v) - mesh.position(site)).head<2>();
        if (way.norm() < 1e-9) continue;
        const Eigen::Vector2d d = field->direction(0, v);
        const Eigen::Vector2d inPlane(axis.x() * d.x() - axis.y() * d.y(),
                                      axis.y() * d.x() + axis.x() * d.y());
        // An unfolded source that lies on the line of an edge is known to the root of rounding
        // only.
        EXPECT_LT((inPlane - way.normalized()).norm(), GetParam() == Metric::kDgpc ? 1e-8 : 1e-9)
            << "site in face " << face << " at " << bary.transpose() << ", vertex " << v;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

/// How the distance to a vertex changes as a site moves; not a number where it has a kink, for
/// there two shortest paths leave the site.
Eigen::Vector2d derivative(const TriangleMesh& mesh, const SurfacePoint& site, int vertex,
                           double step) {
  const auto distanceFrom = [&](const Eigen::Vector2d& move) {
    const auto moved = walkStraight(mesh, site, move).end;
    const auto field = inSlices(mesh, {moved}, Metric::kExact, 1L << 40);
    return field->at(vertex)[0].distance;
  };
  const double here = distanceFrom({0, 0});
  Eigen::Vector2d result;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d move = step * Eigen::Vector2d::Unit(axis);
    const double ahead = distanceFrom(move) - here, behind = here - distanceFrom(-move);
    result[axis] = std::abs(ahead - behind) < 1e-3 * step
                       ? (ahead + behind) / (2 * step)
                       : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

/// Saddles, an inner corner, a boundary with holes and a closed surface of genus 1: paths bend.
TEST(ExactDirections, AreWhatMovingTheSiteTakesOffTheDistance) {
  const std::vector<TriangleMesh> meshes = {
      shapes::vertexFan(8, 8).mesh(),
      shapes::ell(3).mesh(),
      shapes::bumpySurface(1, 1, 0.3, 2).mesh(),
      shapes::withoutRandomFaces(shapes::bumpySurface(0, 2, 0.4, 5), 6, 5).mesh(),
      shapes::torus(9, 6).mesh(),
  };
  int checked = 0, kinks = 0;
  for (const TriangleMesh& mesh : meshes) {
    for (const SurfacePoint& site : sampleUniform(mesh, 3, 4)) {
      const auto field = inSlices(mesh, {site}, Metric::kExact, 1L << 40);
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (field->at(v).empty()) continue;
        const double distance = field->at(v)[0].distance;
        const Eigen::Vector2d d = field->direction(0, v);
        EXPECT_NEAR(d.norm(), 1, 1e-14);
        const Eigen::Vector2d expected = -derivative(mesh, site, v, 1e-6);
        if (!expected.allFinite()) {
          ++kinks;
          continue;
        }
        // The second derivative is 1 / distance.
        EXPECT_LT((d - expected).norm(), 1e-8 + 1e-6 / distance) << "vertex " << v;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 300);
  EXPECT_LT(kinks, checked / 50);
}

/// Several sites at once, each direction that of the site alone.
TEST(ExactDirections, DoNotDependOnOtherSites) {
  const auto mesh = shapes::bumpySurface(2, 2, 0.3, 1).mesh();
  const auto sites = sampleUniform(mesh, 12, 3);
  const auto field = inSlices(mesh, sites, Metric::kExact, 1000);
  for (int label = 0; label < 12; ++label) {
    const auto alone = inSlices(mesh, {sites[label]}, Metric::kExact, 1000);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const auto known = field->at(v);
      const bool isKnown =
          std::any_of(known.begin(), known.end(), [&](const auto& d) { return d.label == label; });
      const Eigen::Vector2d d = field->direction(label, v);
      EXPECT_EQ(d.allFinite(), isKnown);
      if (isKnown) {
        EXPECT_LT((d - alone->direction(0, v)).norm(), 1e-9) << label << ' ' << v;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Metrics, ::testing::Values(Metric::kDgpc, Metric::kExact),
                         [](const auto& info) {
                           return info.param == Metric::kDgpc ? "Dgpc" : "Exact";
                         });

}  // namespace
}  // namespace gvd
