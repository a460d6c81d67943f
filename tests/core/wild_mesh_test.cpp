// SPDX-License-Identifier: MIT
//
// Meshes on which something once went wrong, one each, as small as they could be made.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pipeline_checks.h"
#include "shapes.h"

namespace gvd {
namespace {

struct WildCase {
  std::string name;
  shapes::Shape shape;
  std::vector<SurfacePoint> sites;
};

const std::vector<WildCase>& wildCases() {
  static const std::vector<WildCase> cases = {
      // Vertices that rounding has put in one place are ends of mollified edges.
      {"NeedleOfRounding",
       {{-4.4408920985006262e-16, 0.1, 0, 0, 1, 3, 0.9, 0.7, 0.9, 0, 1, 0, 0, 0.1, 0},
        {0, 1, 2, 3, 1, 4, 0, 4, 1}},
       {{0, {0.038127046038717083, 0.59677554149350609, 0.36509741246777683}},
        {0, {0.038127045399209344, 0.59677554213301387, 0.36509741246777683}}}},
      // Bisectors cross needles that are narrower than points are merged at.
      {"NeedlesOfSize1e30",
       {{-2.2204460492503131e-16, 0.1, 0, 0.6, 0.1, 0.9, 0.6, 0.1, -1e30, 0.14611158640595345,
         0.09891478834113554, 0.33060537403325485, 2.2204460492503131e-16, 0.1, 0},
        {0, 1, 2, 2, 0, 3, 2, 4, 3}},
       {{1, {0, 0, 1}}}},
      // A bisector crosses the short side of a needle.
      {"ShortSideOfANeedle",
       {{0.3, 0.7, 0, 0.6, 0.1, 0.9, 0.9, 1e-30, 1e30, 0.0093261510769351939, 0.018652302153870388,
         -0.02797845323080558},
        {0, 1, 2, 0, 2, 3}},
       {{0, {0.43056939216417078, 0.56943060783582922, 0}},
        {1, {0.40457504113206744, 0, 0.59542495886793256}}}},
      // Voronoi points in a face a thousand times as long as high.
      {"MeetingsInAThinFace",
       {{0, 0,    0, 3, 2e-7, 0.002, 0, 2e-7, 0.003, 0, 0,    0.001,
         0, 1e-7, 0, 1, 3e-7, 0.001, 1, 2e-7, 0.002, 3, 1e-7, 0.003},
        {0, 1, 2, 3, 2, 1, 0, 2, 4, 0, 4, 5, 3, 5, 4, 3, 6, 5, 3, 7, 6, 3, 1, 7}},
       {{1, {0.12131439700930507, 0.87819024255731259, 0.00049536043338233027}},
        {1, {0.20513094668807727, 0.7943091817584389, 0.00055987155348383253}},
        {1, {0.7943091817607042, 0.20513094668581205, 0.00055987155348383253}},
        {1, {0.068247696510745068, 0.93150357284576324, 0.00024873064349169148}}}},
      // Three bisectors meet that are almost the same line.
      {"MeetingOfNearlyParallelBisectors",
       {{0.9, 0.7, 0.9, 2.2204460492503131e-16, 0.1, 0, 0, 0.1, 0, 4.4408920985006262e-16, 0.1, 0,
         0.89999999999999947, 0.69999999999999951, 0.9, 0.59999999999999976, 0.1, 0.9},
        {0, 1, 2, 0, 3, 4, 5, 4, 3}},
       {{1, {0.5, 0.5, 0}}, {1, {0, 0.5, 0.5}}, {1, {0.5, 0, 0.5}}, {2, {0.5, 0.5, 0}}}},
  };
  return cases;
}

class WildMesh : public ::testing::TestWithParam<WildCase> {};

void expectNoComplaint(const shapes::Shape& shape, const std::vector<SurfacePoint>& inputSites) {
  const TriangleMesh mesh = shape.mesh();
  for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
    shapes::Random random(1);
    std::vector<SurfacePoint> sites;
    for (const SurfacePoint& site : inputSites) sites.push_back(mesh.fromInput(site));
    EXPECT_EQ(checks::complaintAboutPipeline(mesh, sites, random, {.metric = metric}), "");
  }
}

TEST_P(WildMesh, GoesThroughThePipeline) { expectNoComplaint(GetParam().shape, GetParam().sites); }

/// Almost the largest and smallest that `TriangleMesh` takes: determinants of squared distances
/// would over- and underflow.
TEST_P(WildMesh, GoesThroughThePipelineAtAnySize) {
  for (const double size : {1e59, 1e-59}) {
    shapes::Shape shape = GetParam().shape;
    double largest = 0;
    for (const double x : shape.positions) largest = std::max(largest, std::abs(x));
    for (double& x : shape.positions) x = x / largest * size;
    expectNoComplaint(shape, GetParam().sites);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, WildMesh, ::testing::ValuesIn(wildCases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace gvd
