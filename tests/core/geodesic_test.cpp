// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "gvd/error.h"
#include "gvd/sampling.h"
#include "random_case.h"
#include "shapes.h"

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

class Metrics : public ::testing::TestWithParam<Metric> {};

TEST_P(Metrics, GiveTheSameInSlicesOfAnySize) {
  for (int seed = 0; seed < 40; ++seed) {
    const RandomCase random = randomCase(seed);
    const TriangleMesh mesh = random.mesh();
    const std::vector<SurfacePoint> sites = random.sitesOn(mesh);
    const auto whole = inSlices(mesh, sites, GetParam(), 1L << 40);
    for (const long budget : {1L, 7L}) {
      const auto sliced = inSlices(mesh, sites, GetParam(), budget);
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        const auto expected = whole->at(v), found = sliced->at(v);
        ASSERT_EQ(found.size(), expected.size()) << "seed " << seed << ", vertex " << v;
        for (size_t i = 0; i < found.size(); ++i) {
          EXPECT_EQ(found[i].label, expected[i].label) << "seed " << seed << ", vertex " << v;
          EXPECT_EQ(found[i].distance, expected[i].distance) << "seed " << seed << ", vertex " << v;
        }
      }
    }
  }
}

/// A vertex of a mesh may be out of sight of all its neighbours' views; it is reached all the same,
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

TEST_P(Metrics, WantASite) {
  const auto mesh = shapes::icosphere(1).mesh();
  EXPECT_THROW(propagate(mesh, {}, GetParam()), Error);
}

INSTANTIATE_TEST_SUITE_P(Both, Metrics, ::testing::Values(Metric::kDgpc, Metric::kExact),
                         [](const auto& info) {
                           return info.param == Metric::kDgpc ? "Dgpc" : "Exact";
                         });

}  // namespace
}  // namespace gvd
