// SPDX-License-Identifier: MIT
#include "mesh/input_map.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesh/triangle_selection.h"

namespace gvd {
namespace {

/// For each degenerate triangle, a face with corners at both of its positions, or -1; the other
/// entries of `face` stay.
void findFacesOfDegenerateTriangles(const std::vector<Corners>& triangles,
                                    const std::vector<Corners>& faces, std::vector<int>& face) {
  const auto isSought = [&](int t) { return isFinite(triangles[t]) && isDegenerate(triangles[t]); };
  const auto ends = [&](int t) {
    const auto [low, high] = std::minmax_element(triangles[t].begin(), triangles[t].end());
    return std::pair(*low, *high);
  };
  std::map<std::pair<int, int>, int> faceWith;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (isSought(t)) faceWith.emplace(ends(t), -1);
  }
  if (faceWith.empty()) return;

  const auto offer = [&](int a, int b, int f) {
    const auto sought = faceWith.find(std::minmax(a, b));
    if (sought != faceWith.end() && sought->second < 0) sought->second = f;
  };
  for (int h = 0; h < 3 * static_cast<int>(faces.size()); ++h) {
    offer(tailOf(faces, h), tailOf(faces, h), h / 3);
    offer(tailOf(faces, h), tipOf(faces, h), h / 3);
  }
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (isSought(t)) face[t] = faceWith.at(ends(t));
  }
}

}  // namespace

std::vector<Corners> mapInputCorners(const std::vector<Corners>& welded,
                                     const std::vector<Corners>& faces, std::vector<int> kept) {
  findFacesOfDegenerateTriangles(welded, faces, kept);
  std::vector<Corners> halfedges(welded.size(), {-1, -1, -1});
  for (std::size_t t = 0; t < welded.size(); ++t) {
    if (kept[t] < 0) continue;
    const Corners& corners = faces[kept[t]];
    for (int i = 0; i < 3; ++i) {
      const auto at = std::find(corners.begin(), corners.end(), welded[t][i]);
      halfedges[t][i] = 3 * kept[t] + static_cast<int>(at - corners.begin());
    }
  }
  return halfedges;
}

std::vector<int> mapInputVertices(std::span<const int> triangles,
                                  const std::vector<int>& representative,
                                  const std::vector<Corners>& halfedgesOfInput) {
  const std::size_t count = representative.size();
  std::vector<int> ofVertex(count, -1), ofRepresentative(count, -1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int h = halfedgesOfInput[i / 3][i % 3];
    if (h < 0) continue;
    for (int* slot : {&ofVertex[triangles[i]], &ofRepresentative[representative[triangles[i]]]}) {
      if (*slot < 0) *slot = h;
    }
  }
  for (std::size_t v = 0; v < count; ++v) {
    if (ofVertex[v] < 0 && representative[v] >= 0)
      ofVertex[v] = ofRepresentative[representative[v]];
  }
  return ofVertex;
}

void countInputVertices(const std::vector<int>& halfedgeOfVertex,
                        const std::vector<int>& representative, MeshRepairs& repairs) {
  for (int v = 0; v < static_cast<int>(representative.size()); ++v) {
    if (halfedgeOfVertex[v] < 0) {
      ++repairs.isolatedVertices;
    } else if (representative[v] != v) {
      ++repairs.weldedVertices;
    }
  }
}

}  // namespace gvd
