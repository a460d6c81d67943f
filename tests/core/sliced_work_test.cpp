// SPDX-License-Identifier: MIT
//
// What is made in steps is what is made at once, however small the steps are.
#include "gvd/sliced_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "diagram_checks.h"
#include "distance/bounds_lowering.h"
#include "distance/edge_bounds.h"
#include "distance/label_change.h"
#include "distance/label_turns.h"
#include "distance/nearest_bounds.h"
#include "distance/reached_loop.h"
#include "distance/reaching_labels.h"
#include "distance/site_distances.h"
#include "distance/site_set.h"
#include "equality.h"
#include "gvd/closest_point.h"
#include "gvd/curvature.h"
#include "gvd/cvt.h"
#include "gvd/dual.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
#include "gvd/sampling.h"
#include "gvd/subdivision.h"
#include "in_steps.h"
#include "shapes.h"
#include "wild_mesh.h"

namespace gvd {
namespace {

using checks::inSteps;

bool operator==(const MeshRepairs& a, const MeshRepairs& b) {
  const auto all = [](const MeshRepairs& r) {
    return std::vector<double>{1.0 * r.weldedVertices,      1.0 * r.joinedVertices,
                               1.0 * r.isolatedVertices,    1.0 * r.nonFiniteTriangles,
                               1.0 * r.degenerateTriangles, 1.0 * r.duplicateTriangles,
                               1.0 * r.nonManifoldEdges,    1.0 * r.orientationCuts,
                               1.0 * r.flippedTriangles,    1.0 * r.smallComponents,
                               1.0 * r.splitVertices,       1.0 * r.smallComponentTriangles,
                               1.0 * r.mollifiedTriangles,  r.mollification};
  };
  return all(a) == all(b);
}

void expectSame(const TriangleMesh& a, const TriangleMesh& b, const shapes::Shape& shape) {
  ASSERT_EQ(a.faceCount(), b.faceCount());
  EXPECT_TRUE(std::ranges::equal(a.boundaryLoops(), b.boundaryLoops()));
  EXPECT_TRUE(a.repairs() == b.repairs());
  EXPECT_EQ(a.area(), b.area());
  EXPECT_EQ(a.meanEdgeLength(), b.meanEdgeLength());
  EXPECT_EQ(a.topology().genus, b.topology().genus);
  for (int h = 0; h < a.halfedgeCount(); ++h) {
    EXPECT_EQ(a.tail(h), b.tail(h));
    EXPECT_EQ(a.twin(h), b.twin(h));
    EXPECT_EQ(a.length(h), b.length(h));
  }
  for (int v = 0; v < a.vertexCount(); ++v) {
    EXPECT_EQ(a.position(v), b.position(v));
    EXPECT_EQ(a.position(v), shape.position(a.inputVertex(v)));
    EXPECT_EQ(a.angleSum(v), b.angleSum(v));
  }
  for (int f = 0; f < a.faceCount(); ++f) {
    EXPECT_EQ(a.component(f), b.component(f));
    EXPECT_EQ(a.inputFace(f), b.inputFace(f));
    EXPECT_EQ(a.isFlipped(f), b.isFlipped(f));
  }
}

std::string errorOf(const std::function<void()>& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Distances that were taken too early looked like those of sites that reach nothing.
TEST(SlicedWork, ResultsAreTakenOnceAndAtTheEnd) {
  const TriangleMesh mesh = shapes::cube().mesh();
  const std::vector<SurfacePoint> sites = {mesh.fromInputVertex(0)};
  EXPECT_THROW(propagate(mesh, sites, Metric::kExact)->take(), Error);
  EXPECT_THROW(startMesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2})->take(), Error);
  const auto propagation = propagate(mesh, sites, Metric::kExact);
  while (!propagation->step(1)) EXPECT_THROW(propagation->take(), Error);
  EXPECT_NE(propagation->take(), nullptr);
  EXPECT_TRUE(propagation->step(1));
  EXPECT_THROW(propagation->take(), Error);
}

/// A loop with such a budget never ended.
TEST(SlicedWork, GoesOnWithoutBudget) {
  const TriangleMesh mesh = shapes::cube().mesh();
  const std::vector<SurfacePoint> sites = {mesh.fromInputVertex(0)};
  const auto propagation = propagate(mesh, sites, Metric::kExact);
  Cvt cvt(mesh, sites);
  bool isDone = false, isEvaluated = false;
  for (int i = 0; i < 1000; ++i) {
    isDone = propagation->step(-1);
    isEvaluated = isEvaluated || cvt.step(0);
  }
  EXPECT_TRUE(isDone);
  EXPECT_TRUE(isEvaluated);
}

/// Distances that are known wherever they are required: no label ever has to spread.
class KnownEverywhere final : public LabelSpread {
 public:
  /// Every label has reached so many vertices.
  explicit KnownEverywhere(int reached = 0) {
    for (int v = 0; v < reached; ++v) reached_.push_back({v, true, 1.0 * v});
  }
  bool prepare(long& /*budget*/) override { return true; }
  void setEdgeBound(int /*vertex*/, double /*bound*/) override {}
  void start(int /*label*/) override {}
  void resume(int /*label*/) override {}
  long require(int /*label*/, std::span<const int> /*faces*/) override { return 0; }
  bool step(long& /*budget*/) override { return true; }
  int indexOf(int /*vertex*/) const override { return 0; }
  void remove(std::span<const int> /*labels*/) override {}
  const std::vector<ReachedVertex>& reached(int /*label*/) const override { return reached_; }
  void markFinal(int /*label*/, int /*index*/) override {}
  bool dependsOnEdgeBounds() const override { return false; }
  std::vector<LabelledDistance> nearestAt(const SurfacePoint& /*p*/, const DistanceField& /*known*/,
                                          long& /*budget*/) override {
    return {};
  }
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> /*points*/, const DistanceField& /*known*/) override {
    return nullptr;
  }
  Eigen::Vector2d direction(int /*label*/, int /*index*/) const override { return {1, 0}; }
  std::vector<SurfacePoint> path(int /*label*/, const SurfacePoint& /*p*/) override { return {}; }

 private:
  std::vector<ReachedVertex> reached_;
};

/// Along a strip of needles a label is required face after face, and hardly ever has to spread.
TEST(SlicedWork, ATurnOfManyRoundsIsInterrupted) {
  KnownEverywhere spread;
  LabelTurns turns(spread);
  const Requirement required = {.label = 0, .face = 0};
  turns.setRequired({&required, 1});
  int rounds = 0;
  const auto goOn = [&](int /*label*/, const std::vector<int>& faces) {
    return ++rounds < 100 ? faces : std::vector<int>();
  };
  long budget = 10;
  EXPECT_FALSE(turns.step(budget, goOn));
  EXPECT_LE(rounds, 10);
  budget = 1000;
  EXPECT_TRUE(turns.step(budget, goOn));
  EXPECT_EQ(rounds, 100);
}

TEST(SlicedWork, SitesAreInsertedAndRemovedInSlices) {
  constexpr int kSites = 200;
  const TriangleMesh mesh = shapes::cube().mesh();
  SiteDistances distances(mesh, Metric::kDgpc, sampleUniform(mesh, kSites, 1));
  int most = 0;  // sites in one step
  const auto finish = [&] {
    for (bool isDone = false; !isDone;) {
      const int before = distances.sites().count();
      long budget = 1;
      isDone = distances.step(budget);
      most = std::max(most, std::abs(distances.sites().count() - before));
    }
  };
  finish();
  EXPECT_EQ(distances.sites().count(), kSites);
  std::vector<SiteChange> removals;
  for (int label = 0; label < kSites; ++label) removals.push_back({label, std::nullopt});
  distances.change(removals);
  finish();
  EXPECT_EQ(distances.sites().count(), 0);
  EXPECT_LE(most, 10);
}

/// Of a hundred thousand labels, a change lets few spread.
TEST(SlicedWork, LabelsThatHaveReachedNothingNewAreGoneThroughInSlices) {
  const KnownEverywhere spread;
  ReachingLabels reaching(1);
  int steps = 1;
  for (long budget = 1; !reaching.collect(spread, 1000, budget); budget = 1) ++steps;
  EXPECT_GT(steps, 100);
}

/// The last site of a large component is removed: no label is near any of its vertices.
TEST(SlicedWork, VerticesThatNoLabelReachesAreGoneThroughInSlices) {
  const TriangleMesh mesh = shapes::icosphere(4).mesh();
  const SiteSet sites(mesh);
  EdgeBounds edgeBounds(mesh, sites);
  NearestBounds bounds(mesh);
  checks::makeRoom(edgeBounds, bounds);
  KnownEverywhere spread;
  LabelChange change;
  BoundsLowering lowering(mesh, spread, edgeBounds, bounds, change);
  for (int v = 0; v < mesh.vertexCount(); ++v) change.resetVertices.push_back(v);
  int steps = 1;
  for (long budget = 1; !lowering.step(budget); budget = 1) ++steps;
  EXPECT_GT(steps, mesh.vertexCount() / 8);
}

/// The number of steps of one unit.
template <class Result>
int unitSteps(std::unique_ptr<SlicedWork<Result>> work) {
  int steps = 1;
  while (!work->step(1)) ++steps;
  return steps;
}

/// Each was one step, however large the mesh.
TEST(SlicedWork, PolygonsAndComponentsAreGoneThroughInSlices) {
  const TriangleMesh mesh = shapes::icosphere(4).mesh();
  const auto sites = sampleUniform(mesh, 500, 1);
  const auto field = finished(propagate(mesh, sites, Metric::kExact));
  const PolygonMesh dual = dualMesh(mesh, sites, traceDiagram(mesh, *field, 500));
  EXPECT_GT(unitSteps(startTriangulation(dual)), 500);
  EXPECT_GT(unitSteps(startTopology(dual)), 500);
  EXPECT_GT(unitSteps(startBareComponents(mesh, sites)), 300);
  EXPECT_GT(unitSteps(startCoverComponents(mesh, sites, 1, 500, 1)), 300);
}

/// On a large mesh with a single site, its label has reached all vertices.
TEST(SlicedWork, WhatALabelHasReachedIsGoneThroughInSlices) {
  constexpr int kVertices = 5000;
  const KnownEverywhere spread(kVertices);
  const std::vector<int> labels = {0, 1};
  ReachedLoop loop;
  std::vector<std::array<int, 2>> visited;
  int steps = 1;
  const auto step = [&] {
    long budget = 1;
    return loop.run(spread, labels, budget, [&](int label, int i, const ReachedVertex& r) {
      EXPECT_EQ(r.vertex, i);
      visited.push_back({label, i});
    });
  };
  for (; !step(); ++steps) EXPECT_LE(visited.size(), static_cast<size_t>(steps * kQuickRounds));
  ASSERT_EQ(visited.size(), 2U * kVertices);
  for (int i = 0; i < kVertices; ++i) {
    EXPECT_EQ(visited[i], (std::array{0, i}));
    EXPECT_EQ(visited[kVertices + i], (std::array{1, i}));
  }

  ReachingLabels reaching(kVertices);
  int collections = 1;
  for (long budget = 1; !reaching.collect(spread, 2, budget); budget = 1) ++collections;
  EXPECT_GT(collections, 2 * kVertices / 16);
  for (int v = 0; v < kVertices; ++v)
    EXPECT_TRUE(std::ranges::equal(reaching[v], std::array{0, 1}));
  int removals = 1;
  for (long budget = 1; !reaching.remove(spread, labels, budget); budget = 1) ++removals;
  EXPECT_GT(removals, 2 * kVertices / 64);
  for (int v = 0; v < kVertices; ++v) EXPECT_TRUE(reaching[v].empty());
}

/// These took a single step, and nothing else had its turn until the whole mesh was gone through.
TEST(SlicedWork, NoStepGoesThroughTheWholeMesh) {
  const TriangleMesh mesh = shapes::grid(100, 100).mesh();
  const auto steps = [](auto work) {
    int count = 1;
    while (!work->step(1)) ++count;
    return count;
  };
  const int faces = mesh.faceCount();
  EXPECT_GT(steps(startUniform(mesh, 1, 1)), faces / 64);
  const std::vector<double> density(mesh.vertexCount(), 1);
  EXPECT_GT(steps(startByDensity(mesh, density, 1, 1)), faces / 64);
  IndexSet all(faces);
  int count = 1;
  for (long budget = 1; !all.addAll(budget); budget = 1) ++count;
  EXPECT_GT(count, faces / 256);
  EXPECT_EQ(all.size(), faces);
  EXPECT_EQ(all.list(), all.sorted());
}

TEST(SlicedWork, TheManyPointsOfOneLabelAreGoneThroughInSlices) {
  const TriangleMesh mesh = shapes::grid(100, 100).mesh();
  const auto field = finished(propagate(mesh, sampleUniform(mesh, 1, 1), Metric::kExact));
  const auto stepsFor = [&](int count) {
    std::vector<LabelledPoint> points(count);
    for (int i = 0; i < count; ++i) {
      const double s = (i + 1.0) / (count + 1);
      points[i] = {0, {0, {s, (1 - s) / 2, (1 - s) / 2}}};
    }
    const auto work = field->startDistancesAt(points);
    int steps = 1;
    while (!work->step(1)) ++steps;
    return steps;
  };
  // They are sorted out, compared with the site, spread to, taken as required and kept.
  const int count = 10000;
  EXPECT_GT(stepsFor(count) - stepsFor(1), count);
}

/// The diagram of each round was joined in a single step.
TEST(SlicedWork, ARepairJoinsItsDiagramInSteps) {
  const TriangleMesh mesh = shapes::grid(100, 100).mesh();
  const auto sites = sampleUniform(mesh, 1, 1);
  const auto steps = [](auto&& work) {
    int count = 1;
    while (!work->step(1)) ++count;
    return count;
  };
  auto opening = DynamicDiagram::start(mesh, sites);
  const int ofOpening = steps(opening);
  const DynamicDiagram dynamic = opening->take();
  const int ofJoining = steps(dynamic.startDiagram());
  EXPECT_GT(ofJoining, 100);
  const Diagram diagram = dynamic.diagram();
  const int ofFinding =
      steps(startRepairingSites(mesh, dynamic.sites(), diagram, dynamic.distances()));
  auto repairing = startRepair(mesh, sites, Metric::kExact, {.maxAdded = 0});
  int count = 0;
  EXPECT_THROW(for (;; ++count) repairing->step(1), Error);
  EXPECT_GT(count, ofOpening + ofJoining / 2 + ofFinding);
}

TEST(SlicedWork, ALongOutlineThatUsesUpTheBudgetLeavesNothingOut) {
  // The one outline is the last thing of its stage, and takes more than all the budget there is.
  const TriangleMesh mesh = shapes::grid(400, 400).mesh();
  const std::vector<SurfacePoint> sites = {mesh.fromInputVertex(0)};
  const checks::Traced traced = checks::trace(mesh, sites);
  EXPECT_TRUE(inSteps(startDiagram(mesh, *traced.field, 1)) == traced.diagram);
}

/// Distances of which one point takes all the budget of a step.
class SlowSearches final : public checks::SameDistances {
 public:
  static constexpr long kUnits = 1000;
  using SameDistances::SameDistances;
  LabelledDistance nearest(const SurfacePoint& p, long& budget) const override {
    ++count;
    budget -= kUnits;
    return SameDistances::nearest(p, budget);
  }
  mutable int count = 0;
};

/// All points on the outline of the worst region were looked at in one step, and each point of a
/// comparison counted the same however long its search took.
TEST(SlicedWork, SearchesCountAsMuchAsTheyTake) {
  const TriangleMesh mesh = shapes::icosphere(2).mesh();
  const checks::Traced traced = checks::trace(mesh, sampleUniform(mesh, 3, 1));
  const SlowSearches field(*traced.field);
  const auto expectSlices = [&](auto work) {
    int before = field.count = 0;
    while (!work->step(SlowSearches::kUnits)) {
      EXPECT_LE(field.count, before + 1);
      before = field.count;
    }
    EXPECT_LE(field.count, before + 1);
    EXPECT_GT(field.count, 1);
    return work->take();
  };
  expectSlices(startAccuracy(mesh, field, traced.diagram, 100));
  const WorstRegions regions =
      expectSlices(WorstRegions::start(mesh, field, traced.diagram, WorstRegion::kSize));
  const int count = field.count;
  EXPECT_GE(regions.point().face, 0);
  EXPECT_EQ(field.count, count);
}

TEST(SlicedWork, MakesTheSameMeshes) {
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    shapes::Random random(seed);
    const shapes::Shape shape = wildMesh(random, 60);
    const MeshOptions options = {.weld = seed % 3 ? 0 : random.uniform() * 0.1,
                                 .orientation = seed % 2 ? Orientation::kKeep : Orientation::kUnify,
                                 .minComponent = seed % 5 ? 0 : random.below(5)};
    const auto stepped = [&] {
      return inSteps(startMesh(shape.positions, shape.triangles, options));
    };
    const std::string error = errorOf([&] { shape.mesh(options); });
    EXPECT_EQ(errorOf([&] { stepped(); }), error);
    if (error.empty()) expectSame(stepped(), shape.mesh(options), shape);
  }
}

TEST(SlicedWork, SubdividesInTheSameWay) {
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    shapes::Random random(seed);
    const shapes::Shape shape = wildMesh(random, 60);
    const SubdivisionOptions options = {.maxEdge = random.uniform(0.01, 1), .maxTriangles = 5000};
    const auto stepped = [&] {
      return inSteps(startSubdivision(shape.positions, shape.triangles, options));
    };
    const auto atOnce = [&] { return subdivide(shape.positions, shape.triangles, options); };
    const std::string error = errorOf([&] { atOnce(); });
    EXPECT_EQ(errorOf([&] { stepped(); }), error);
    if (!error.empty()) continue;
    EXPECT_EQ(stepped().triangles, atOnce().triangles);
    EXPECT_EQ(stepped().parents, atOnce().parents);
    EXPECT_EQ(stepped().ends, atOnce().ends);
  }
}

TEST(SlicedWork, GivesTheSameSamples) {
  for (int seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const TriangleMesh mesh = shapes::randomMesh(seed);
    const double radius = mesh.boundingDiagonal() / 8;
    EXPECT_EQ(inSteps(startUniform(mesh, 20, seed)), sampleUniform(mesh, 20, seed));
    const std::vector<double> density = curvatureDensity(mesh);
    EXPECT_EQ(inSteps(startByDensity(mesh, density, 20, seed)),
              sampleByDensity(mesh, density, 20, seed));
    EXPECT_EQ(inSteps(startFarthest(mesh, 20, seed)), sampleFarthest(mesh, 20, seed));
    EXPECT_EQ(inSteps(startFarthest(mesh, 1000, seed, radius)),
              sampleFarthest(mesh, 1000, seed, radius));
    EXPECT_EQ(inSteps(startPoissonDisk(mesh, radius, seed)).points,
              samplePoissonDisk(mesh, radius, seed).points);
    const PoissonDisk disk = inSteps(startPoissonDiskCount(mesh, 20, seed)),
                      expected = samplePoissonDiskCount(mesh, 20, seed);
    EXPECT_EQ(disk.points, expected.points);
    EXPECT_EQ(disk.radius, expected.radius);
  }
}

TEST(SlicedWork, RepairsAndRemeshesTheSame) {
  const TriangleMesh mesh = shapes::torus(12, 8).mesh();
  const auto sites = sampleUniform(mesh, 5, 1);
  const RepairedSites repaired = repair(mesh, sites, Metric::kExact);
  EXPECT_GT(repaired.added, 0);
  EXPECT_EQ(inSteps(startRepair(mesh, sites, Metric::kExact)).sites, repaired.sites);
  const RemeshOptions options = {.tessellation = {.iterations = 3}};
  const RepairedSites remeshed = remesh(mesh, sites, options);
  EXPECT_GT(remeshed.added, 0);
  EXPECT_EQ(inSteps(startRemesh(mesh, sites, options)).sites, remeshed.sites);
}

TEST(SlicedWork, SamplesNothingIfNothingIsAskedFor) {
  const TriangleMesh mesh = shapes::cube().mesh();
  EXPECT_TRUE(inSteps(startFarthest(mesh, 0, 1)).empty());
  EXPECT_TRUE(inSteps(startPoissonDiskCount(mesh, 0, 1)).points.empty());
  // Its progress was no number.
  EXPECT_TRUE(inSteps(startWorstFirst(mesh, 0, 1, WorstRegion::kSize)).empty());
}

/// It ended at 0.8 or below where the last part of the work was not counted, or ended early. The
/// work that other tests here do in steps is not repeated.
TEST(SlicedWork, ProgressRisesToOne) {
  const TriangleMesh mesh = shapes::torus(12, 8).mesh();
  const auto sites = sampleUniform(mesh, 5, 1);
  const std::unique_ptr<DistanceField> field = inSteps(propagate(mesh, sites, Metric::kExact));
  const Diagram diagram = traceDiagram(mesh, *field, 5);
  inSteps(field->startDistancesAt({{0, sites[1]}, {1, sites[1]}}));
  inSteps(startShortestPath(mesh, sites[0], sites[1]));
  inSteps(startAccuracy(mesh, *field, diagram));
  inSteps(startCurvatureDensity(mesh));
  inSteps(startClosestPointQuery(mesh));
  inSteps(WorstRegions::start(mesh, *field, diagram, WorstRegion::kSize));
  inSteps(startWorstFirst(mesh, 5, 1, WorstRegion::kDistortion));
}

/// It stood at 0 until all faces were split.
TEST(SlicedWork, ProgressOfADetailedDiagramRisesAlongTheWay) {
  const TriangleMesh mesh = shapes::grid(40, 40).mesh();
  const auto field = finished(propagate(mesh, sampleUniform(mesh, 20, 1), Metric::kExact));
  for (const int detail : {1, 2, 3}) {
    std::vector<double> progress;
    for (const auto work = startDiagram(mesh, *field, 20, {.detail = detail}); !work->step(100);)
      progress.push_back(work->progress());
    for (const double part : {0.25, 0.5, 0.75}) {
      const double there = progress[static_cast<size_t>(part * progress.size())];
      EXPECT_GT(there, part / 10) << detail;
      EXPECT_LT(there, part + 0.2) << detail;
    }
  }
}

class OfADiagram : public ::testing::TestWithParam<int> {
 protected:
  const TriangleMesh mesh = shapes::randomMesh(GetParam());
  const std::vector<SurfacePoint> sites = sampleUniform(mesh, 12, GetParam());
  const checks::Traced traced = checks::trace(mesh, sites, Metric::kExact, GetParam() % 3);
  const Diagram& diagram = traced.diagram;
};

TEST_P(OfADiagram, TheDiagramIsTheSame) {
  EXPECT_TRUE(inSteps(startDiagram(mesh, *traced.field, 12, {.detail = GetParam() % 3})) ==
              diagram);
}

TEST_P(OfADiagram, ChangesOfItsSitesAreTheSame) {
  const DiagramOptions options = {.detail = GetParam() % 2};
  const Metric metric = GetParam() % 3 == 0 ? Metric::kDgpc : Metric::kExact;
  DynamicDiagram stepped = inSteps(DynamicDiagram::start(mesh, sites, metric, options)),
                 atOnce(mesh, sites, metric, options);
  EXPECT_TRUE(stepped.diagram() == atOnce.diagram());
  const std::vector<SurfacePoint> places = sampleUniform(mesh, 3, GetParam() + 100);
  const auto expectSameChange = [&](std::unique_ptr<SlicedWork<DiagramChange>> change,
                                    const DiagramChange& expected) {
    const DiagramChange found = inSteps(std::move(change));
    EXPECT_EQ(found.labels, expected.labels);
    EXPECT_EQ(found.faces, expected.faces);
    EXPECT_TRUE(found.part == expected.part);
    EXPECT_TRUE(stepped.diagram() == atOnce.diagram());
  };
  expectSameChange(stepped.startInsert(places[0]), atOnce.insertSite(places[0]));
  expectSameChange(stepped.startMove(3, places[1]), atOnce.moveSite(3, places[1]));
  expectSameChange(stepped.startRemove(5), atOnce.removeSite(5));
  expectSameChange(stepped.startInsert(places[2]), atOnce.insertSite(places[2]));
}

TEST_P(OfADiagram, ItIsTakenOverInStepsAsAtOnce) {
  const std::shared_ptr<DistanceField> field = checks::trace(mesh, sites, Metric::kExact).field;
  EXPECT_TRUE(inSteps(DynamicDiagram::startFromDistances(mesh, field)).diagram() ==
              DynamicDiagram(mesh, sites).diagram());
}

TEST_P(OfADiagram, ThePartitionIsTheSame) {
  const PartitionOptions options = {.leaveOutIndifferent = GetParam() % 2 == 0,
                                    .leaveOutUnreachable = GetParam() % 2 == 1};
  const Partition a = inSteps(startPartition(mesh, diagram, options)),
                  b = partition(mesh, diagram, options);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangleLabel, b.triangleLabel);
  EXPECT_EQ(a.triangleFace, b.triangleFace);
  EXPECT_EQ(a.twins, b.twins);
  ASSERT_EQ(a.regions.size(), b.regions.size());
  for (size_t l = 0; l < a.regions.size(); ++l) {
    const RegionPatch &p = a.regions[l], &q = b.regions[l];
    EXPECT_EQ(p.label, static_cast<int>(l));
    EXPECT_EQ(p.area, q.area);
    EXPECT_EQ(p.perimeter, q.perimeter);
    EXPECT_EQ(p.eulerCharacteristic, q.eulerCharacteristic);
    EXPECT_EQ(p.components, q.components);
    EXPECT_EQ(p.nearCentroid, q.nearCentroid);
  }
}

TEST_P(OfADiagram, TheDualAndWhatIsToldAboutItAreTheSame) {
  const PolygonMesh dual = inSteps(startDualMesh(mesh, sites, diagram)),
                    expected = dualMesh(mesh, sites, diagram);
  EXPECT_EQ(dual.points, expected.points);
  EXPECT_TRUE(dual.faces == expected.faces);
  EXPECT_TRUE(inSteps(startRegionMesh(mesh, diagram)).faces == regionMesh(mesh, diagram).faces);

  const auto violations = inSteps(startViolations(mesh, sites, diagram));
  const auto others = findViolations(mesh, sites, diagram);
  ASSERT_EQ(violations.size(), others.size());
  for (size_t i = 0; i < others.size(); ++i) EXPECT_EQ(violations[i].message, others[i].message);
  EXPECT_EQ(inSteps(startRepairingSites(mesh, sites, diagram, *traced.field)),
            repairingSites(mesh, sites, diagram, *traced.field));

  const auto paths = inSteps(startDualPaths(mesh, diagram, *traced.field));
  const auto atOnce = dualPaths(mesh, diagram, *traced.field);
  ASSERT_EQ(paths.size(), atOnce.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(paths[i].labels, atOnce[i].labels);
    EXPECT_EQ(paths[i].points, atOnce[i].points);
  }

  EXPECT_EQ(inSteps(startTriangulation(expected)).triangles, triangulate(expected).triangles);
  EXPECT_EQ(inSteps(startTopology(expected)).edges, topologyOf(expected).edges);

  const RemeshQuality a = inSteps(startQuality(mesh, startDualMesh(mesh, sites, diagram))),
                      b = measureQuality(mesh, expected);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.minAngle, b.minAngle);
  EXPECT_EQ(a.hausdorff, b.hausdorff);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OfADiagram, ::testing::Range(0, 12));

}  // namespace
}  // namespace gvd
