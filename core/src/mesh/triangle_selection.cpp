// SPDX-License-Identifier: MIT
#include "mesh/triangle_selection.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <string>

#include "gvd/error.h"
#include "mesh/counting_sort.h"

namespace gvd {
namespace {

[[noreturn]] void rejectMesh(const std::string& why) { throw Error(ErrorCode::kInvalidMesh, why); }

/// For each of `candidates` (ascending) the first one that has the same three corners, in whichever
/// order.
std::vector<int> findOriginals(const std::vector<Corners>& corners,
                               const std::vector<int>& candidates, int vertexCount) {
  std::vector<Corners> sorted = corners;
  for (Corners& c : sorted) std::sort(c.begin(), c.end());
  std::vector<int> order = candidates;
  for (int i : {2, 1, 0}) {
    order = countingSort(order, vertexCount, [&](int t) { return sorted[t][i]; });
  }
  std::vector<int> original(corners.size(), -1);
  forEachRun(
      order, [&](int s, int t) { return sorted[s] == sorted[t]; },
      [&](std::span<const int> run) {
        for (int t : run) original[t] = run.front();
      });
  return original;
}

std::string whyNothingIsLeft(int count, const MeshRepairs& repairs) {
  if (count == 0) return "there are no triangles";
  return "no triangle is left: of " + std::to_string(count) + " triangles " +
         std::to_string(repairs.nonFiniteTriangles) + " have a corner that is not finite and " +
         std::to_string(repairs.degenerateTriangles) + " have two corners at one position";
}

}  // namespace

void requireIndexedTriangles(std::span<const double> positions, std::span<const int> triangles) {
  const auto requireTriples = [](std::size_t count, const std::string& what) {
    if (count % 3 != 0) {
      rejectMesh("there are " + std::to_string(count) + " " + what + ", not a multiple of three");
    }
    if (count > std::numeric_limits<int>::max()) rejectMesh("there are too many " + what);
  };
  requireTriples(positions.size(), "coordinates");
  requireTriples(triangles.size(), "vertex indices");
  const int vertexCount = static_cast<int>(positions.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] >= 0 && triangles[i] < vertexCount) continue;
    rejectMesh("triangle " + std::to_string(i / 3) + " has vertex index " +
               std::to_string(triangles[i]) + ", but there are " + std::to_string(vertexCount) +
               " vertices");
  }
}

std::vector<int> findRepresentatives(std::span<const double> positions) {
  struct Vertex {
    double x, y, z;
    int index;
    bool operator<(const Vertex& o) const {
      if (x != o.x) return x < o.x;
      if (y != o.y) return y < o.y;
      if (z != o.z) return z < o.z;
      return index < o.index;
    }
    bool samePosition(const Vertex& o) const { return x == o.x && y == o.y && z == o.z; }
  };
  std::vector<Vertex> vertices;
  vertices.reserve(positions.size() / 3);
  for (int v = 0; v < static_cast<int>(positions.size() / 3); ++v) {
    const Eigen::Vector3d p = Eigen::Vector3d::Map(&positions[3 * static_cast<std::size_t>(v)]);
    if (p.allFinite()) vertices.push_back({p.x(), p.y(), p.z(), v});
  }
  std::sort(vertices.begin(), vertices.end());

  std::vector<int> representative(positions.size() / 3, -1);
  const Vertex* first = nullptr;
  for (const Vertex& vertex : vertices) {
    if (!first || !vertex.samePosition(*first)) first = &vertex;
    representative[vertex.index] = first->index;
  }
  return representative;
}

bool isFinite(const Corners& corners) {
  return std::min({corners[0], corners[1], corners[2]}) >= 0;
}

bool isDegenerate(const Corners& corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

std::vector<Corners> weldCorners(std::span<const int> triangles,
                                 const std::vector<int>& representative) {
  std::vector<Corners> corners(triangles.size() / 3);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners[t][i] = representative[triangles[3 * t + i]];
  }
  return corners;
}

Selection selectTriangles(const std::vector<Corners>& welded, int vertexCount,
                          MeshRepairs& repairs) {
  const int count = static_cast<int>(welded.size());
  std::vector<int> candidates;
  candidates.reserve(count);
  for (int t = 0; t < count; ++t) {
    if (!isFinite(welded[t])) {
      ++repairs.nonFiniteTriangles;
    } else if (isDegenerate(welded[t])) {
      ++repairs.degenerateTriangles;
    } else {
      candidates.push_back(t);
    }
  }
  const std::vector<int> original = findOriginals(welded, candidates, vertexCount);

  Selection selection;
  selection.kept.assign(count, -1);
  for (int t : candidates) {
    if (original[t] == t) {
      selection.kept[t] = static_cast<int>(selection.input.size());
      selection.input.push_back(t);
      selection.corners.push_back(welded[t]);
    } else {
      selection.kept[t] = selection.kept[original[t]];
      ++repairs.duplicateTriangles;
    }
  }
  if (selection.input.empty()) rejectMesh(whyNothingIsLeft(count, repairs));
  return selection;
}

}  // namespace gvd
