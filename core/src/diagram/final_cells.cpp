// SPDX-License-Identifier: MIT
//
// Cells of a diagram: those of the bisector graph that have a width left after points were merged.
#include "diagram/final_cells.h"

#include <algorithm>
#include <utility>

namespace gvd {

bool FinalCells::step(long& budget) {
  return sequence_.run([&] { return putInOrder(budget); }, [&] { return collect(budget); });
}

/// The cells of the graph, ascending by face.
bool FinalCells::putInOrder(long& budget) {
  if (complex_.hasFacesOnly()) {
    out_.cells = std::move(graph_.cells);
    out_.cellFace = std::move(graph_.cellFace);
    out_.cellLabel = std::move(graph_.cellLabel);
    return true;
  }
  const int count = graph_.cells.size();
  const auto faceOf = [&](int cell) { return complex_.faceIndex(graph_.cellFace[cell]); };
  return order_.run([&] { return byFace_.run(count, complex_.faceCount(), faceOf, budget); },
                    [&] {
                      out_.cells.offset.reserve(count + 1);
                      out_.cells.points.reserve(graph_.cells.points.size());
                      out_.cellFace.reserve(count);
                      out_.cellLabel.reserve(count);
                    },
                    forEach(count, budget, 4, [&](int i) { copyCell(byFace_.items()[i]); }));
}

void FinalCells::copyCell(int cell) {
  out_.cells.add(graph_.cells[cell]);
  out_.cellFace.push_back(graph_.cellFace[cell]);
  out_.cellLabel.push_back(graph_.cellLabel[cell]);
}

bool FinalCells::collect(long& budget) {
  if (points_.areThoseOfGraph() && complex_.hasFacesOnly()) return true;
  const int count = out_.cells.size();
  for (; read_ < count && budget > 0; --budget) collectFace();
  if (read_ < count) return false;
  out_.cells.offset.resize(written_ + 1);
  out_.cells.points.resize(pointsWritten_);
  out_.cellFace.resize(written_);
  out_.cellLabel.resize(written_);
  return true;
}

/// Compacts the remaining cells of a face behind those of earlier faces.
void FinalCells::collectFace() {
  const int count = out_.cells.size(), face = out_.cellFace[read_];
  const int firstCell = written_, firstPoint = pointsWritten_;
  for (; read_ < count && out_.cellFace[read_] == face; ++read_) {
    const int end = out_.cells.offset[read_ + 1];
    addFinalPoints(read_, std::exchange(readBegin_, end), end);
  }
  if (isRegionTriangle(firstCell, firstPoint)) {
    out_.faceLabel[complex_.faceIndex(face)] = out_.cellLabel[firstCell];
    written_ = firstCell;
    pointsWritten_ = firstPoint;
  }
  for (int i = firstPoint; i < pointsWritten_; ++i)
    out_.cells.points[i] = points_.number(out_.cells.points[i]);
}

/// Adds a cell with merged points, unless it has no width left.
void FinalCells::addFinalPoints(int cell, int begin, int end) {
  std::vector<int>& points = out_.cells.points;
  const int first = pointsWritten_;
  int last = first;
  for (int i = begin; i < end; ++i) {
    const int p = graph_.merging.root(points[i]);
    if (last == first || points[last - 1] != p) points[last++] = p;
  }
  while (last > first + 1 && points[first] == points[last - 1]) --last;
  if (last < first + 3) return;
  pointsWritten_ = last;
  out_.cellFace[written_] = out_.cellFace[cell];
  out_.cellLabel[written_] = out_.cellLabel[cell];
  out_.cells.offset[++written_] = last;
}

bool FinalCells::isRegionTriangle(int firstCell, int firstPoint) const {
  if (written_ == firstCell) return false;
  const auto label = out_.cellLabel.begin(), points = out_.cells.points.begin();
  return std::all_of(label + firstCell, label + written_,
                     [&](int l) { return l == label[firstCell]; }) &&
         std::all_of(points + firstPoint, points + pointsWritten_,
                     [&](int p) { return graph_.isNode(p); });
}

}  // namespace gvd
