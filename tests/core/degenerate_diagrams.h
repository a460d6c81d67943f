// SPDX-License-Identifier: MIT
//
// For tests of diagrams that degenerate: places on small meshes, the combinatorics of a diagram,
// and the fixture that traces one by both metrics.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "diagram_checks.h"
#include "shapes.h"

namespace gvd {

using checks::isConsistent;
using shapes::centroid;
using Sites = std::vector<SurfacePoint>;
using Labels = std::vector<int>;

inline constexpr double kPi = std::numbers::pi;

/// Twelve equilateral triangles around vertex 0; face i covers the angles 60°·i to 60°·(i+1).
inline shapes::Shape doubleTurn() { return shapes::vertexFan(12, 4 * kPi); }

/// The point (x, y) of a mesh in the plane z = 0.
inline SurfacePoint inPlane(const TriangleMesh& mesh, double x, double y) {
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Eigen::Vector2d corner[3];
    for (int i = 0; i < 3; ++i)
      corner[i] = mesh.position(mesh.tail(3 * f + i)).head<2>() - Eigen::Vector2d(x, y);
    Eigen::Vector3d bary;
    for (int i = 0; i < 3; ++i) bary[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
    bary /= bary.sum();
    if (bary.minCoeff() >= -1e-12) {
      bary = bary.cwiseMax(0);
      return {f, bary / bary.sum()};
    }
  }
  ADD_FAILURE() << "(" << x << ", " << y << ") is not on the mesh";
  return {};
}

inline int loopCount(const Diagram& d, int label) {
  return static_cast<int>(std::count(d.loopLabel.begin(), d.loopLabel.end(), label));
}

/// The labels around every Voronoi point, sorted.
inline std::vector<Labels> meetings(const Diagram& d) {
  std::vector<Labels> labels;
  for (const auto& v : d.voronoiPoints) labels.push_back(v.labels);
  std::sort(labels.begin(), labels.end());
  return labels;
}

/// The pairs of labels that share an arc.
inline std::set<std::pair<int, int>> neighbours(const Diagram& d) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& [low, high] : d.arcLabels) pairs.insert({low, high});
  return pairs;
}

inline bool isClosed(const Diagram& d, int arc) {
  return d.arcs[arc].front() == d.arcs[arc].back();
}

inline Labels ascending(int count) { return checks::identity(count); }

/// Both metrics are tested; what only the exact one promises stands behind `isExact()`.
class Degenerate : public ::testing::TestWithParam<Metric> {
 protected:
  static bool isExact() { return GetParam() == Metric::kExact; }
  /// The diagram, consistent.
  Diagram diagram(const TriangleMesh& mesh, const Sites& sites) const {
    Diagram d = checks::trace(mesh, sites, GetParam()).diagram;
    EXPECT_TRUE(isConsistent(mesh, d));
    return d;
  }
  static void expectAreas(const TriangleMesh& mesh, const Diagram& d,
                          const std::vector<double>& shares) {
    ASSERT_EQ(d.regionArea.size(), shares.size());
    for (size_t l = 0; l < shares.size(); ++l)
      EXPECT_NEAR(d.regionArea[l] / mesh.area(), shares[l], 1e-9) << "region " << l;
  }
};

INSTANTIATE_TEST_SUITE_P(Metrics, Degenerate, ::testing::Values(Metric::kDgpc, Metric::kExact),
                         [](const auto& metric) {
                           return metric.param == Metric::kDgpc ? "Dgpc" : "Exact";
                         });

}  // namespace gvd
