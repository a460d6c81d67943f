// SPDX-License-Identifier: MIT
//
// `coverComponents` and `bareComponents`: sites on every component.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/rejection.h"
#include "gvd/sampling.h"
#include "mesh/given_points.h"
#include "mesh/point_drawing.h"

namespace gvd {
namespace {

std::vector<int> countPerComponent(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<int> counts(mesh.topology().components, 0);
  for (const SurfacePoint& p : points)
    if (p.face != -1) ++counts[mesh.component(p.face)];
  return counts;
}

/// Draws points on the components that have fewer than `perComponent`, as many as they lack.
std::vector<SurfacePoint> drawMissing(const TriangleMesh& mesh, std::span<const int> counts,
                                      int perComponent, std::uint64_t seed) {
  std::vector<std::vector<int>> faces(counts.size());
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (const int c = mesh.component(f); counts[c] < perComponent) faces[c].push_back(f);
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> drawn;
  for (std::size_t c = 0; c < faces.size(); ++c) {
    std::vector<double> areas;
    for (const int f : faces[c]) areas.push_back(mesh.faceArea(f));
    const std::vector<double> sums = cumulative(areas);
    for (int i = counts[c]; i < perComponent; ++i) {
      drawn.push_back(drawPoint(random, sums));
      drawn.back().face = faces[c][drawn.back().face];
    }
  }
  return drawn;
}

}  // namespace

std::vector<SurfacePoint> coverComponents(const TriangleMesh& mesh,
                                          std::vector<SurfacePoint> points, int perComponent,
                                          int count, std::uint64_t seed) {
  requireCount(perComponent);
  const int components = mesh.topology().components;
  const std::int64_t needed = static_cast<std::int64_t>(perComponent) * components;
  if (needed > count)
    rejectArgument(std::to_string(perComponent) + " per component, of which the mesh has " +
                   std::to_string(components) + ", makes " + std::to_string(needed) +
                   " sites, more than the " + std::to_string(count) + " in all");
  points = allOnMesh(mesh, points, "point ");
  std::vector<int> counts = countPerComponent(mesh, points);
  const std::vector<SurfacePoint> missing = drawMissing(mesh, counts, perComponent, seed);
  std::int64_t surplus = std::accumulate(counts.begin(), counts.end(), std::int64_t{0}) +
                         static_cast<std::int64_t>(missing.size()) - count;
  // From the last to the first.
  std::vector<SurfacePoint> covering(missing.rbegin(), missing.rend());
  for (auto p = points.rbegin(); p != points.rend(); ++p) {
    if (surplus > 0 && p->face != -1 && counts[mesh.component(p->face)] > perComponent) {
      --counts[mesh.component(p->face)];
      --surplus;
    } else {
      covering.push_back(*p);
    }
  }
  std::reverse(covering.begin(), covering.end());
  return covering;
}

BareComponents bareComponents(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  const std::vector<int> counts = countPerComponent(mesh, allOnMesh(mesh, points, "point "));
  BareComponents bare;
  bare.components = static_cast<int>(std::count(counts.begin(), counts.end(), 0));
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (counts[mesh.component(f)] == 0) bare.area += mesh.faceArea(f);
  return bare;
}

}  // namespace gvd
