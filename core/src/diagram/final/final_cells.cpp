// SPDX-License-Identifier: MIT
//
// Cells of a diagram: those of the bisector graph that have a width left after points were merged.
#include "diagram/final/final_cells.h"

#include <algorithm>
#include <utility>

namespace gvd {

bool FinalCells::step(long& budget) {
  const int count = graph_.cells.size();
  const auto faceOf = [&](int cell) { return complex_.faceIndex(graph_.cellFace[cell]); };
  if (points_.areThoseOfGraph() && complex_.hasFacesOnly()) {
    out_.cells = std::move(graph_.cells);
    out_.cellFace = std::move(graph_.cellFace);
    out_.cellLabel = std::move(graph_.cellLabel);
    return true;
  }
  return sequence_.run([&] { return byFace_.run(count, complex_.faceCount(), faceOf, budget); },
                       [&] {
                         out_.cells.offset.reserve(count + 1);
                         out_.cells.points.reserve(graph_.cells.points.size());
                         out_.cellFace.reserve(count);
                         out_.cellLabel.reserve(count);
                       },
                       [&] {
                         return byFace_.visitGroups(
                             [&](std::span<const int> cells) { addFace(cells); }, budget);
                       });
}

/// Adds the cells of a face, unless it is a region triangle after all.
void FinalCells::addFace(std::span<const int> cells) {
  std::vector<int>& points = out_.cells.points;
  const size_t firstCell = out_.cellFace.size(), firstPoint = points.size();
  for (const int cell : cells) addCell(cell);
  if (isRegionTriangle(firstCell, firstPoint)) {
    out_.faceLabel[complex_.faceIndex(out_.cellFace[firstCell])] = out_.cellLabel[firstCell];
    points.resize(firstPoint);
    out_.cells.offset.resize(firstCell + 1);
    out_.cellFace.resize(firstCell);
    out_.cellLabel.resize(firstCell);
  }
  for (size_t i = firstPoint; i < points.size(); ++i) points[i] = points_.number(points[i]);
}

/// Adds a cell with merged points, as points of the graph, unless it has no width left.
void FinalCells::addCell(int cell) {
  std::vector<int>& points = out_.cells.points;
  const size_t first = points.size();
  for (const int point : graph_.cells[cell]) {
    const int root = graph_.merging.root(point);
    if (points.size() == first || points.back() != root) points.push_back(root);
  }
  while (points.size() > first + 1 && points[first] == points.back()) points.pop_back();
  if (points.size() < first + 3) return points.resize(first);
  out_.cells.close();
  out_.cellFace.push_back(graph_.cellFace[cell]);
  out_.cellLabel.push_back(graph_.cellLabel[cell]);
}

/// Whether the cells and points added last are those of a region triangle.
bool FinalCells::isRegionTriangle(size_t firstCell, size_t firstPoint) const {
  const auto labels = std::span(out_.cellLabel).subspan(firstCell);
  const auto points = std::span(out_.cells.points).subspan(firstPoint);
  return !labels.empty() &&
         std::all_of(labels.begin(), labels.end(), [&](int l) { return l == labels[0]; }) &&
         std::all_of(points.begin(), points.end(), [&](int p) { return graph_.isNode(p); });
}

}  // namespace gvd
