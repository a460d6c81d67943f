// SPDX-License-Identifier: MIT
//
// How good a remesh is: angles and valences of its triangles, and how far it is from the surface.
#include "gvd/remesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "mesh/triangle_tree.h"

namespace gvd {
namespace {

using Eigen::Vector3d;
using Triangles = std::vector<TriangleTree::Triangle>;

/// In degrees; 0 for a triangle without area.
double leastAngle(const TriangleTree::Triangle& t) {
  double least = std::numbers::pi;
  for (int i = 0; i < 3; ++i) {
    const Vector3d u = t[(i + 1) % 3] - t[i], v = t[(i + 2) % 3] - t[i];
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return least * 180 / std::numbers::pi;
}

void measureAngles(const Triangles& triangles, RemeshQuality& quality) {
  quality.triangles = static_cast<int>(triangles.size());
  if (triangles.empty()) return;
  quality.minAngle = 180;
  for (const auto& triangle : triangles) {
    const double angle = leastAngle(triangle);
    quality.minAngle = std::min(quality.minAngle, angle);
    quality.meanMinAngle += angle / quality.triangles;
  }
}

/// A vertex is inside if as many triangles as neighbours are around it.
void measureValences(const PolygonTriangles& cut, int vertexCount, RemeshQuality& quality) {
  std::vector<std::set<int>> neighbours(vertexCount);
  std::vector<int> around(vertexCount, 0);
  for (const auto& triangle : cut.triangles)
    for (int i = 0; i < 3; ++i) {
      ++around[triangle[i]];
      neighbours[triangle[i]].insert({triangle[(i + 1) % 3], triangle[(i + 2) % 3]});
    }
  int inside = 0, regular = 0;
  for (int v = 0; v < vertexCount; ++v) {
    const int valence = static_cast<int>(neighbours[v].size());
    if (valence == 0 || valence != around[v]) continue;
    quality.minValence = inside == 0 ? valence : std::min(quality.minValence, valence);
    quality.maxValence = std::max(quality.maxValence, valence);
    regular += valence == 6;
    ++inside;
  }
  if (inside > 0) quality.regularShare = static_cast<double>(regular) / inside;
}

double farthestOfSurface(const TriangleMesh& surface, const TriangleTree& from) {
  double most = 0;
  for (int v = 0; v < surface.vertexCount(); ++v)
    most = std::max(most, from.distance(surface.position(v)));
  for (int f = 0; f < surface.faceCount(); ++f)
    most = std::max(most, from.distance(surface.position({f, Vector3d::Constant(1.0 / 3)})));
  return most;
}

/// Of the points of a regular grid on each triangle, not wider than `spacing`.
double farthestOf(const Triangles& triangles, double spacing, const TriangleTree& from) {
  constexpr int kMostSteps = 64;
  double most = 0;
  for (const auto& [a, b, c] : triangles) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int steps =
        static_cast<int>(std::clamp(std::ceil(longest / spacing), 1.0, double{kMostSteps}));
    for (int i = 0; i <= steps; ++i)
      for (int k = 0; i + k <= steps; ++k)
        most = std::max(most, from.distance((i * a + k * b + (steps - i - k) * c) / steps));
  }
  return most;
}

}  // namespace

RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh) {
  const PolygonTriangles cut = triangulate(remesh);
  Triangles coarse, fine;
  for (const auto& [a, b, c] : cut.triangles)
    coarse.push_back({remesh.positions[a], remesh.positions[b], remesh.positions[c]});
  for (int f = 0; f < surface.faceCount(); ++f)
    fine.push_back({surface.position(surface.tail(3 * f)),
                    surface.position(surface.tail(3 * f + 1)),
                    surface.position(surface.tail(3 * f + 2))});
  RemeshQuality quality;
  measureAngles(coarse, quality);
  measureValences(cut, static_cast<int>(remesh.positions.size()), quality);
  quality.hausdorff =
      std::max(farthestOfSurface(surface, TriangleTree(coarse)),
               farthestOf(coarse, surface.meanEdgeLength(), TriangleTree(std::move(fine))));
  return quality;
}

}  // namespace gvd
