// SPDX-License-Identifier: MIT
//
// The C++ code of the README, as CMake takes it out of there.

#include "readme_snippet.h"

#include <gtest/gtest.h>

#include <numeric>

#include "shapes.h"

namespace gvd {

TEST(Readme, ItsFunctionMakesADiagram) {
  const TriangleMesh mesh = shapes::torus(20, 10).mesh();
  const Diagram diagram = diagramOf(mesh, 12);
  EXPECT_EQ(diagram.siteCount, 12);
  const double area = std::accumulate(diagram.regionArea.begin(), diagram.regionArea.end(), 0.0);
  EXPECT_NEAR(area, mesh.area(), 1e-9 * mesh.area());
}

}  // namespace gvd
