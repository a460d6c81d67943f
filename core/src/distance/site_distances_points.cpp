// SPDX-License-Identifier: MIT
//
// SiteDistances::distancesAt: distances of labels at points that other labels own.
#include <span>

#include "base/sorting.h"
#include "distance/face_layout.h"
#include "distance/site_distances.h"
#include "mesh/surface_geometry.h"

namespace gvd {

/// A point on an edge in terms of the same face, wherever it comes from.
SurfacePoint SiteDistances::unique(const SurfacePoint& p) const {
  const int side = incidenceOf(p.bary).side;
  if (side < 0 || mesh_.twin(3 * p.face + side) < 0) return p;
  const SurfacePoint across = acrossEdge(mesh_, p, 3 * p.face + side);
  return across.face < p.face ? across : p;
}

/// Answers from what has been found, or else lets the labels go on to the points, one after the
/// other.
std::vector<double> SiteDistances::distancesAt(std::span<const LabelledPoint> points) const {
  std::vector<double> distances;
  distances.reserve(points.size());
  struct Open {
    LabelledPoint at;
    int index;
    double nearest;
  };
  std::vector<Open> open;
  SurfacePoint last;
  double nearestThere = kInfinity;
  for (const auto& [label, point] : points) {
    requireOnMesh(mesh_, point);
    const LabelledPoint p = {label, unique(point)};
    distances.push_back(found_.find(p));
    if (distances.back() < kInfinity) continue;
    distances.back() = boundAt(label, p.point);
    if (!hasOpenDistances_ || distances.back() == kInfinity) continue;
    if (p.point.bary.maxCoeff() == 1) continue;  // final already
    if (last.face != p.point.face || last.bary != p.point.bary) {
      nearestThere = nearest(p.point).distance;
      last = p.point;
    }
    open.push_back({p, static_cast<int>(distances.size()) - 1, nearestThere});
  }
  sortStably(std::span(open), [](const Open& a, const Open& b) { return a.at.label < b.at.label; });
  std::vector<RequiredPoint> required;
  std::vector<double*> answers;
  for (size_t begin = 0, end; begin < open.size(); begin = end) {
    const int label = open[begin].at.label;
    required.clear();
    answers.clear();
    for (end = begin; end < open.size() && open[end].at.label == label; ++end) {
      double& known = distances[open[end].index];
      // The nearest label has come to what it owns.
      if (isAtMost(known, open[end].nearest)) continue;
      required.push_back({open[end].at.point, known, open[end].nearest});
      answers.push_back(&known);
    }
    if (!required.empty()) spread_->require(label, required);
    for (size_t i = 0; i < required.size(); ++i) *answers[i] = required[i].distance;
  }
  for (const Open& o : open) found_.add(o.at, distances[o.index]);
  return distances;
}

}  // namespace gvd
