// SPDX-License-Identifier: MIT
#include "partition/side_points.h"

#include <algorithm>
#include <tuple>

#include "base/sorting.h"

namespace gvd {

bool SidePoints::step(long& budget) {
  return sequence_.run(forEach(diagram_.cells, budget, 2, [&](int cell) { collect(cell); }), [&] {
    sortStably(std::span(points_), [](const Point& a, const Point& b) {
      return std::tie(a.halfedge, a.order) < std::tie(b.halfedge, b.order);
    });
  });
}

std::span<const SidePoints::Point> SidePoints::next(int face) {
  const std::size_t first = next_;
  while (next_ < points_.size() && points_[next_].halfedge < 3 * (face + 1)) ++next_;
  return std::span(points_).subspan(first, next_ - first);
}

/// Collects the points on the sides of a mixed face, by its first cell; other cells are passed
/// over.
void SidePoints::collect(int firstCell) {
  const int face = diagram_.cellFace[firstCell];
  if (firstCell > 0 && diagram_.cellFace[firstCell - 1] == face) return;
  bool isGathered = false;
  for (int h = 3 * face; h < 3 * (face + 1); ++h) {
    const int twin = mesh_.twin(h);
    if (twin < 0 || diagram_.faceLabel[TriangleMesh::faceOf(twin)] == Diagram::kMixed) continue;
    if (!isGathered) gatherSides(firstCell);
    isGathered = true;
    followSide(h);
  }
}

void SidePoints::gatherSides(int firstCell) {
  sides_.clear();
  const int face = diagram_.cellFace[firstCell];
  for (int c = firstCell; c < diagram_.cells.size() && diagram_.cellFace[c] == face; ++c) {
    const auto cell = diagram_.cells[c];
    for (std::size_t i = 0; i < cell.size(); ++i)
      sides_.push_back({vertexOfPoint_[cell[i]], vertexOfPoint_[cell[(i + 1) % cell.size()]], 0});
  }
  std::sort(sides_.begin(), sides_.end());
}

/// Follows a mixed face's halfedge from its tail to its tip, along the sides of cells that have no
/// other cell of the face beyond. The points on the way are found by the cells that list them, not
/// by coordinates, because rounding may have put an inner point on the side.
void SidePoints::followSide(int h) {
  const int tip = mesh_.tip(h);
  int at = mesh_.tail(h);
  if (hasSide(at, tip)) return;
  for (int steps = 0; at != tip && steps < static_cast<int>(sides_.size()); ++steps) {
    const auto isFromHere = [&](auto side) { return side != sides_.end() && (*side)[0] == at; };
    auto next = std::lower_bound(sides_.begin(), sides_.end(), KeyedItem{at, -1, 0});
    while (isFromHere(next) && hasSide((*next)[1], at)) ++next;
    if (!isFromHere(next)) return;
    at = (*next)[1];
    if (at != tip) points_.push_back({mesh_.twin(h), -steps, at});
  }
}

bool SidePoints::hasSide(int from, int to) const {
  return std::binary_search(sides_.begin(), sides_.end(), KeyedItem{from, to, 0});
}

}  // namespace gvd
