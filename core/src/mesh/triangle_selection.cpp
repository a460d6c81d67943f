// SPDX-License-Identifier: MIT
#include "mesh/triangle_selection.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "gvd/error.h"

namespace gvd {
namespace {

Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace

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
      [&] { return loop_.run(count, budget, kQuickRounds, [&](int t) { this->count(t); }); },
      [&] { return byLowestCorner_.run(count, vertexCount_, lowestCorner, budget); },
      [&] {
        return loop_.run(vertexCount_, budget, 4,
                         [&](int group) { findOriginals(byLowestCorner_.items(group)); });
      },
      [&] {
        byLowestCorner_ = {};
        out_.input.reserve(originals_);
        out_.corners.reserve(originals_);
        return loop_.run(count, budget, kQuickRounds, [&](int t) { keep(t); });
      },
      [&] { requireAny(); });
}

void TriangleSelection::count(int t) {
  const Corners corners = welded_[t];
  if (!isFinite(corners))
    ++repairs_.nonFiniteTriangles;
  else if (isDegenerate(corners))
    ++repairs_.degenerateTriangles;
}

/// Notes for each triangle the first triangle with the same three corners, in any order.
void TriangleSelection::findOriginals(std::span<int> triangles) {
  if (triangles.size() > 1)
    std::sort(triangles.begin(), triangles.end(), [&](int s, int t) {
      const Corners a = sorted(welded_[s]), b = sorted(welded_[t]);
      return std::tie(a, s) < std::tie(b, t);
    });
  forEachRun(
      triangles, [&](int s, int t) { return sorted(welded_[s]) == sorted(welded_[t]); },
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
    out_.corners.push_back(welded_[t]);
  } else {
    kept = out_.kept[kept];
    ++repairs_.duplicateTriangles;
  }
}

void TriangleSelection::requireAny() const {
  if (!out_.input.empty()) return;
  const int count = welded_.size();
  throw Error(ErrorCode::kInvalidMesh,
              count == 0 ? "there are no triangles"
                         : "no triangle is left: of " + std::to_string(count) + " triangles " +
                               std::to_string(repairs_.nonFiniteTriangles) +
                               " have a corner that is not finite and " +
                               std::to_string(repairs_.degenerateTriangles) +
                               " have two corners at one position");
}

}  // namespace gvd
