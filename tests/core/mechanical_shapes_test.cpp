// SPDX-License-Identifier: MIT
#include "mechanical_shapes.h"

#include <gtest/gtest.h>

namespace gvd::shapes {
namespace {

/// One wrong side of an outline, and a part would be open, or of another genus.
TEST(MechanicalShapes, AreClosedAndOfTheGenusTheySay) {
  for (const MechanicalShape& part : mechanicalShapes()) {
    for (const Shape& shape : {part.shape, subdivided(part.shape)}) {
      const TriangleMesh mesh = shape.mesh();
      EXPECT_EQ(mesh.faceCount(), shape.faceCount()) << part.name;
      EXPECT_EQ(mesh.vertexCount(), shape.vertexCount()) << part.name;
      EXPECT_EQ(mesh.topology().components, 1) << part.name;
      EXPECT_EQ(mesh.topology().boundaryLoops, 0) << part.name;
      EXPECT_EQ(mesh.topology().genus, part.genus) << part.name;
      EXPECT_EQ(mesh.repairs().flippedTriangles, 0) << part.name;
      EXPECT_EQ(mesh.repairs().splitVertices, 0) << part.name;
      for (int f = 0; f < mesh.faceCount(); ++f) EXPECT_GT(mesh.faceArea(f), 1e-6) << part.name;
    }
  }
}

/// The areas of caps and walls, by hand.
TEST(MechanicalShapes, HaveTheAreasOfTheirWalls) {
  const Outline square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Outline hole = {{0.5, 0.5}, {0.5, 1}, {1, 1}, {1, 0.5}};
  EXPECT_DOUBLE_EQ(prism({square}, 3).mesh().area(), 2 * 4 + 3 * 8);
  EXPECT_DOUBLE_EQ(prism({square, hole}, 3).mesh().area(), 2 * (4 - 0.25) + 3 * (8 + 2));
  EXPECT_DOUBLE_EQ(boxes({{{0, 1, 3}, {0, 2}, {0, 5}}}, {{0, 0, 0}, {1, 0, 0}}).mesh().area(),
                   2 * (3 * 2 + 3 * 5 + 2 * 5));
}

}  // namespace
}  // namespace gvd::shapes
