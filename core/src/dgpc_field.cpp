// SPDX-License-Identifier: MIT
#include "dgpc_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface_geometry.h"

namespace gvd {

DgpcField::DgpcField(const TriangleMesh& mesh, std::vector<SurfacePoint> sites,
                     std::vector<int> offset, std::vector<LabelledDistance> values,
                     std::vector<View> views, std::vector<Eigen::Vector2d> departures)
    : mesh_(mesh),
      sites_(std::move(sites)),
      offset_(std::move(offset)),
      values_(std::move(values)),
      views_(std::move(views)),
      departures_(std::move(departures)) {}

std::span<const LabelledDistance> DgpcField::at(int vertex) const {
  return {values_.data() + offset_[vertex], values_.data() + offset_[vertex + 1]};
}

LabelledDistance DgpcField::nearest(const SurfacePoint& p) const {
  LabelledDistance best;
  double least = kInfinity;
  const int corner = p.bary[0] > 0 ? 0 : p.bary[1] > 0 ? 1 : 2;
  for (const LabelledDistance& candidate : at(mesh_.tail(3 * p.face + corner))) {
    const double value = interpolate(candidate.label, p);
    if (value < least) {
      least = value;
      best.label = candidate.label;
    }
  }
  if (best.label >= 0) best.distance = distanceFrom(best.label, p, least);
  return best;
}

double DgpcField::distance(int label, const SurfacePoint& p) const {
  const double value = interpolate(label, p);
  return value == kInfinity ? kInfinity : distanceFrom(label, p, value);
}

Eigen::Vector2d DgpcField::direction(int label, int vertex) const {
  const LabelledDistance* found = find(vertex, label);
  if (!found) return DistanceField::direction(label, vertex);
  const auto labels = at(vertex);
  const auto owner =
      std::min_element(labels.begin(), labels.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (found == &*owner) return views_[vertex].departure(mesh_, found->distance);
  return departures_[found - values_.data()];
}

const LabelledDistance* DgpcField::find(int vertex, int label) const {
  const auto labels = at(vertex);
  const auto it = std::lower_bound(labels.begin(), labels.end(), label,
                                   [](const LabelledDistance& d, int l) { return d.label < l; });
  return it != labels.end() && it->label == label ? &*it : nullptr;
}

/// The linear interpolant of squared distance, which decides between labels. Corners without weight
/// do not count, so that both faces of an edge give the same there.
double DgpcField::interpolate(int label, const SurfacePoint& p) const {
  double value = 0;
  for (int i = 0; i < 3; ++i) {
    if (p.bary[i] == 0) continue;
    const LabelledDistance* found = find(mesh_.tail(3 * p.face + i), label);
    if (!found) return kInfinity;
    value += p.bary[i] * found->distance * found->distance;
  }
  return value;
}

/// The distance itself: what the interpolant has too much is the same for every label,
/// Σ bᵢ bⱼ |eᵢⱼ|². In the site's own face the straight line is exact and free of cancellation.
double DgpcField::distanceFrom(int label, const SurfacePoint& p, double interpolated) const {
  const auto sides = squaredSides(mesh_, p.face);
  if (sites_[label].face == p.face)
    return std::sqrt(squaredDistance(sites_[label].bary, p.bary, sides));
  const double excess = p.bary[0] * p.bary[1] * sides[0] + p.bary[1] * p.bary[2] * sides[1] +
                        p.bary[2] * p.bary[0] * sides[2];
  return std::sqrt(std::max(0.0, interpolated - excess));
}

}  // namespace gvd
