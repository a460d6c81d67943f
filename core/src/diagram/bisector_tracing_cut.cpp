// SPDX-License-Identifier: MIT
// Elements with a straight cut between two cells, as most mixed ones are: what
// `BisectorTracing::addPoints` and `addCells` do for any number of cells, from a table instead of
// lists: an eighth less time for all of the tracing where sites are many.
#include <array>

#include "diagram/bisector_tracing.h"

namespace gvd {
namespace {

/// The outlines of the two cells of a cut, as `FaceEnvelope::build` makes them: 0 to 2 are corners,
/// 3 to 5 the crossings of the sides from these.
struct CutOutlines {
  struct Outline {
    std::array<int, 4> points{};
    int count = 0;
    constexpr void add(int point) { points[count++] = point; }
  };
  Outline low, high;
  int enter = 0,
      leave = 0;  ///< the crossings where a way around comes to the high cell, and leaves it
};

/// `mask` has a bit for each corner of the high cell.
constexpr CutOutlines cutOutlines(int mask) {
  CutOutlines outlines;
  if (mask == 0 || mask == 7) return outlines;
  for (int i = 0; i < 3; ++i) {
    const bool isHigh = mask >> i & 1, nextIsHigh = mask >> (i + 1) % 3 & 1;
    (isHigh ? outlines.high : outlines.low).add(i);
    if (isHigh == nextIsHigh) continue;
    outlines.low.add(3 + i);
    outlines.high.add(3 + i);
    (nextIsHigh ? outlines.enter : outlines.leave) = 3 + i;
  }
  return outlines;
}

constexpr std::array<CutOutlines, 8> kCutOutlines = {cutOutlines(0), cutOutlines(1), cutOutlines(2),
                                                     cutOutlines(3), cutOutlines(4), cutOutlines(5),
                                                     cutOutlines(6), cutOutlines(7)};

}  // namespace

bool BisectorTracing::hasUnmatchedSide(int element) const {
  const int* const twin = &twin_[3 * element];
  return (twin[0] < 0) | (twin[1] < 0) | (twin[2] < 0);
}

void BisectorTracing::addCut(const Element& element, const FaceEnvelope::Cut& cut) {
  const CutOutlines& outlines =
      kCutOutlines[cut.isHigh[0] | cut.isHigh[1] << 1 | cut.isHigh[2] << 2];
  std::array<Corner, 6> corners;
  const auto setCorner = [&](int i) {
    for (int j = 0; j < 3; ++j) corners[i].bary[j] = i == j;
    corners[i].point = pointOfNode(element, tail_[3 * element.index + i], corners[i].bary);
  };
  const auto setCrossing = [&](int i) {
    const int j = i < 2 ? i + 1 : 0;
    const auto &a = value(cut.low), &b = value(cut.high);
    const double share = crossing(a[i], b[i], a[j], b[j]);
    Corner& corner = corners[3 + i];
    corner.bary[i] = 1 - share;
    corner.bary[j] = share;
    corner.bary[3 - i - j] = 0;
    const std::array<int, 3> functions = {cut.functionAt(i), cut.functionAt(j), -1};
    corner.point = pointOnSide(element, {FaceEnvelope::Vertex::kOnSide, i, functions}, corner.bary);
  };
  for (int i = 0; i < outlines.low.count; ++i) {
    const int p = outlines.low.points[i];
    p < 3 ? setCorner(p) : setCrossing(p - 3);
  }
  for (int i = 0; i < 3; ++i)
    if (cut.isHigh[i]) setCorner(i);

  const auto addCell = [&](const CutOutlines::Outline& outline, int function) {
    double area = 0;
    const Eigen::Vector3d& origin = corners[outline.points[0]].bary;
    for (int i = 0; i < outline.count; ++i)
      graph_.cells.points.push_back(corners[outline.points[i]].point);
    for (int i = 1; i + 1 < outline.count; ++i) {
      const Eigen::Vector3d &p = corners[outline.points[i]].bary,
                            &q = corners[outline.points[i + 1]].bary;
      area += (p[0] - origin[0]) * (q[1] - origin[1]) - (p[1] - origin[1]) * (q[0] - origin[0]);
    }
    graph_.closeCell(element.face, label(function));
    return area;
  };
  const double low = addCell(outlines.low, cut.low);
  std::array<double, 2> areas = {low, addCell(outlines.high, cut.high)};
  addSegment(element, corners[outlines.enter], corners[outlines.leave], label(cut.low),
             label(cut.high));
  addAreas(areas, mesh_.faceArea(element.face));
}

}  // namespace gvd
