// SPDX-License-Identifier: MIT
//
// How the work for distances grows with the mesh, where faces follow one another around a vertex or
// along a strip: a label then owns part of one after the other.
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

#include "base/sliced_loop.h"
#include "distance/exact/revisit_filter.h"
#include "distance/site_distances.h"
#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mesh/twin_matching.h"
#include "shapes.h"

namespace gvd {
namespace {

using shapes::Shape;

Shape flatFan(int faces) { return shapes::vertexFan(faces, 2 * std::numbers::pi); }
Shape shuffledFan(int faces) { return shapes::shuffled(flatFan(faces), 1); }
/// Its regions are bands, so that each label is required all around.
Shape narrowCone(int faces) { return shapes::vertexFan(faces, 0.1 * std::numbers::pi); }

/// A square of triangles from its lower side to its upper one.
Shape stripOfNeedles(int faces) {
  Shape shape;
  for (int i = 0; i <= faces / 2; ++i)
    for (int y = 0; y < 2; ++y) shape.addVertex({2.0 * i / faces, static_cast<double>(y), 0});
  for (int v = 0; v < faces; v += 2) shape.addQuad(v, v + 2, v + 3, v + 1);
  return shape;
}

/// A tube much longer than wide. Its regions are bands between two rings of vertices, so that each
/// label is required face after face all around.
Shape tubeOfNeedles(int faces) { return shapes::cylinder(faces / 8, 4, 1, 120); }

/// The work for the distances of 20 sites, in slices of 1000 units.
double work(const Shape& shape, Metric metric) {
  const TriangleMesh mesh = shape.mesh();
  const auto propagation = propagate(mesh, sampleUniform(mesh, 20, 7), metric);
  int slices = 1;
  while (!propagation->step(1000)) ++slices;
  return slices;
}

TEST(Growth, WorkGrowsWithTheFacesAroundAVertex) {
  for (Shape (*const make)(int) : {flatFan, shuffledFan, narrowCone, stripOfNeedles, tubeOfNeedles})
    for (const Metric metric : {Metric::kDgpc, Metric::kExact})
      EXPECT_LT(work(make(8000), metric), 6 * work(make(2000), metric));
}

/// Whether the exact distances of one site are found in so many units of work.
bool endsWithin(long units, const TriangleMesh& mesh, const SurfacePoint& site) {
  return propagate(mesh, {&site, 1}, Metric::kExact)->step(units);
}

/// The site at some share of the edges from corner 0 of a face.
SurfacePoint besideCorner(int face, double share) {
  return {face, {1 - share, 0.4 * share, 0.6 * share}};
}

/// A site beside the tip of a cone of thin faces, at 1e-11 to 1e-14 of an edge. A turn by such a
/// face moves the site by less than the edge is rounded, and lines must turn all the same.
TEST(Growth, LinesTurnAroundATipThatIsVeryNear) {
  for (const int faces : {100, 400})
    for (const double angleSum : {0.1, 0.3}) {
      const TriangleMesh mesh = shapes::vertexFan(faces, angleSum).mesh();
      for (const double share : {1e-11, 1e-12, 1e-13, 1e-14})
        EXPECT_TRUE(endsWithin(100 * faces, mesh, besideCorner(0, share)))
            << faces << " faces, angles of " << angleSum << ", site at " << share;
    }
}

/// Squares that are stretched to needles, so that the ways along their columns tie.
TEST(Growth, NeedlesBesideEachOtherTakeNoLongerThanTheirWindows) {
  const TriangleMesh mesh = shapes::scaled(shapes::grid(50, 50), {1e-8, 1, 0}).mesh();
  EXPECT_TRUE(endsWithin(100000, mesh, {mesh.faceCount() / 2, {0.3, 0.3, 0.4}}));
}

/// A search from a point in a fan has a window in each of the faces. To follow each one back to the
/// point would take the square of the time of the search.
TEST(Growth, SearchesFollowWindowsBackForNoLongerThanTheySpread) {
  const TriangleMesh mesh = flatFan(1000).mesh();
  exact::RevisitFilter filter(mesh);
  filter.begin(true);
  filter.noteCrossing(0);  // without a vertex reached, which is suspicious
  for (int f = 0; f < mesh.faceCount(); ++f)
    EXPECT_FALSE(filter.drops({.begin = 0.4,
                               .end = 0.5,
                               .x = 0.3,
                               .y = -0.5,
                               .fromTip = 0.7,
                               .sourceDistance = 0,
                               .direction = 0},
                              3 * f));
  EXPECT_LT(filter.takeCrossedBack(), 3 * mesh.faceCount());
}

/// The number of steps of a thousand units in which a diagram of sites in face 0 is traced.
int stepsToTrace(const TriangleMesh& mesh, int siteCount) {
  shapes::Random random(1);
  std::vector<SurfacePoint> sites;
  for (int i = 0; i < siteCount; ++i) sites.push_back(besideCorner(0, random.uniform(0.1, 0.9)));
  const auto distances = finished(propagate(mesh, sites, Metric::kExact));
  const auto tracing = startDiagram(mesh, *distances, siteCount);
  int steps = 1;
  while (!tracing->step(1000)) ++steps;
  return steps;
}

/// Around a sharp cone of thin faces, all labels are near every face: to divide one is work for
/// each of them, and steps end in time only if it is counted.
TEST(Growth, FacesWithManyLabelsAreTracedInMoreSteps) {
  const TriangleMesh mesh = shapes::vertexFan(300, 0.3).mesh();
  EXPECT_GT(stepsToTrace(mesh, 100), 10 * stepsToTrace(mesh, 2) + 20);
}

/// Halfedges that all end at one vertex are not all compared with each other.
TEST(Growth, TwinsAroundAVertexAreFoundInShortLists) {
  const TriangleMesh mesh = shuffledFan(1000).mesh();
  TwinMatching twins;
  long budget = kUnlimited;
  twins.prepare(mesh.halfedgeCount(), budget);
  int looks = 0;
  const auto tail = [&](int h) {
    ++looks;
    return mesh.tail(h);
  };
  for (int h = 0; h < mesh.halfedgeCount(); ++h) twins.add(h, tail, [](int) { return true; });
  EXPECT_LT(looks, 8 * mesh.halfedgeCount());
  for (int h = 0; h < mesh.halfedgeCount(); ++h) EXPECT_EQ(twins[h], mesh.twin(h));
}

/// Lines from a point of a spike of three needles wind around it, in turn with lines over its base.
/// A regular choice of the windows that are followed back never met those that wind: 500,000
/// windows spread.
TEST(Growth, SearchesFollowBackWhatWindsAroundASpike) {
  Shape spike;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e11, 0, 0}})
    spike.addVertex(p);
  for (const std::array<int, 3>& t : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    spike.addTriangle(t[0], t[1], t[2]);
  const TriangleMesh mesh = spike.mesh();
  SiteDistances distances(mesh, Metric::kExact,
                          std::vector<SurfacePoint>{{0, {0, 0, 1}}, {1, {0, 0, 1}}});
  long budget = kUnlimited;
  ASSERT_TRUE(distances.step(budget));
  long units = 1000;
  distances.nearest({1, {0.7, 0.2, 0.1}}, units);
  EXPECT_GT(units, 0);
}

}  // namespace
}  // namespace gvd
