// SPDX-License-Identifier: MIT
#include "mesh/input_map.h"

#include <algorithm>

#include "mesh/triangle_selection.h"

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
  const std::size_t vertices = representative_.size();
  const auto forTriangles = [&](long perUnit, auto body) {
    return loop_.run(kept_.size(), budget, perUnit, body);
  };
  return sequence_.run(
      // Finds, for each degenerate triangle, a face with corners at both of its positions.
      [&] {
        return forTriangles(8, [&](int t) {
          if (const Corners corners = welded()[t]; isSought(corners))
            faceWith_.emplace(endsOf(corners), -1);
        });
      },
      [&] {
        return faceWith_.empty() || loop_.run(3 * faces_.size(), budget, 4, [&](int h) {
          offer(tailOf(faces_, h), tailOf(faces_, h), h / 3);
          offer(tailOf(faces_, h), tipOf(faces_, h), h / 3);
        });
      },
      [&] {
        return faceWith_.empty() || forTriangles(4, [&](int t) {
                 if (const Corners corners = welded()[t]; isSought(corners))
                   kept_[t] = faceWith_.at(endsOf(corners));
               });
      },
      [&] {
        faceWith_.clear();
        return fillInSlices(ofVertex_, vertices, -1, budget);
      },
      [&] { return fillInSlices(ofRepresentative_, vertices, -1, budget); },
      [&] { return forTriangles(8, [&](int t) { mapTriangle(t); }); },
      [&] { return loop_.run(vertices, budget, kQuickRounds, [&](int v) { mapVertex(v); }); });
}

void InputMap::offer(int a, int b, int face) {
  const auto sought = faceWith_.find(std::minmax(a, b));
  if (sought != faceWith_.end() && sought->second < 0) sought->second = face;
}

void InputMap::mapTriangle(int t) {
  int* const corners = &triangles_[3 * static_cast<std::size_t>(t)];
  for (int* corner = corners; corner < corners + 3; ++corner) {
    const int vertex = std::exchange(*corner, -1);
    if (kept_[t] < 0) continue;
    const Corners& face = faces_[kept_[t]];
    const int representative = representative_[vertex];
    const auto at = std::find(face.begin(), face.end(), representative);
    *corner = 3 * kept_[t] + static_cast<int>(at - face.begin());
    for (int* slot : {&ofVertex_[vertex], &ofRepresentative_[representative]})
      if (*slot < 0) *slot = *corner;
  }
}

void InputMap::mapVertex(int v) {
  const int representative = representative_[v];
  if (ofVertex_[v] < 0 && representative >= 0) ofVertex_[v] = ofRepresentative_[representative];
  if (ofVertex_[v] < 0)
    ++repairs_.isolatedVertices;
  else if (representative != v)
    ++repairs_.weldedVertices;
}

}  // namespace gvd
