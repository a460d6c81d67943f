// SPDX-License-Identifier: MIT
#include "gvd/dual.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagram_checks.h"
#include "equality.h"
#include "error_checks.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
#include "gvd/sampling.h"
#include "shapes.h"
#include "surface_checks.h"

namespace gvd {
namespace {

using checks::errorOf;
using checks::PolygonSurface;
using checks::trace;
using Eigen::Vector3d;
using shapes::centroid;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/// Whether polygons make an oriented manifold of the mesh's topology, by an independent count.
AssertionResult hasTheTopologyOf(const TriangleMesh& mesh, const PolygonMesh& polygons) {
  PolygonSurface surface;
  for (int f = 0; f < polygons.faces.size(); ++f) surface.add(polygons.faces[f]);
  const MeshTopology& expected = mesh.topology();
  const PolygonTopology told = topologyOf(polygons);
  if (!surface.isManifold() || !told.isManifold) return AssertionFailure() << "no manifold";
  if (surface.eulerCharacteristic() != expected.eulerCharacteristic ||
      surface.boundaryLoops() != expected.boundaryLoops ||
      surface.components() != expected.components || surface.genus() != expected.genus)
    return AssertionFailure() << "Euler characteristic " << surface.eulerCharacteristic() << " for "
                              << expected.eulerCharacteristic << ", " << surface.boundaryLoops()
                              << " boundary loops for " << expected.boundaryLoops << ", genus "
                              << surface.genus() << " for " << expected.genus;
  if (told.eulerCharacteristic != expected.eulerCharacteristic ||
      told.boundaryLoops != expected.boundaryLoops || told.components != expected.components ||
      told.genus != expected.genus)
    return AssertionFailure() << "topologyOf says otherwise";
  return AssertionSuccess();
}

/// The least of the rotations of a list.
std::vector<int> canonical(std::vector<int> cycle) {
  std::vector<int> least = cycle;
  for (size_t i = 0; i < cycle.size(); ++i) {
    std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
    least = std::min(least, cycle);
  }
  return least;
}

/// Whether the polygons of three or more sites are the diagram's Voronoi points, in the same turn.
AssertionResult hasTheVoronoiPoints(const Diagram& d, const PolygonMesh& dual) {
  std::multiset<std::vector<int>> expected, found;
  for (const auto& v : d.voronoiPoints) expected.insert(canonical(v.labels));
  for (int f = 0; f < dual.faces.size(); ++f) {
    std::vector<int> labels;
    for (const int v : dual.faces[f])
      if (v < d.siteCount) labels.push_back(v);
    if (std::set<int>(labels.begin(), labels.end()).size() >= 3) found.insert(canonical(labels));
  }
  if (found != expected)
    return AssertionFailure() << found.size() << " polygons for " << expected.size()
                              << " Voronoi points";
  return AssertionSuccess();
}

std::set<Violation::Kind> kinds(const std::vector<Violation>& violations) {
  std::set<Violation::Kind> result;
  for (const Violation& v : violations) {
    result.insert(v.kind);
    EXPECT_FALSE(v.message.empty());
    EXPECT_TRUE(std::is_sorted(v.labels.begin(), v.labels.end()));
  }
  return result;
}

class DualOfRandomMeshes : public ::testing::TestWithParam<int> {};

TEST_P(DualOfRandomMeshes, IsTheSurfaceUnlessItSaysWhyNot) {
  const auto mesh = shapes::randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, shapes::randomSiteCount(mesh, GetParam()), GetParam());
  const Diagram d = trace(mesh, sites).diagram;
  const PolygonMesh dual = dualMesh(mesh, sites, d);
  EXPECT_TRUE(hasTheVoronoiPoints(d, dual));
  const auto found = kinds(findViolations(mesh, sites, d));
  EXPECT_FALSE(found.contains(Violation::kNoManifold));
  if (!found.empty()) return;
  EXPECT_TRUE(hasTheTopologyOf(mesh, dual));
  const PolygonMesh regions = regionMesh(mesh, d);
  EXPECT_EQ(regions.faces.size(), d.siteCount);
  EXPECT_TRUE(hasTheTopologyOf(mesh, regions));
}

TEST_P(DualOfRandomMeshes, HasPathsAcrossItsArcs) {
  const auto mesh = shapes::randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, shapes::randomSiteCount(mesh, GetParam()), GetParam());
  const auto [field, d] = trace(mesh, sites);
  const auto paths = dualPaths(mesh, d, *field);
  ASSERT_EQ(paths.size(), d.arcLabels.size());
  for (size_t arc = 0; arc < paths.size(); ++arc) {
    const auto& [labels, points] = paths[arc];
    EXPECT_EQ(labels, d.arcLabels[arc]);
    ASSERT_GE(points.size(), 2u);
    for (const auto& [label, end] :
         {std::pair(labels[0], points.front()), {labels[1], points.back()}})
      EXPECT_LT((mesh.position(end) - mesh.position(sites[label])).norm(), 1e-12);
    // No longer than the way over any point of the arc.
    const double length = lengthOf(mesh, points);
    double least = kInfinity;
    for (const int p : d.arcs[static_cast<int>(arc)])
      least = std::min(
          least, field->distance(labels[0], d.points[p]) + field->distance(labels[1], d.points[p]));
    EXPECT_LE(length, least * (1 + 1e-9));
    EXPECT_GT(length, 0);
  }
}

/// With `detail`, the label of a region inside a face is known at none of its corners: neither
/// where it is the nearest (arcs 24 and 25 of the first torus) nor where straight bisectors show
/// it, and another one is nearer (arc 2 of the second).
TEST(Dual, HasAPathAcrossEveryArcOfADetailedDiagram) {
  const auto mesh = shapes::torus(6, 6).mesh();
  for (const auto& [seed, detail] : {std::pair(53, 2), {11, 1}}) {
    const auto sites = sampleUniform(mesh, 8, seed);
    const auto [field, diagram] = trace(mesh, sites, Metric::kExact, detail);
    for (const DualPath& path : dualPaths(mesh, diagram, *field)) {
      EXPECT_GE(path.points.size(), 2u) << "seed " << seed;
      EXPECT_LT(lengthOf(mesh, path.points), 4) << "seed " << seed;
    }
  }
}

TEST_P(DualOfRandomMeshes, IsTheSurfaceAfterRepair) {
  const auto mesh = shapes::randomMesh(GetParam());
  const auto sites = sampleFarthest(mesh, 1 + GetParam() % 12, GetParam());
  // On coarse curved meshes straight bisectors may show a region in several parts, however many
  // sites are added.
  constexpr int kCoarse = 150, kMostAdded = 150;
  RepairedSites repaired;
  try {
    repaired = repair(mesh, sites, Metric::kExact, {.maxAdded = kMostAdded});
  } catch (const Error& error) {
    EXPECT_LT(mesh.faceCount(), kCoarse) << error.what();
    return;
  }
  EXPECT_TRUE(findViolations(mesh, repaired.sites, repaired.diagram).empty());
  EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
  EXPECT_TRUE(hasTheTopologyOf(mesh, regionMesh(mesh, repaired.diagram)));
  EXPECT_EQ(repaired.sites.size(), sites.size() + repaired.added);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DualOfRandomMeshes, ::testing::Range(0, 48));

TEST(Dual, OfThirtySitesHasTheGenusOfTheSurface) {
  struct Case {
    const char* name;
    TriangleMesh mesh;
  };
  const Case cases[] = {
      {"sphere", shapes::icosphere(4).mesh()},
      {"torus", shapes::torus(48, 24).mesh()},
      {"thin torus", shapes::torus(96, 12, 1, 0.1).mesh()},
      {"genus 2", shapes::bumpySurface(2, 4, 0.1, 1).mesh()},
      {"genus 3", shapes::bumpySurface(3, 4, 0.1, 1).mesh()},
      {"plate of genus 3", shapes::perforatedPlate(3, 4).mesh()},
      {"square", shapes::grid(24, 24, 0.2, 1).mesh()},
      {"annulus", shapes::annulus(48, 8).mesh()},
      {"cylinder", shapes::cylinder(36, 18).mesh()},
      {"torn torus", shapes::withoutRandomFaces(shapes::torus(48, 24), 12, 1).mesh()}};
  for (const Case& c : cases) {
    for (const bool farthest : {true, false}) {
      const auto sites = farthest ? sampleFarthest(c.mesh, 30, 1) : sampleUniform(c.mesh, 30, 1);
      const RepairedSites repaired = repair(c.mesh, sites, Metric::kExact);
      EXPECT_TRUE(hasTheTopologyOf(c.mesh, dualMesh(c.mesh, repaired.sites, repaired.diagram)))
          << c.name;
    }
  }
}

TEST(Dual, OfTheSidesOfACubeIsAnOctahedron) {
  const auto mesh = shapes::cube().mesh();
  const auto sites = shapes::middlesOfSides(mesh);
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_TRUE(findViolations(mesh, sites, d).empty());
  const PolygonTopology dual = topologyOf(dualMesh(mesh, sites, d));
  EXPECT_TRUE(dual.isManifold);
  EXPECT_EQ(dual.vertices, 6);
  EXPECT_EQ(dual.edges, 12);
  EXPECT_EQ(dual.faces, 8);
  const PolygonMesh regions = regionMesh(mesh, d);
  const PolygonTopology primal = topologyOf(regions);
  EXPECT_TRUE(primal.isManifold);
  EXPECT_EQ(primal.vertices, 8);
  EXPECT_EQ(primal.edges, 12);
  EXPECT_EQ(primal.faces, 6);
  for (int f = 0; f < regions.faces.size(); ++f) {
    // Counterclockwise from outside, around the region's site.
    Vector3d normal = Vector3d::Zero();
    const auto face = regions.faces[f];
    for (size_t i = 0; i < face.size(); ++i)
      normal += regions.positions[face[i]].cross(regions.positions[face[(i + 1) % face.size()]]);
    const Vector3d out = mesh.position(sites[regions.faceLabel[f]]) - Vector3d::Constant(0.5);
    EXPECT_NEAR(normal.normalized().dot(out.normalized()), 1, 1e-9);
  }
}

TEST(Dual, OfFourQuartersOfASquareReachesItsBoundary) {
  const auto mesh = shapes::grid(4, 4).mesh();
  std::vector<SurfacePoint> sites;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3d p = mesh.position(v);
    if ((p[0] == 0.25 || p[0] == 0.75) && (p[1] == 0.25 || p[1] == 0.75)) {
      const int h = mesh.outgoing(v);
      sites.push_back({h / 3, Vector3d::Unit(h % 3)});
    }
  }
  ASSERT_EQ(sites.size(), 4u);
  const Diagram d = trace(mesh, sites).diagram;
  EXPECT_TRUE(findViolations(mesh, sites, d).empty());
  const PolygonMesh dual = dualMesh(mesh, sites, d);
  EXPECT_TRUE(hasTheTopologyOf(mesh, dual));
  EXPECT_EQ(dual.points.size(), 8u);
  EXPECT_EQ(dual.faces.size(), 5);
  for (int f = 0; f < dual.faces.size(); ++f) EXPECT_EQ(dual.faces[f].size(), 4u);
  // Each region's run goes around a corner of the square.
  for (int v = 4; v < 8; ++v) {
    const Vector3d p = dual.positions[v], site = dual.positions[dual.vertexLabel[v]];
    EXPECT_NEAR(p[0], site[0] < 0.5 ? 0 : 1, 1e-9);
    EXPECT_NEAR(p[1], site[1] < 0.5 ? 0 : 1, 1e-9);
  }
}

/// Corners of the boundary were cut off, because every run had its vertex in its middle.
TEST(Dual, HasTheCornersOfTheBoundary) {
  const auto mesh = shapes::grid(8, 8).mesh();
  const auto sites = sampleUniform(mesh, 20, 1);
  const PolygonMesh dual = dualMesh(mesh, sites, trace(mesh, sites).diagram);
  for (const Vector3d& corner : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 1, 0)})
    EXPECT_EQ(std::ranges::count(dual.positions, corner), 1);
}

/// With a vertex at one of two corners, the triangles beside it would be turned over.
TEST(Dual, HasTheMiddleOfARunWithTwoCorners) {
  shapes::Shape shape = shapes::grid(6, 2);
  for (size_t i = 0; i < shape.positions.size(); i += 3) shape.positions[i] *= 6;
  const auto mesh = shape.mesh();
  std::vector<SurfacePoint> sites;
  for (int v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.position(v)[1] == 0.5 && std::lround(mesh.position(v)[0]) % 2 == 1)
      sites.push_back({mesh.outgoing(v) / 3, Vector3d::Unit(mesh.outgoing(v) % 3)});
  ASSERT_EQ(sites.size(), 3u);
  const PolygonMesh dual = dualMesh(mesh, sites, trace(mesh, sites).diagram);
  EXPECT_EQ(std::ranges::count(dual.positions, Vector3d(0, 0.5, 0)), 1);
}

TEST(Violations, NameWhatIsWrongWithFewSites) {
  const auto sphere = shapes::icosphere(2).mesh();
  const auto kindsFor = [](const TriangleMesh& mesh, int count) {
    const auto sites = sampleFarthest(mesh, count, 1);
    return kinds(findViolations(mesh, sites, trace(mesh, sites).diagram));
  };
  using Kinds = std::set<Violation::Kind>;
  EXPECT_EQ(kindsFor(sphere, 1), Kinds({Violation::kNoDisk}));
  EXPECT_EQ(kindsFor(sphere, 2), Kinds({Violation::kClosedBorder}));
  EXPECT_EQ(kindsFor(sphere, 3), Kinds({Violation::kThreeMeetTwice}));
  EXPECT_EQ(kindsFor(sphere, 12), Kinds());
  EXPECT_EQ(kindsFor(shapes::torus(24, 12).mesh(), 1), Kinds({Violation::kNoDisk}));
  EXPECT_EQ(kindsFor(shapes::cylinder(12, 6).mesh(), 1),
            Kinds({Violation::kNoDisk, Violation::kFewRuns}));
  EXPECT_EQ(kindsFor(shapes::grid(4, 4).mesh(), 1), Kinds({Violation::kFewRuns}));
}

TEST(Violations, NameTheRegions) {
  const auto mesh = shapes::icosphere(1).mesh();
  const std::vector<SurfacePoint> sites = {centroid(40), centroid(7), centroid(7)};
  const auto violations = findViolations(mesh, sites, trace(mesh, sites).diagram);
  ASSERT_FALSE(violations.empty());
  EXPECT_EQ(violations[0].kind, Violation::kNoRegion);
  EXPECT_EQ(violations[0].labels, std::vector<int>({2}));
  EXPECT_EQ(violations[0].message, "site 2 has no region: another site is at its place");
  const std::vector<SurfacePoint> two = {centroid(40), centroid(7)};
  const auto closed = findViolations(mesh, two, trace(mesh, two).diagram);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].message, "regions 0 and 1 meet along a closed curve");
}

TEST(Dual, LeavesOutLabelsWithoutSite) {
  const auto mesh = shapes::icosphere(2).mesh();
  DynamicDiagram dynamic(mesh, sampleFarthest(mesh, 14, 1));
  dynamic.removeSite(3);
  dynamic.removeSite(0);
  const auto all = dynamic.sites();
  ASSERT_EQ(all.size(), 14u);
  std::vector<SurfacePoint> left;
  std::vector<int> labels;
  for (int label = 0; label < 14; ++label) {
    if (all[label].face < 0) continue;
    left.push_back(all[label]);
    labels.push_back(label);
  }
  EXPECT_EQ(labels, std::vector<int>({1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}));
  EXPECT_TRUE(findViolations(mesh, all, dynamic.diagram()).empty());

  const PolygonMesh dual = dualMesh(mesh, all, dynamic.diagram());
  EXPECT_EQ(dual.vertexLabel, labels);
  EXPECT_TRUE(hasTheTopologyOf(mesh, dual));
  // Labels without a site may be given, too: the diagram is that of the others, by their labels.
  for (const Metric metric : {Metric::kExact, Metric::kDgpc}) {
    const Diagram d = trace(mesh, all, metric).diagram, few = trace(mesh, left, metric).diagram;
    EXPECT_EQ(d.siteCount, 14);
    EXPECT_EQ(d.regionArea[3], 0);
    for (size_t i = 0; i < labels.size(); ++i)
      EXPECT_EQ(d.regionArea[labels[i]], few.regionArea[i]);
    const PolygonMesh a = dualMesh(mesh, all, d), b = dualMesh(mesh, left, few);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.faces.points, b.faces.points);
  }
  EXPECT_EQ(repair(mesh, all, Metric::kExact).added, 0);
  EXPECT_THROW(trace(mesh, std::vector<SurfacePoint>(2)), Error);
}

TEST(Dual, RefusesOtherSitesThanTheDiagrams) {
  const auto mesh = shapes::icosphere(2).mesh();
  const auto sites = sampleFarthest(mesh, 14, 1);
  const Diagram diagram = trace(mesh, sites).diagram;
  const std::vector<SurfacePoint> few(sites.begin(), sites.end() - 1);
  std::vector<SurfacePoint> elsewhere = sites;
  elsewhere[3].face = mesh.faceCount();
  std::vector<SurfacePoint> missing = sites;
  missing[3] = {};
  for (const auto& others : {few, elsewhere, missing}) {
    EXPECT_THROW(dualMesh(mesh, others, diagram), Error);
    EXPECT_THROW(findViolations(mesh, others, diagram), Error);
  }
}

/// Each of these read beyond the end of an array.
TEST(Dual, NothingIsMadeOfTheDiagramOrDistancesOfAnotherMesh) {
  const auto mesh = shapes::icosphere(1).mesh(), other = shapes::icosphere(2).mesh();
  const auto sites = sampleFarthest(mesh, 6, 1);
  const auto [field, diagram] = trace(mesh, sites);
  EXPECT_THROW(traceDiagram(other, *field, 6), Error);
  for (const Diagram& wrong : {diagram, Diagram()}) {
    EXPECT_THROW(partition(other, wrong), Error);
    EXPECT_THROW(regionMesh(other, wrong), Error);
    EXPECT_THROW(dualMesh(other, sites, wrong), Error);
    EXPECT_THROW(findViolations(other, sites, wrong), Error);
    EXPECT_THROW(repairingSites(other, sites, wrong, *field), Error);
    EXPECT_THROW(dualPaths(other, wrong, *field), Error);
    EXPECT_THROW(WorstRegions(other, *field, wrong, WorstRegion::kSize), Error);
  }
  const Diagram own = trace(other, sites).diagram;
  EXPECT_THROW(repairingSites(other, sites, own, *field), Error);
  EXPECT_THROW(dualPaths(other, own, *field), Error);
  EXPECT_THROW(WorstRegions(other, *field, own, WorstRegion::kSize), Error);
}

TEST(Dual, HasItsSitesWithCleanCoordinates) {
  const auto mesh = shapes::icosphere(2).mesh();
  auto sites = sampleFarthest(mesh, 14, 1);
  sites[3].bary *= 1 + 9e-7;
  const PolygonMesh dual = dualMesh(mesh, sites, trace(mesh, sites).diagram);
  for (const SurfacePoint& p : dual.points) EXPECT_NEAR(p.bary.sum(), 1, 1e-12);
}

/// Distances that may be asked for in steps only.
class InStepsOnly final : public checks::SameDistances {
 public:
  using SameDistances::SameDistances;
  LabelledDistance nearest(const SurfacePoint& p, long& budget) const override {
    ADD_FAILURE() << "asks for the distance at one point";
    return SameDistances::nearest(p, budget);
  }
  double distance(int label, const SurfacePoint& p) const override {
    ADD_FAILURE() << "asks for the distance at one point";
    return SameDistances::distance(label, p);
  }
};

/// On a narrow tube of long faces, the distances at 25,000 points were asked for one by one, in one
/// step of 8 seconds.
TEST(Repair, AsksForDistancesInSteps) {
  const auto mesh = shapes::cylinder(60, 1, 0.01, 10).mesh();
  const auto sites = sampleUniform(mesh, 20, 1);
  const checks::Traced traced = trace(mesh, sites);
  const InStepsOnly field(*traced.field);
  const auto added = repairingSites(mesh, sites, traced.diagram, field);
  ASSERT_FALSE(added.empty());
  // Each is in a region that shows a violation, well away from the sites.
  for (const SurfacePoint& p : added) EXPECT_GT(traced.field->nearest(p).distance, 0.01);
}

/// Triangles of the dual had no area where sites were added on the boundary itself.
TEST(Repair, AddsNoSitesOnTheBoundary) {
  const auto mesh = shapes::cylinder(24, 1, 1, 4).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  const RepairedSites repaired = repair(mesh, sites, Metric::kExact);
  ASSERT_GT(repaired.added, 2);
  for (const SurfacePoint& site : repaired.sites) EXPECT_GT(site.bary.minCoeff(), 1e-3);
  const PolygonMesh dual = dualMesh(mesh, repaired.sites, repaired.diagram);
  EXPECT_GT(measureQuality(mesh, dual).minAngle, 1);
}

TEST(Repair, RefusesANegativeNumberOfSites) {
  const auto mesh = shapes::icosphere(2).mesh();
  EXPECT_THROW(repair(mesh, sampleFarthest(mesh, 12, 1), Metric::kExact, {.maxAdded = -1}), Error);
}

TEST(Repair, AddsSitesToLabelsWithoutOneFirst) {
  const auto mesh = shapes::torus(24, 12).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0), {}, centroid(100), {}};
  const RepairedSites repaired = repair(mesh, sites, Metric::kExact);
  EXPECT_EQ(repaired.sites[0].face, 0);
  EXPECT_EQ(repaired.sites[2].face, 100);
  EXPECT_GT(repaired.added, 2);
  EXPECT_EQ(repaired.sites.size(), 2u + repaired.added);
  EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
}

TEST(Repair, PutsSitesOnEveryComponent) {
  const auto one = shapes::icosphere(2);
  const auto mesh = shapes::joined(shapes::joined(one, shapes::moved(one, Vector3d(5, 0, 0))),
                                   shapes::moved(one, Vector3d(0, 5, 0)))
                        .mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  EXPECT_TRUE(kinds(findViolations(mesh, sites, trace(mesh, sites).diagram))
                  .contains(Violation::kUnreachable));
  const RepairedSites repaired = repair(mesh, sites, Metric::kExact);
  EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
}

TEST(Repair, AddsNothingToWhatIsValid) {
  const auto mesh = shapes::icosphere(2).mesh();
  const auto sites = sampleFarthest(mesh, 12, 1);
  EXPECT_EQ(repair(mesh, sites, Metric::kExact).added, 0);
}

TEST(Repair, SaysWhatIsLeftWhereItMayNotAddMore) {
  const auto mesh = shapes::torus(24, 12).mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  const std::string error = errorOf([&] { repair(mesh, sites, Metric::kExact, {.maxAdded = 1}); },
                                    ErrorCode::kTooFewSites);
  EXPECT_NE(error.find("may be added, perhaps because triangles are too long: region"),
            std::string::npos)
      << error;
  const std::vector<SurfacePoint> twice = {centroid(0), centroid(0)};
  EXPECT_THROW(repair(mesh, twice, Metric::kExact), Error);
}

/// A triangle on one edge of a cube, or of a plane, which is cut there. Both sides of the cut have
/// the same ends, so a diagram took a site on one side to be on the other, too: regions had a
/// second part across the cut, and however many sites were added, the dual was not valid.
TEST(Repair, AddsSitesAlongAnEdgeThatIsCut) {
  shapes::Shape cube = shapes::cube(), plane = shapes::grid(10, 10);
  cube.addTriangle(cube.triangles[0], cube.triangles[1], cube.addVertex({9, 9, 9}));
  plane.addTriangle(60, 61, plane.addVertex({0.5, 0.5, 0.1}));
  for (const shapes::Shape& shape : {cube, plane}) {
    const auto mesh = shape.mesh({.minComponent = 2});
    ASSERT_EQ(mesh.repairs().nonManifoldEdges, 1);
    ASSERT_EQ(mesh.topology().components, 1);
    for (const Metric metric : {Metric::kExact, Metric::kDgpc})
      for (const int detail : {0, 1, 3}) {
        const auto sites = sampleUniform(mesh, 20, 1);
        const RepairedSites repaired = repair(mesh, sites, metric, {.diagram = {.detail = detail}});
        EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
        for (const RegionPatch& region : partition(mesh, repaired.diagram).regions)
          EXPECT_EQ(region.components, 1);
      }
  }
}

/// Around the tips of spikes, sites were added ever nearer to the tip, until 1000 did not suffice
/// or two came to one place.
TEST(Repair, SurroundsTheTipsOfSpikes) {
  shapes::Shape shape = shapes::icosphere(2);
  for (int v = 0; v < 12; ++v) shape.setPosition(v, 4 * shape.position(v));
  const auto mesh = shape.mesh();
  for (const auto& sites : {sampleUniform(mesh, 20, 1), sampleFarthest(mesh, 20, 1)}) {
    const RepairedSites repaired = repair(mesh, sites, Metric::kExact, {.maxAdded = 100});
    EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
  }
}

/// An open cone, longer on one side: the mesh ends before a place across from the far site.
TEST(Repair, SurroundsATipNearTheBoundary) {
  shapes::Shape shape = shapes::vertexFan(6, 0.3);
  shape.setPosition(1, shape.position(0) + 3 * (shape.position(1) - shape.position(0)));
  const auto mesh = shape.mesh();
  const std::vector<SurfacePoint> sites = {{0, {1, 0, 0}}, {0, {0.2, 0.79, 0.01}}};
  const RepairedSites repaired = repair(mesh, sites, Metric::kExact, {.maxAdded = 100});
  EXPECT_TRUE(hasTheTopologyOf(mesh, dualMesh(mesh, repaired.sites, repaired.diagram)));
  for (const SurfacePoint& site : repaired.sites)
    EXPECT_GT(site.bary[0], 1e-3);  // on the rim, it is zero
}

/// The only triangle's middle is where the first site is.
TEST(Repair, AddsSitesToOneTriangle) {
  const auto mesh = shapes::triangle().mesh();
  const std::vector<SurfacePoint> sites = {centroid(0)};
  EXPECT_EQ(repair(mesh, sites, Metric::kExact).added, 2);
}

TEST(Repair, GivesTheSameSitesEveryTime) {
  const auto mesh = shapes::bumpySurface(2, 2, 0.3, 4).mesh();
  const auto sites = sampleUniform(mesh, 6, 4);
  const auto a = repair(mesh, sites, Metric::kExact), b = repair(mesh, sites, Metric::kExact);
  EXPECT_EQ(a.sites, b.sites);
}

TEST(PolygonTopology, KnowsWhatIsNoManifold) {
  const auto topology = [](int vertices, const std::vector<std::vector<int>>& faces) {
    PolygonMesh mesh;
    mesh.positions.resize(vertices);
    for (const auto& face : faces) mesh.faces.add(face);
    return topologyOf(mesh);
  };
  EXPECT_TRUE(topology(4, {{0, 1, 2, 3}}).isManifold);
  EXPECT_EQ(topology(4, {{0, 1, 2, 3}}).boundaryLoops, 1);
  EXPECT_TRUE(topology(4, {{0, 1, 2}, {0, 2, 3}}).isManifold);
  EXPECT_FALSE(topology(4, {{0, 1, 2}, {0, 1, 3}}).isManifold) << "a side twice";
  EXPECT_FALSE(topology(5, {{0, 1, 2}, {0, 3, 4}}).isManifold) << "two fans";
  EXPECT_FALSE(topology(3, {{0, 1, 0, 2}}).isManifold) << "a corner twice";
  EXPECT_EQ(topology(6, {{0, 1, 2}, {3, 4, 5}}).components, 2);
  EXPECT_EQ(topology(9, {{0, 1, 2}}).vertices, 3);
  EXPECT_EQ(topology(3, {{0, 1, 2}, {}}).eulerCharacteristic, 1) << "a face without corners";
}

}  // namespace
}  // namespace gvd
