// SPDX-License-Identifier: MIT
#include "mesh/triangle_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>

#include "gvd/error.h"

namespace gvd {
namespace {

/// A hash of a position, from 0 to below `count`; the same for -0 and 0.
int hashOf(const Eigen::Vector3d& p, int count) {
  std::uint64_t hash = 0;
  for (const double x : p) {
    const double unsignedZero = x + 0.0;
    std::uint64_t bits;
    std::memcpy(&bits, &unsignedZero, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15;
    hash ^= hash >> 32;
  }
  return static_cast<int>((hash & 0xFFFFFFFF) * static_cast<std::uint64_t>(count) >> 32);
}

Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace

VertexWelding::VertexWelding(std::span<const double> positions, std::span<const int> triangles,
                             double weld)
    : positions_(positions),
      triangles_(triangles),
      weld_(weld),
      least_(Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity())),
      most_(-least_) {}

bool VertexWelding::step(long& budget) {
  const int count = static_cast<int>(positions_.size() / 3);
  return sequence_.run(
      [&] { return fillInSlices(representative_, count, -1, budget); },
      [&] {
        return places_.run(
            count, count, [&](int v) { return placeGroup(v); }, budget);
      },
      [&] {
        return loop_.run(count, budget, 4, [&](int group) { weldGroup(places_.items(group)); });
      },
      [&] {
        places_ = {};
        return weld_ == 0 || loop_.run(triangles_.size(), budget, kQuickRounds,
                                       [&](int i) { addToBox(triangles_[i]); });
      },
      [&] { openGrid(); },
      [&] { return !keptVertices_ || loop_.run(count, budget, 1, [&](int v) { weldToNear(v); }); });
}

Eigen::Vector3d VertexWelding::position(int v) const {
  return Eigen::Vector3d::Map(&positions_[3 * static_cast<std::size_t>(v)]);
}

int VertexWelding::placeGroup(int v) const {
  const Eigen::Vector3d p = position(v);
  return p.allFinite() ? hashOf(p, static_cast<int>(representative_.size())) : -1;
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

void VertexWelding::addToBox(int v) {
  const Eigen::Vector3d p = position(v);
  if (!p.allFinite()) return;
  least_ = least_.cwiseMin(p);
  most_ = most_.cwiseMax(p);
}

void VertexWelding::openGrid() {
  const double tolerance = weld_ * (most_ - least_).norm();
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  if (weld_ >= kRounding && tolerance > 0 && std::isfinite(tolerance))
    keptVertices_.emplace(positions_, tolerance);
}

void VertexWelding::weldToNear(int v) {
  int& same = representative_[v];
  if (same != v) {  // not finite, or at the position of an earlier vertex
    if (same >= 0) same = representative_[same];
    return;
  }
  const int near = keptVertices_->firstNear(position(v));
  if (near >= 0)
    same = near;
  else
    keptVertices_->add(v);
}

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
