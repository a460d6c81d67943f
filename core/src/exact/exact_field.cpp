// SPDX-License-Identifier: MIT
#include "exact/exact_field.h"

#include <algorithm>
#include <utility>

#include "exact/exact_departure.h"

namespace gvd::exact {

Field::Field(const TriangleMesh& mesh, std::vector<SurfacePoint> sites, std::vector<Frame> frames,
             WindowPool windows, std::vector<FaceSite> faceSites, VertexTable table,
             std::vector<int> offset, std::vector<LabelledDistance> values)
    : mesh_(mesh),
      sites_(std::move(sites)),
      frames_(std::move(frames)),
      windows_(std::move(windows)),
      faceSites_(std::move(faceSites)),
      table_(std::move(table)),
      offset_(std::move(offset)),
      values_(std::move(values)) {}

std::span<const LabelledDistance> Field::at(int vertex) const {
  return {values_.data() + offset_[vertex], values_.data() + offset_[vertex + 1]};
}

bool Field::isKnownAt(int vertex, int label) const {
  for (const LabelledDistance& d : at(vertex))
    if (d.label == label) return true;
  return false;
}

template <class Visit>
void Field::visitPathsInFace(const SurfacePoint& p, Visit visit) const {
  const Frame& frame = frames_[p.face];
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d q = layOut(frame, i, p.bary);
    const double toCorner = q.norm();
    for (const LabelledDistance& d : at(frame.vertex[i])) visit(d.label, d.distance + toCorner);
    for (int w = frame.firstWindow[i]; w >= 0; w = windows_[w].next)
      visit(windows_[w].label, windows_[w].distance(q.x(), q.y()));
  }
  for (int s = frame.firstSite; s >= 0; s = faceSites_[s].next)
    visit(faceSites_[s].label, layOut(frame, 0, p.bary - faceSites_[s].bary).norm());
}

template <class Visit>
void Field::visitPaths(const SurfacePoint& p, Visit visit) const {
  const Place place = placeOf(p.bary);
  if (place.corner >= 0) {
    for (const LabelledDistance& d : at(frames_[p.face].vertex[place.corner]))
      visit(d.label, d.distance);
    return;
  }
  visitPathsInFace(p, visit);
  if (place.side >= 0 && frames_[p.face].twin[place.side] >= 0)
    visitPathsInFace(acrossEdge(mesh_, p, 3 * p.face + place.side), visit);
}

LabelledDistance Field::nearest(const SurfacePoint& p) const {
  LabelledDistance best;
  double runnerUp = kInfinity;  // of another label
  visitPaths(p, [&](int label, double distance) {
    if (label == best.label) {
      best.distance = std::min(best.distance, distance);
    } else if (distance < best.distance) {
      runnerUp = best.distance;
      best = {label, distance};
    } else {
      runnerUp = std::min(runnerUp, distance);
    }
  });
  const double tie = best.distance * (1 + kDistanceTolerance);
  if (runnerUp > tie || best.label < 0) return best;
  // What ties here may differ by more than rounding elsewhere, where only the nearer one is known.
  bool isBestKnown = isKnownAround(p, best.label);
  visitPaths(p, [&](int label, double distance) {
    if (distance > tie || label == best.label) return;
    const bool isKnown = isKnownAround(p, label);
    if (isKnown != isBestKnown ? !isKnown : label > best.label) return;
    best.label = label;
    isBestKnown = isKnown;
  });
  return best;
}

/// Whether a label is known at all corners around a point, so that its distance there is.
bool Field::isKnownAround(const SurfacePoint& p, int label) const {
  for (int i = 0; i < 3; ++i)
    if (p.bary[i] > 0 && !isKnownAt(frames_[p.face].vertex[i], label)) return false;
  return true;
}

double Field::distance(int label, const SurfacePoint& p) const {
  if (!isKnownAround(p, label)) return kInfinity;
  double least = kInfinity;
  visitPaths(p, [&](int pathLabel, double distance) {
    if (pathLabel == label) least = std::min(least, distance);
  });
  return least;
}

Eigen::Vector2d Field::direction(int label, int vertex) const {
  if (!isKnownAt(vertex, label)) return DistanceField::direction(label, vertex);
  return departure(mesh_, sites_[label], frames_, windows_, table_, table_.find(vertex, label));
}

}  // namespace gvd::exact
