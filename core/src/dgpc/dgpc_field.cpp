// SPDX-License-Identifier: MIT
#include "dgpc/dgpc_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerances.h"
#include "dgpc/fan.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// The length of the path to a point of the face that a view comes through.
double distanceInOwnFace(const TriangleMesh& mesh, const View& view, const SurfacePoint& p) {
  const TriangleMesh::Layout& l = mesh.layout(view.halfedge);
  const int i = view.halfedge % 3;
  const double toTip = p.bary[(i + 1) % 3], toApex = p.bary[(i + 2) % 3];
  const Vector2d way = Vector2d(toTip * l.length + toApex * l.x, toApex * l.y) - view.source;
  const Sight<Side::kLeft> left(view);
  const Sight<Side::kRight> right(view);
  if (left.reaches(way) && right.reaches(way)) return view.offset + way.norm();
  const Vector2d& bound = left.reaches(way) ? right.bound() : left.bound();
  return view.offset + bound.norm() + (way - bound).norm();
}

}  // namespace

DgpcField::DgpcField(const TriangleMesh& mesh, std::vector<SurfacePoint> sites,
                     std::vector<LabelledDistance> nearest, std::vector<View> views)
    : mesh_(mesh),
      sites_(std::move(sites)),
      nearest_(std::move(nearest)),
      views_(std::move(views)),
      hasFarLabel_(mesh.vertexCount()),
      lists_(mesh.vertexCount()) {}

void DgpcField::setSite(int label, const SurfacePoint& site) {
  if (label >= static_cast<int>(sites_.size())) sites_.resize(label + 1);
  sites_[label] = site;
}

void DgpcField::setNearest(int vertex, const LabelledDistance& nearest, const View& view) {
  if (lists_[vertex].count == List::kNone) {
    const Vector2d none(0, 0);
    const auto known = at(vertex);
    setLabels(vertex, known, {&none, known.size()});
  }
  nearest_[vertex] = nearest;
  views_[vertex] = view;
}

void DgpcField::reserve(size_t labels) {
  values_.reserve(labels);
  departures_.reserve(labels);
}

void DgpcField::setLabels(int vertex, std::span<const LabelledDistance> labels,
                          std::span<const Vector2d> departures) {
  List& list = lists_[vertex];
  list.count = static_cast<int>(labels.size());
  if (list.count > list.room) {
    list.first = static_cast<int>(values_.size());
    list.room = list.count;
    values_.insert(values_.end(), labels.begin(), labels.end());
    departures_.insert(departures_.end(), departures.begin(), departures.end());
  } else {
    std::copy(labels.begin(), labels.end(), values_.begin() + list.first);
    std::copy(departures.begin(), departures.end(), departures_.begin() + list.first);
  }
}

void DgpcField::setLabel(int vertex, const LabelledDistance& label, const Vector2d& departure) {
  const auto here = at(vertex);
  std::vector<LabelledDistance> labels(here.begin(), here.end());
  std::vector<Vector2d> departures(here.size(), Vector2d(0, 0));
  if (const List& list = lists_[vertex]; list.count != List::kNone)
    std::copy_n(departures_.begin() + list.first, list.count, departures.begin());
  const auto place = std::lower_bound(labels.begin(), labels.end(), label.label,
                                      [](const LabelledDistance& d, int l) { return d.label < l; });
  const auto departurePlace = departures.begin() + (place - labels.begin());
  if (place != labels.end() && place->label == label.label) {
    *place = label;
    *departurePlace = departure;
  } else {
    labels.insert(place, label);
    departures.insert(departurePlace, departure);
  }
  setLabels(vertex, labels, departures);
}

std::span<const LabelledDistance> DgpcField::at(int vertex) const {
  const List& list = lists_[vertex];
  if (list.count == List::kNone) return {&nearest_[vertex], nearest_[vertex].label >= 0 ? 1u : 0u};
  return {values_.data() + list.first, static_cast<size_t>(list.count)};
}

LabelledDistance DgpcField::nearest(const SurfacePoint& p) const {
  LabelledDistance best;
  const int corner = p.bary[0] > 0 ? 0 : p.bary[1] > 0 ? 1 : 2;
  for (const LabelledDistance& candidate : at(mesh_.tail(3 * p.face + corner))) {
    const double here = distance(candidate.label, p);
    if (best.label < 0 ? here < kInfinity : here < best.distance * (1 - kDistanceTolerance))
      best = {candidate.label, here};
  }
  return best;
}

double DgpcField::distance(int label, const SurfacePoint& p) const {
  if (sites_[label].face == p.face)
    return std::sqrt(squaredDistance(sites_[label].bary, p.bary, squaredSides(mesh_, p.face)));
  double best = interpolate(label, p);
  if (best == kInfinity || p.bary.maxCoeff() == 1) return best;
  for (int h = 3 * p.face; h < 3 * p.face + 3; ++h)
    if (nearest_[mesh_.tail(h)].label == label) best = std::min(best, distanceSeenFrom(h, p));
  return best;
}

Vector2d DgpcField::direction(int label, int vertex) const {
  const LabelledDistance* found = find(vertex, label);
  if (!found) return DistanceField::direction(label, vertex);
  if (lists_[vertex].count != List::kNone) {
    const Vector2d& departure = departures_[found - values_.data()];
    if (departure != Vector2d(0, 0) || nearest_[vertex].label != label) return departure;
  }
  return views_[vertex].departure(mesh_, found->distance);
}

const LabelledDistance* DgpcField::find(int vertex, int label) const {
  const auto labels = at(vertex);
  const auto it = std::lower_bound(labels.begin(), labels.end(), label,
                                   [](const LabelledDistance& d, int l) { return d.label < l; });
  return it != labels.end() && it->label == label ? &*it : nullptr;
}

/// From the linear interpolant of squared distance, by which a diagram tells labels apart: what
/// that has too much is the same for every label, Σ bᵢ bⱼ |eᵢⱼ|². Corners without weight do not
/// count, so that both faces of an edge give the same there.
double DgpcField::interpolate(int label, const SurfacePoint& p) const {
  double value = 0;
  for (int i = 0; i < 3; ++i) {
    if (p.bary[i] == 0) continue;
    const LabelledDistance* found = find(mesh_.tail(3 * p.face + i), label);
    if (!found) return kInfinity;
    value += p.bary[i] * found->distance * found->distance;
  }
  const auto sides = squaredSides(mesh_, p.face);
  const double excess = p.bary[0] * p.bary[1] * sides[0] + p.bary[1] * p.bary[2] * sides[1] +
                        p.bary[2] * p.bary[0] * sides[2];
  return std::sqrt(std::max(0.0, value - excess));
}

/// The distance of the label that owns a corner of a face, as that corner's view shows it at a
/// point of the face; over the corner if the view does not reach it.
double DgpcField::distanceSeenFrom(int corner, const SurfacePoint& p) const {
  const int v = mesh_.tail(corner);
  const View& view = views_[v];
  const double overCorner =
      nearest_[v].distance + std::sqrt(squaredDistance(p.bary, Eigen::Vector3d::Unit(corner % 3),
                                                       squaredSides(mesh_, p.face)));
  if (view.halfedge < 0) return overCorner;
  if (TriangleMesh::faceOf(view.halfedge) == p.face)
    return std::min(overCorner, distanceInOwnFace(mesh_, view, p));
  const Vector2d path = view.path(mesh_);
  return std::min({overCorner, distanceAside<Side::kLeft>(view, path, p),
                   distanceAside<Side::kRight>(view, path, p)});
}

/// The same where the point lies on one side of the view; infinity if it does not.
template <Side side>
double DgpcField::distanceAside(const View& view, const Vector2d& path,
                                const SurfacePoint& p) const {
  constexpr bool kLeft = side == Side::kLeft;
  Sight<side> sight(view);
  double result = kInfinity;
  walkFan<side>(mesh_, view, path, kToFirstBehind, [&](const FanFace& face) {
    const int outer = outerEnd<side>(face, mesh_);
    if (limitsViews(mesh_, outer)) sight.limit(path + face.outer);
    if (TriangleMesh::faceOf(face.halfedge) != p.face) return;
    const int i = face.halfedge % 3;
    const double toOuter = p.bary[kLeft ? i : (i + 1) % 3], toApex = p.bary[(i + 2) % 3];
    const Vector2d way = path + toOuter * face.outer + toApex * face.apex;
    if (!isTowards<side>(path, way)) return;
    if (sight.reaches(way))
      result = view.offset + way.norm();
    else if (sight.isAt(path + face.outer) || sight.reachesAround(face, path, way))
      result = view.offset + sight.bound().norm() + (way - sight.bound()).norm();
  });
  return result;
}

}  // namespace gvd
