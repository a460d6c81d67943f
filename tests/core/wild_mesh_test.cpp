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
      // A bisector runs between the ends of a side of the mesh boundary, beside it.
      {"BisectorBesideTheBoundary",
       {{0, 1, 0, 0, 0, 1, -1e30, 1, 0, 1, 0, 0}, {0, 1, 2, 3, 1, 2}},
       {{0, {0.9499999999952502, 0.049999999999749779, 4.9999999999250017e-12}},
        {0, {0.42185832004998797, 0.57814167994944365, 5.6836511143653779e-13}},
        {0, {0.27500000000057367, 0.72499999999832343, 1.102885682953481e-12}}}},
      // No straight line comes to the last vertices through the needles before them.
      {"LinesLostInNeedles",
       {{1.8469758860665703e+31,
         3.6939346386125862e+31,
         -5.5406683610924204e+31,
         5.6538821347485545e+31,
         1.1307764351208212e+32,
         -1.6961646302163717e+32,
         8.9999999999999963e+32,
         6.9999999999999973e+32,
         8.9999999999999992e+32,
         6.7193546656959644e+32,
         5.4646544813144689e+32,
         -4.5053944105812313e+31,
         8.9999999999999992e+32,
         6.9999999999999988e+32,
         8.9999999999999992e+32,
         1.2122268785254512e+32,
         2.4244537570185405e+32,
         -3.6366806353852655e+32,
         3.974475600638169e+30,
         7.9478694462368017e+30,
         -1.1920579930255472e+31,
         1.3139213286944192e+32,
         2.627842609740825e+32,
         -3.9417637674461032e+32,
         3.9613203746927398e+31,
         7.9226407493868028e+31,
         -1.1883961123939287e+32,
         4.4408920985006259e+17,
         1.0000000000000001e+32,
         0,
         0,
         1.0000000000000001e+32,
         0,
         1.2363846961139215e+32,
         2.4727693922277635e+32,
         -3.7091540883414852e+32,
         5.9999999999999992e+32,
         1.0000000000000001e+32,
         8.9999999999999992e+32,
         1.3286520569307999e+32,
         2.6573030778330974e+32,
         -3.9859523233168379e+32,
         8.9999999999999992e+32,
         6.9999999999999988e+32,
         8.9999999999999992e+32},
        {0, 1, 2, 0,  2, 3, 3,  2, 4,  3, 4,  5, 5,  4,  6,  4,  7,  6,  8, 6,
         9, 8, 9, 10, 6, 7, 11, 6, 11, 9, 10, 9, 12, 10, 12, 13, 13, 12, 14}},
       {{0, {0.44801116530005497, 0.038715156378483377, 0.51327367832146165}}}},
      // A straight line through needles is longer, by rounding, than the path along edges.
      {"LineLongerThanEdges",
       {{0.098431640718313645, 0.19686328143662729, -0.29529492215494091, 0.028678756436149533,
         0.045824730775192821, -1e+30, 0.11180399638141331, 0.22245739344421794,
         -0.33219479062606649, 0.13323370487669708, 0.26640323250255193, -0.39954558376846461},
        {0, 1, 2, 2, 1, 3}},
       {{0, {0.71022891486390372, 0.25483505139937046, 0.034936033736725824}}}},
      // Lines that wind around a spike tie with those that do not.
      {"LinesAroundASpike",
       {{0.89999999999999991, 0.7, 1e-30, 0, 0.1, 0.9, 0.6, -1e30, 0.9, -2.2204460492503131e-16,
         0.1, 0, 0.89999999999999991, 0.7, 0.9, 0.3, 0.7, 0},
        {0, 1, 2, 3, 2, 1, 0, 2, 4, 3, 5, 4}},
       {{0, {0.44222588294334203, 0.4902514749605224, 0.067522642096135566}}}},
      // The path to vertex 7 that turns on an edge is not the end of all windows beside it.
      {"WindowsBesideAPathThatTurns",
       {{0.89999999999999991,
         6.9999999999999999e-06,
         0.09,
         0.30000000000000021,
         7.0000000000000024e-06,
         0,
         0.29999999999999954,
         6.9999999999999957e-06,
         0,
         0.6,
         1.0000000000000002e-06,
         0.09,
         0.090946742466517863,
         2.2057669503348214e-07,
         0.05042288643973214,
         4.4408920985006262e-16,
         1.0000000000000002e-06,
         0,
         0.042619142904758101,
         8.5238285809516209e-07,
         -0.012785742871427431,
         0,
         1.0000000000000002e-06,
         0,
         0.59999999999999998,
         1.0000000000000002e-06,
         0.09,
         4.4408920985006262e-16,
         1.0000000000000002e-06,
         0},
        {0, 1, 3, 0, 3, 2, 2, 3, 4, 2, 4, 0, 0, 4, 5, 0, 5, 7, 0, 7, 6, 6, 7, 8, 6, 8, 9}},
       {{0, {0.45271309911537938, 0.42513121766203366, 0.12215568322258696}},
        {7, {0.34688246262694145, 0.4094542799919636, 0.24366325738109496}},
        {1, {0, 1, 0}},
        {5, {0.17733319121736379, 0.70654715288844117, 0.11611965589419504}}}},
      // A path that turns ties with a straight one.
      {"TurnThatTies",
       {{0.89999999999999969,
         0.69999999999999973,
         9e-07,
         0.89999999999999991,
         0.7,
         9e-07,
         3,
         3,
         2e-06,
         3,
         1,
         2e-06,
         1,
         2,
         3e-06,
         0.59999999999999953,
         0.1,
         9e-07,
         0.89999999999999991,
         0.7,
         9e-07},
        {0, 1, 2, 0, 3, 4, 5, 4, 3, 0, 4, 6, 5, 6, 4}},
       {{4, {0.36628598663713918, 0.47790453236834374, 0.15580948099451708}},
        {4, {0.36628598638586518, 0.47790453261961774, 0.15580948099451708}}}},
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
