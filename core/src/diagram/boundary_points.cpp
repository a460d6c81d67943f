// SPDX-License-Identifier: MIT
#include "diagram/boundary_points.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "base/grouping.h"
#include "base/sorting.h"

namespace gvd {

void BoundaryPoints::order() {
  auto& boundary = graph_.boundary;
  const auto part = [](const BisectorGraph::BoundaryPoint& b) {
    return std::pair(b.halfedge, b.start);
  };
  sortStably(std::span(boundary), [&](const auto& a, const auto& b) { return part(a) < part(b); });
  forEachRun(
      std::span(boundary), [&](const auto& a, const auto& b) { return part(a) == part(b); },
      [](std::span<BisectorGraph::BoundaryPoint> run) { chain(run); });
  for (int i = 0; i < static_cast<int>(boundary.size()); ++i)
    indices_.push_back({boundary[i].point, i});
  sortStably(std::span(indices_), std::less<>());
}

/// Puts boundary points at one place in the order of the exact graph, which rounding may have
/// reversed in their coordinates: the region before a point is the region after the previous one.
void BoundaryPoints::chain(std::span<BisectorGraph::BoundaryPoint> points) {
  const auto isFirst = [&](const auto& p) {
    return std::none_of(points.begin(), points.end(),
                        [&](const auto& other) { return other.after == p.before; });
  };
  std::iter_swap(points.begin(), std::find_if(points.begin(), points.end(), isFirst));
  for (size_t i = 1; i < points.size(); ++i)
    std::iter_swap(points.begin() + i,
                   std::find_if(points.begin() + i, points.end(),
                                [&](const auto& p) { return p.before == points[i - 1].after; }));
}

int BoundaryPoints::indexOf(int point) const {
  const auto place = std::lower_bound(indices_.begin(), indices_.end(), std::array{point, 0});
  if (place == indices_.end() || (*place)[0] != point)
    throw std::logic_error("a region's outline ends inside the mesh");
  return (*place)[1];
}

int BoundaryPoints::firstOn(int halfedge) const {
  const auto& boundary = graph_.boundary;
  const auto first =
      std::lower_bound(boundary.begin(), boundary.end(), halfedge,
                       [](const auto& b, int wanted) { return b.halfedge < wanted; });
  const bool isThere = first != boundary.end() && first->halfedge == halfedge;
  return isThere ? static_cast<int>(first - boundary.begin()) : -1;
}

int BoundaryPoints::nextOnHalfedge(int index) const {
  const auto& boundary = graph_.boundary;
  const int next = index + 1;
  const bool isThere = next < static_cast<int>(boundary.size()) &&
                       boundary[next].halfedge == boundary[index].halfedge;
  return isThere ? next : -1;
}

}  // namespace gvd
