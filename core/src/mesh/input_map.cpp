// SPDX-License-Identifier: MIT
#include "mesh/input_map.h"

#include <algorithm>

#include "mesh/triangle_selection.h"

namespace gvd {

bool InputMap::step(long& budget) {
  const std::size_t vertices = representative_.size();
  const auto forTriangles = [&](long perUnit, auto body) {
    return loop_.run(corners_.size(), budget, perUnit, body);
  };
  return sequence_.run(
      // Of each degenerate triangle, a face with corners at both of its positions.
      [&] {
        return forTriangles(4, [&](int t) {
          if (isSought(t)) faceWith_.emplace(ends(t), -1);
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
                 if (isSought(t)) kept_[t] = faceWith_.at(ends(t));
               });
      },
      [&] {
        faceWith_.clear();
        return forTriangles(kQuickRounds, [&](int t) { mapCorners(t); });
      },
      [&] { return fillInSlices(ofVertex_, vertices, -1, budget); },
      [&] { return fillInSlices(ofRepresentative_, vertices, -1, budget); },
      [&] {
        release(kept_);
        return loop_.run(triangles_.size(), budget, kQuickRounds, [&](int i) { mapVertexOf(i); });
      },
      [&] { return loop_.run(vertices, budget, kQuickRounds, [&](int v) { mapVertex(v); }); });
}

bool InputMap::isSought(int t) const { return isFinite(corners_[t]) && isDegenerate(corners_[t]); }

std::pair<int, int> InputMap::ends(int t) const {
  const auto [low, high] = std::minmax_element(corners_[t].begin(), corners_[t].end());
  return {*low, *high};
}

void InputMap::offer(int a, int b, int face) {
  const auto sought = faceWith_.find(std::minmax(a, b));
  if (sought != faceWith_.end() && sought->second < 0) sought->second = face;
}

void InputMap::mapCorners(int t) {
  Corners& corners = corners_[t];
  if (kept_[t] < 0) {
    corners = {-1, -1, -1};
    return;
  }
  const Corners& face = faces_[kept_[t]];
  for (int& corner : corners) {
    const auto at = std::find(face.begin(), face.end(), corner);
    corner = 3 * kept_[t] + static_cast<int>(at - face.begin());
  }
}

void InputMap::mapVertexOf(int corner) {
  const int h = corners_[corner / 3][corner % 3];
  if (h < 0) return;
  const int vertex = triangles_[corner];
  for (int* slot : {&ofVertex_[vertex], &ofRepresentative_[representative_[vertex]]})
    if (*slot < 0) *slot = h;
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
