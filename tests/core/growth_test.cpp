// SPDX-License-Identifier: MIT
//
// How the work for distances grows with the mesh, where faces follow one another around a vertex or
// along a strip: a label then owns part of one after the other.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "shapes.h"

namespace gvd {
namespace {

using shapes::Shape;

Shape flatFan(int faces) { return shapes::vertexFan(faces, 2 * std::numbers::pi); }
Shape shuffledFan(int faces) { return shapes::shuffled(flatFan(faces), 1); }

/// A square of triangles from its lower side to its upper one.
Shape stripOfNeedles(int faces) {
  Shape shape;
  for (int i = 0; i <= faces / 2; ++i)
    for (int y = 0; y < 2; ++y) shape.addVertex({2.0 * i / faces, static_cast<double>(y), 0});
  for (int v = 0; v < faces; v += 2) shape.addQuad(v, v + 2, v + 3, v + 1);
  return shape;
}

/// The work for the distances of 20 sites, in slices of 100 units.
double work(const Shape& shape) {
  const TriangleMesh mesh = shape.mesh();
  const auto propagation = propagate(mesh, sampleUniform(mesh, 20, 7), Metric::kDgpc);
  int slices = 1;
  while (!propagation->step(100)) ++slices;
  return slices;
}

TEST(Growth, WorkGrowsWithTheFacesAroundAVertex) {
  for (Shape (*const make)(int) : {flatFan, shuffledFan, stripOfNeedles})
    EXPECT_LT(work(make(8000)), 6 * work(make(2000)));
}

}  // namespace
}  // namespace gvd
