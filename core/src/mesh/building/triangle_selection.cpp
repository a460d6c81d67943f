// SPDX-License-Identifier: MIT
#include "mesh/building/triangle_selection.h"

#include <algorithm>
#include <string>

#include "base/rejection.h"

namespace gvd {

bool isFinite(const Corners& corners) {
  return std::min({corners[0], corners[1], corners[2]}) >= 0;
}

bool isDegenerate(const Corners& corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

bool TriangleSelection::step(long& budget) {
  const int count = welded_.size();
  const auto lowestCorner = [&](int t) {
    const Corners corners = welded_[t];
    return isDegenerate(corners) ? -1 : std::min({corners[0], corners[1], corners[2]});
  };
  return sequence_.run(
      [&] { return fillInSlices(out_.kept, count, -1, budget); },
      forEach(count, budget, kQuickRounds, [&](int t) { this->count(t); }),
      [&] { return byLowestCorner_.run(count, vertexCount_, lowestCorner, budget); },
      [&] {
        return byLowestCorner_.visitGroups([&](std::span<int> group) { findOriginals(group); },
                                           budget);
      },
      [&] {
        byLowestCorner_ = {};
        out_.input.reserve(originals_);
        out_.faces.reserve(originals_);
      },
      forEach(count, budget, kQuickRounds, [&](int t) { keep(t); }), [&] { requireAny(); });
}

void TriangleSelection::count(int t) {
  const Corners corners = welded_[t];
  if (!isFinite(corners))
    ++repairs_.nonFiniteTriangles;
  else if (isDegenerate(corners))
    ++repairs_.degenerateTriangles;
}

/// Notes for each triangle the first triangle with the same three corners, in any order. All given
/// ones have the same lowest corner.
void TriangleSelection::findOriginals(std::span<int> triangles) {
  const auto otherCorners = [&](int t) {
    const auto [a, b, c] = welded_[t];
    const int lowest = std::min({a, b, c}), highest = std::max({a, b, c});
    const int middle = a ^ b ^ c ^ lowest ^ highest;  // what is left of the three
    return std::pair(middle, highest);
  };
  std::sort(triangles.begin(), triangles.end(), [&](int a, int b) {
    return std::pair(otherCorners(a), a) < std::pair(otherCorners(b), b);
  });
  forEachRun(
      triangles, [&](int a, int b) { return otherCorners(a) == otherCorners(b); },
      [&](std::span<const int> run) {
        for (const int t : run) out_.kept[t] = run.front();
        ++originals_;
      });
}

void TriangleSelection::keep(int t) {
  int& kept = out_.kept[t];
  if (kept < 0) return;
  if (kept == t) {
    kept = static_cast<int>(out_.input.size());
    out_.input.push_back(t);
    TriangleMesh::Face& face = out_.faces.emplace_back();
    face.vertices = welded_[t];
    face.twins = {-1, -1, -1};
  } else {
    kept = out_.kept[kept];
    ++repairs_.duplicateTriangles;
  }
}

void TriangleSelection::requireAny() const {
  if (!out_.input.empty()) return;
  if (welded_.size() == 0) rejectMesh("there are no triangles");
  rejectMesh("no triangle is left of " + std::to_string(welded_.size()) + ": " +
             std::to_string(repairs_.nonFiniteTriangles) + " with a corner that is not finite, " +
             std::to_string(repairs_.degenerateTriangles) + " with two corners at one position");
}

}  // namespace gvd
