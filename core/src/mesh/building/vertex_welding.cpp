// SPDX-License-Identifier: MIT
#include "mesh/building/vertex_welding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/hashing.h"
#include "mesh/given_triangles.h"

namespace gvd {

bool VertexWelding::step(long& budget) {
  const int count = static_cast<int>(positions_.size() / 3);
  return sequence_.run(
      [&] { return fillInSlices(representative_, count, -1, budget); },
      [&] {
        return places_.run(
            count, count, [&](int v) { return placeGroup(v); }, budget);
      },
      [&] { return places_.visitGroups([&](std::span<int> group) { weldGroup(group); }, budget); },
      [&] { places_ = {}; },
      forEach(weld_ == 0 ? 0 : triangles_.size(), budget, kQuickRounds,
              [&](int i) {
                if (const Eigen::Vector3d p = positionOf(positions_, triangles_[i]); p.allFinite())
                  box_.extend(p);
              }),
      [&] { openGrid(); },
      [&](SlicedLoop& loop) {
        return !keptVertices_ || loop.run(count, budget, 1, [&](int v) { weldToNear(v); });
      });
}

int VertexWelding::placeGroup(int v) const {
  const Eigen::Vector3d p = positionOf(positions_, v);
  return p.allFinite() ? hashBelow(static_cast<int>(representative_.size()), p) : -1;
}

void VertexWelding::weldGroup(std::span<int> vertices) {
  const auto place = [&](int v) { return &positions_[3 * static_cast<std::size_t>(v)]; };
  const auto isSame = [&](int u, int v) { return std::equal(place(u), place(u) + 3, place(v)); };
  if (vertices.size() > 1)
    std::sort(vertices.begin(), vertices.end(), [&](int u, int v) {
      const double *const p = place(u), *const q = place(v);
      return std::tie(p[0], p[1], p[2], u) < std::tie(q[0], q[1], q[2], v);
    });
  forEachRun(vertices, isSame, [&](std::span<const int> run) {
    for (const int v : run) representative_[v] = run.front();
  });
}

void VertexWelding::openGrid() {
  const double tolerance = weld_ * box_.diagonal().norm();
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  if (!(weld_ >= kRounding && tolerance > 0 && std::isfinite(tolerance))) return;
  tolerance_ = tolerance;
  keptVertices_.emplace(positions_, tolerance, positions_.size() / 3);
}

void VertexWelding::weldToNear(int v) {
  int& same = representative_[v];
  if (same != v) {  // not finite, or at the position of an earlier vertex
    if (same >= 0) same = representative_[same];
    return;
  }
  for (const int near : keptVertices_->near(positionOf(positions_, v))) same = std::min(same, near);
  if (same == v) keptVertices_->add(v);
}

}  // namespace gvd
