// SPDX-License-Identifier: MIT
//
// The share of the surface that a diagram gives to the wrong region.

#include <gtest/gtest.h>

#include <vector>

#include "diagram_checks.h"
#include "gvd/diagram.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

using checks::trace;

TEST(Accuracy, IsTheShareOfTheAreaInTheWrongRegion) {
  const TriangleMesh mesh = shapes::icosphere(4).mesh();
  const auto sites = sampleUniform(mesh, 8, 3);
  auto [field, diagram] = trace(mesh, sites, Metric::kExact);
  EXPECT_LE(accuracy(mesh, *field, diagram).mislabelled, 0.002);
  const double exchanged = (diagram.regionArea[2] + diagram.regionArea[5]) / mesh.area();
  for (std::vector<int>* labels : {&diagram.faceLabel, &diagram.cellLabel})
    for (int& label : *labels) label = label == 2 ? 5 : label == 5 ? 2 : label;
  EXPECT_NEAR(accuracy(mesh, *field, diagram, 20000).mislabelled, exchanged, 0.01);
}

TEST(Accuracy, CountsTiesAsRight) {
  const TriangleMesh mesh = shapes::perforatedPlate(1).mesh();
  std::vector<SurfacePoint> sites = {pointAtVertex(mesh, 0), pointAtVertex(mesh, 0)};
  for (int v = 0; v < mesh.vertexCount(); ++v) sites.push_back(pointAtVertex(mesh, v));
  const auto [field, diagram] = trace(mesh, sites, Metric::kExact);
  EXPECT_EQ(accuracy(mesh, *field, diagram).mislabelled, 0);
}

TEST(Accuracy, RejectsWhatDoesNotBelongTogether) {
  const TriangleMesh mesh = shapes::icosphere(4).mesh(), other = shapes::icosphere(3).mesh();
  const auto [field, diagram] = trace(mesh, sampleUniform(mesh, 8, 3), Metric::kExact);
  EXPECT_THROW(accuracy(other, *field, diagram), Error);
  EXPECT_THROW(accuracy(mesh, *field, Diagram()), Error);
  EXPECT_THROW(accuracy(mesh, *field, diagram, 0), Error);
}

}  // namespace
}  // namespace gvd
