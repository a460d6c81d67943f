// SPDX-License-Identifier: MIT
#include "mesh/building/input_map.h"

#include <algorithm>
#include <cstdint>

namespace gvd {
namespace {

/// Whether a dropped triangle is only an edge or a vertex, which a face may contain.
bool isSought(const Corners& corners) { return isFinite(corners) && isDegenerate(corners); }

/// The two positions of a degenerate triangle.
std::pair<int, int> endsOf(const Corners& corners) {
  const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
  return {*low, *high};
}

}  // namespace

bool InputMap::step(long& budget) {
  const Faces& faces = selection_.faces;
  std::vector<int>& kept = selection_.kept;
  const std::size_t vertices = welded_.representative.size(), triangles = kept.size();
  const bool hasDegenerate = mesh_.repairs_.degenerateTriangles > 0;
  const auto forDegenerate = [&](long perUnit, auto body) {
    return forEach(hasDegenerate ? triangles : 0, budget, perUnit, [this, body](int t) {
      if (const Corners corners = welded_[t]; isSought(corners)) body(t, endsOf(corners));
    });
  };
  return sequence_.run(
      // Finds, for each degenerate triangle, a face with corners at both of its positions.
      forDegenerate(8, [&](int, const auto& ends) { faceWith_.emplace(ends, -1); }),
      forEach(hasDegenerate ? 3 * faces.size() : 0, budget, 4,
              [&](int h) {
                offer(tailOf(faces, h), tailOf(faces, h), h / 3);
                offer(tailOf(faces, h), tipOf(faces, h), h / 3);
              }),
      forDegenerate(4, [&](int t, const auto& ends) { kept[t] = faceWith_.at(ends); }),
      [&] { faceWith_.clear(); },
      [&] { return fillInSlices(mesh_.vertexOfInput_, vertices, -1, budget); },
      [&] { return fillInSlices(ofRepresentative_, vertices, -1, budget); },
      [&] { mesh_.droppedCorners_.reserve(triangles - faces.size()); },
      forEach(triangles, budget, 8, [&](int t) { mapTriangle(t); }),
      [&] {
        kept.resize(mesh_.droppedCorners_.size());
        kept.shrink_to_fit();
        mesh_.droppedFace_ = std::move(kept);
      },
      forEach(vertices, budget, kQuickRounds, [&](int v) { mapVertex(v); }));
}

void InputMap::offer(int a, int b, int face) {
  const auto sought = faceWith_.find(std::minmax(a, b));
  if (sought != faceWith_.end() && sought->second < 0) sought->second = face;
}

void InputMap::mapTriangle(int t) {
  const int face = selection_.kept[t];
  int corners = 0;
  for (int i = 0; face >= 0 && i < 3; ++i) {
    const int vertex = welded_.triangles[3 * static_cast<std::size_t>(t) + i];
    const int representative = welded_.representative[vertex];
    const Corners& ofFace = selection_.faces[face].vertices;
    const auto at = std::find(ofFace.begin(), ofFace.end(), representative);
    const int corner = static_cast<int>(at - ofFace.begin());
    for (int* slot : {&mesh_.vertexOfInput_[vertex], &ofRepresentative_[representative]})
      if (*slot < 0) *slot = 3 * face + corner;
    corners |= corner << (2 * i);
  }
  if (face >= 0 && selection_.input[face] == t) return;
  // In place: no more triangles are dropped than have been mapped.
  selection_.kept[mesh_.droppedCorners_.size()] = face;
  mesh_.droppedCorners_.push_back(static_cast<std::uint8_t>(corners));
}

void InputMap::mapVertex(int v) {
  const int representative = welded_.representative[v];
  int& halfedge = mesh_.vertexOfInput_[v];
  if (halfedge < 0 && representative >= 0) halfedge = ofRepresentative_[representative];
  if (halfedge < 0)
    ++mesh_.repairs_.isolatedVertices;
  else if (representative != v)
    ++mesh_.repairs_.weldedVertices;
}

}  // namespace gvd
