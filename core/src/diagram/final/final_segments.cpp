// SPDX-License-Identifier: MIT
#include "diagram/final/final_segments.h"

#include <algorithm>
#include <utility>

#include "mesh/incidence.h"

namespace gvd {

FinalSegments::FinalSegments(const TriangleMesh& mesh, BisectorGraph& graph,
                             std::span<const OutlineSteps::BoundaryStep> boundarySteps,
                             FinalPoints& points, Diagram& diagram)
    : mesh_(mesh), graph_(graph), boundarySteps_(boundarySteps), points_(points), out_(diagram) {
  out_.segments = std::move(graph.segments);
}

bool FinalSegments::step(long& budget) {
  constexpr long kSegmentsPerUnit = 8;
  const auto forSegments = [&](long perUnit, auto body) {
    return forItems(out_.segments, budget, perUnit, body);
  };
  if (points_.areThoseOfGraph()) return true;  // and so are the segments
  return sequence_.run(
      forSegments(kSegmentsPerUnit, [&](const Diagram::Segment& s) { addSegment(s); }),
      [&] { out_.segments.resize(kept_); },
      forItems(boundarySteps_, budget, 1,
               [&](const OutlineSteps::BoundaryStep& step) {
                 if (step.from != step.to) stack(step.from, step.to, step.label, -1, step.face);
               }),
      [&] { return addStacks(budget); },
      [&] { return fillInSlices(isInFaceOfSegment_, out_.points.size(), '\0', budget); },
      forSegments(kQuickRounds, [&](const Diagram::Segment& s) { noteInFace(s); }),
      forSegments(kQuickRounds, [&](const Diagram::Segment& s) { moveToFaceOf(s); }));
}

/// Keeps a segment, moved forward over dropped ones; if an end is merged, stacks it instead.
void FinalSegments::addSegment(const Diagram::Segment& segment) {
  const Diagram::Segment s = segment;
  const int from = graph_.merging.root(s.points[0]), to = graph_.merging.root(s.points[1]);
  if (from == to) return;
  if (graph_.merging.isMerged(from) || graph_.merging.isMerged(to)) {
    stack(from, to, s.labels[0], s.labels[1], s.face);
  } else {
    Diagram::Segment& kept = out_.segments[kept_++];
    kept = s;
    kept.points[0] = points_.number(from);
    kept.points[1] = points_.number(to);
  }
}

/// `right` is -1 on the mesh boundary.
void FinalSegments::stack(int from, int to, int left, int right, int face) {
  const bool isSwapped = to < from;
  stacks_[placeOfLine(graph_, from, to, face)].push_back(
      {isSwapped ? right : left, isSwapped ? left : right, face});
}

bool FinalSegments::addStacks(long& budget) {
  for (; !stacks_.empty() && budget > 0; --budget) {
    const auto lowest = stacks_.extract(stacks_.begin());
    addLines(lowest.key(), lowest.mapped());
  }
  return stacks_.empty();
}

/// Lines with no region in common are not joined, so several may remain.
void FinalSegments::addLines(const PlaceOfLine& place, std::vector<Line>& lines) {
  joinLines(lines);
  for (const auto& [left, right, face] : lines) {
    if (left < 0 || right < 0 || left == right) continue;
    const int first = points_.number(place[0]), second = points_.number(place[1]);
    if (left < right)
      out_.segments.push_back({{first, second}, {left, right}, face, -1});
    else
      out_.segments.push_back({{second, first}, {right, left}, face, -1});
  }
}

/// Joins two lines with the same region between them: the region has no width there.
void FinalSegments::joinLines(std::vector<Line>& lines) {
  for (size_t i = 0; i < lines.size();) {
    const int between = lines[i].right;
    const auto next = std::find_if(lines.begin(), lines.end(), [&](const Line& line) {
      return between >= 0 && line.left == between && &line != &lines[i];
    });
    if (next == lines.end()) {
      ++i;
      continue;
    }
    next->left = lines[i].left;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void FinalSegments::noteInFace(const Diagram::Segment& segment) {
  for (const int p : segment.points)
    if (out_.points[p].face == segment.face) isInFaceOfSegment_[p] = true;
}

void FinalSegments::moveToFaceOf(const Diagram::Segment& segment) {
  for (const int p : segment.points) {
    if (isInFaceOfSegment_[p]) continue;
    const bool isInFace = graph_.merging.anyMember(points_.root(p), [&](int member) {
      const auto place = pointInFace(mesh_, graph_.places[member], segment.face);
      if (place) out_.points[p] = *place;
      return place.has_value();
    });
    isInFaceOfSegment_[p] = static_cast<char>(isInFace);
  }
}

}  // namespace gvd
