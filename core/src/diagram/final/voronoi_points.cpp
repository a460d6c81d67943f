// SPDX-License-Identifier: MIT
//
// Voronoi points of a diagram: where three regions of the bisector graph meet, or more after points
// were merged.
#include "diagram/final/voronoi_points.h"

#include <algorithm>
#include <utility>

namespace gvd {

bool VoronoiPoints::step(long& budget) {
  constexpr long kPointsPerUnit = 8;
  const int merged = graph_.merging.limit();
  return sequence_.run(
      [&] { out_.voronoiPoints.reserve(graph_.inner.size()); },
      [&] { return merged == 0 || fillInSlices(isOnOutline_, graph_.points.size(), '\0', budget); },
      forEach(merged == 0 ? 0 : outlines_.size(), budget, 1, [&](int o) { collectSectors(o); }),
      [&] {
        return byPoint_.run(
            static_cast<int>(sectors_.size()), merged, [&](int s) { return sectors_[s].point; },
            budget);
      },
      forEach(graph_.points, budget, kPointsPerUnit, [&](int p) {
        if (graph_.merging.isMerged(p)) {
          addMerged(p);
        } else if (graph_.isInner(p) && graph_.merging.isRoot(p) && isOnOutline(p)) {
          const auto& labels = graph_.inner[graph_.points[p].index].labels;
          add(p, {labels.begin(), labels.end()});
        }
      }));
}

void VoronoiPoints::collectSectors(int outline) {
  const std::span<const int> points = outlines_.points(outline);
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) {
    isOnOutline_[points[i]] = true;
    if (!graph_.merging.isMerged(points[i])) continue;
    sectors_.push_back({points[i], outlines_.label(outline), points[i > 0 ? i - 1 : n - 1],
                        points[i + 1 < n ? i + 1 : 0]});
  }
}

void VoronoiPoints::addMerged(int point) {
  std::vector<Sector> sectors;
  int distinct = 0;  // the outlines, and so the sectors, are ascending by label
  for (const int s : byPoint_.items(point)) {
    if (sectors.empty() || sectors.back().label != sectors_[s].label) ++distinct;
    sectors.push_back(sectors_[s]);
  }
  if (distinct < 3) return;
  orderAround(sectors);
  std::vector<int> labels;
  labels.reserve(sectors.size());
  for (const Sector& s : sectors) labels.push_back(s.label);
  add(point, std::move(labels));
}

/// Orders sectors counterclockwise: each starts where the previous one ends. On the mesh boundary
/// the first sector starts where no other ends.
void VoronoiPoints::orderAround(std::span<Sector> sectors) {
  auto start = std::find_if(sectors.begin(), sectors.end(), [&](const Sector& s) {
    return std::none_of(sectors.begin(), sectors.end(),
                        [&](const Sector& other) { return other.before == s.after; });
  });
  if (start == sectors.end()) start = sectors.begin();
  std::swap(*start, sectors.front());
  size_t joinsLeft = sectors.size();  // there are not more rounds than sectors
  for (size_t i = 1; i < sectors.size(); ++i) {
    const auto next = std::find_if(sectors.begin() + i, sectors.end(), [&](const Sector& s) {
      return s.after == sectors[i - 1].before;
    });
    if (next != sectors.end()) {
      std::swap(*next, sectors[i]);
    } else if (joinsLeft > 0 && joinRounds(sectors.first(i), sectors.subspan(i))) {
      --joinsLeft;
      i = 0;
    }
  }
}

/// If a region comes to a point twice, its loops may pair the sides of its two sectors the wrong
/// way, so that the sectors form two rounds instead of one. Swapping the pairing joins them.
bool VoronoiPoints::joinRounds(std::span<Sector> chained, std::span<Sector> others) {
  for (Sector& a : chained)
    for (Sector& b : others)
      if (a.label == b.label) {
        std::swap(a.before, b.before);
        return true;
      }
  return false;
}

/// `labels` are counterclockwise.
void VoronoiPoints::add(int point, std::vector<int> labels) {
  std::rotate(labels.begin(), std::min_element(labels.begin(), labels.end()), labels.end());
  out_.voronoiPoints.push_back({points_.number(point), std::move(labels)});
}

}  // namespace gvd
