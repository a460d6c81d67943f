// SPDX-License-Identifier: MIT
#include "diagram/element_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerances.h"
#include "gvd/diagram.h"
#include "mesh/representations.h"

namespace gvd {
namespace {

/// The error of a place where functions are equal, in barycentric coordinates: the noise of their
/// differences over the slope.
double placeError(double noise, double slope) {
  return noise < kMaxPointError * slope ? noise / slope : kMaxPointError;
}

/// The error of an inner vertex, where three functions are equal.
double insideError(const FaceEnvelope& envelope, const FaceEnvelope::Vertex& v) {
  const auto &a = envelope.value(v.functions[0]), &b = envelope.value(v.functions[1]),
             &c = envelope.value(v.functions[2]);
  const Eigen::Vector3d p(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const Eigen::Vector3d q(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  const double noise =
      2 * kDistanceTolerance * std::max({a[0], a[1], a[2]}) * (p.lpNorm<1>() + q.lpNorm<1>());
  return placeError(noise, p.cross(q).lpNorm<1>());
}

/// The error of a vertex on a side, where two functions are equal.
double sideError(const FaceEnvelope& envelope, const FaceEnvelope::Vertex& v) {
  const int i = v.place, j = cornerAfter(i);
  const auto &a = envelope.value(v.functions[0]), &b = envelope.value(v.functions[1]);
  const double noise = 2 * kDistanceTolerance * std::max({a[i], a[j], b[i], b[j]});
  return placeError(noise, std::abs((a[i] - b[i]) - (a[j] - b[j])));
}

}  // namespace

ElementPoints::ElementPoints(const FaceComplex& complex, NodePoints& nodePoints,
                             BisectorGraph& graph)
    : mesh_(complex.mesh()), complex_(complex), nodePoints_(nodePoints), graph_(graph) {}

bool ElementPoints::prepare(long& budget) {
  return sequence_.run(
      [&] { return nodePoints_.resize(complex_.nodes().count(), budget); },
      [&] { return fillInSlices(firstOnSide_, 3 * complex_.elementCount(), -1, budget); });
}

std::span<const ElementPoints::PlacedVertex> ElementPoints::of(int element,
                                                               const FaceEnvelope& envelope) {
  const std::vector<Vertex>& vertices = envelope.vertices();
  placed_.assign(vertices.size(), {});
  const bool isFace = complex_.isFace(element);
  bool hasInnerPoint = false;
  for (const FaceEnvelope::Cell& cell : envelope.cells())
    for (const auto& [vertex, across] : cell.sides) {
      PlacedVertex& placed = placed_[vertex];
      if (placed.point >= 0) continue;
      const Vertex& v = vertices[vertex];
      envelope.setBary(v, placed.bary);
      if (v.kind == Vertex::kInside) {
        placed.isInside = hasInnerPoint = true;
        placed.isNearCorner = isNearCorner(element, placed.bary);
      }
      if (!isFace) placed.bary = complex_.faceBary(element, placed.bary);
      placed.point = make(element, envelope, v, placed.bary);
    }
  if (hasInnerPoint) tellApartInnerPoints(complex_.face(element));
  return placed_;
}

/// Whether a point, given in the element, is near two of its sides. The limit is 64 times the
/// largest error bound, because a chain of merged points may reach nearer to the corner.
bool ElementPoints::isNearCorner(int element, const Eigen::Vector3d& bary) const {
  constexpr double kNear = 64 * kMaxPointError;
  double size = 1;  // of its shortest side, in the face
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d side = complex_.faceBary(element, Eigen::Vector3d::Unit(i)) -
                                 complex_.faceBary(element, Eigen::Vector3d::Unit(cornerAfter(i)));
    size = std::min(size, side.lpNorm<Eigen::Infinity>());
  }
  return (size * bary.array() <= kNear).count() >= 2;
}

/// Where slivers meet, an inner point may get the same place as another point that no segment joins
/// it to. The two are not merged, so the inner point is moved by one rounding step, or several, to
/// have a place of its own. If a neighbour face made a point on the common side, that has two
/// places here: rounded as in this face and, in the graph, as in the other one.
void ElementPoints::tellApartInnerPoints(int face) {
  places_.clear();
  for (const PlacedVertex& placed : placed_) {
    if (placed.point < 0) continue;
    places_.push_back(placed.bary);
    const Eigen::Vector3d inGraph = baryInFace(mesh_, graph_.places[placed.point], face);
    if (inGraph != placed.bary) places_.push_back(inGraph);
  }
  for (PlacedVertex& inner : placed_) {
    if (!inner.isInside) continue;
    while (std::count(places_.begin(), places_.end(), inner.bary) > 1) {
      Eigen::Vector3d& place = *std::find(places_.begin(), places_.end(), inner.bary);
      Eigen::Index largest;
      place.maxCoeff(&largest);
      place[largest] = std::nextafter(place[largest], 0.0);
      inner.bary = graph_.places[inner.point].bary = place;
    }
  }
}

int ElementPoints::make(int element, const FaceEnvelope& envelope, const Vertex& v,
                        const Eigen::Vector3d& bary) {
  if (v.kind == Vertex::kCorner) return atNode(element, complex_.nodesOf(element)[v.place], bary);
  if (v.kind == Vertex::kOnSide) return makeOnSide(element, envelope, v, bary);
  return graph_.addPoint(complex_.face(element), bary, insideError(envelope, v),
                         envelope.label(v.functions[0]), envelope.label(v.functions[1]),
                         envelope.label(v.functions[2]));
}

int ElementPoints::atNode(int element, int node, const Eigen::Vector3d& bary) {
  return nodePoints_.at(node, [&] { return graph_.addNode(complex_.face(element), bary); });
}

/// Returns the point of the neighbour element if that has made it already.
int ElementPoints::makeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v,
                              const Eigen::Vector3d& bary) {
  const int a = envelope.label(v.functions[0]), b = envelope.label(v.functions[1]);
  int& first = firstOnSide_[sideOf(element, v.place)];
  for (int p = first; p >= 0; p = graph_.points[p].nextOnSide) {
    const auto& labels = graph_.points[p].labels;
    if ((labels[0] == a && labels[1] == b) || (labels[0] == b && labels[1] == a)) return p;
  }
  const int point = graph_.addPoint(complex_.face(element), bary, sideError(envelope, v), a, b, -1);
  mergeOnSide(element, v.place, point, first, bary);
  graph_.points[point].nextOnSide = std::exchange(first, point);
  return point;
}

/// Merges a new point on a side with the ends of the side and with other points there, within their
/// error bounds.
void ElementPoints::mergeOnSide(int element, int side, int point, int others,
                                const Eigen::Vector3d& bary) {
  const double error = graph_.points[point].error;
  const auto isNear = [&](const Eigen::Vector3d& place, double distance) {
    return (bary - place).lpNorm<Eigen::Infinity>() <= distance;
  };
  for (const int corner : {side, cornerAfter(side)}) {
    const Eigen::Vector3d place = complex_.faceBary(element, Eigen::Vector3d::Unit(corner));
    if (isNear(place, error))
      graph_.unite(point, atNode(element, complex_.nodesOf(element)[corner], place));
  }
  for (int p = others; p >= 0; p = graph_.points[p].nextOnSide)
    if (isNear(baryInFace(mesh_, graph_.places[p], complex_.face(element)),
               graph_.points[p].error + error))
      graph_.unite(point, p);
}

/// The index of an element's side in `firstOnSide_`.
int ElementPoints::sideOf(int element, int side) const {
  const int h = 3 * element + side, twin = complex_.twin(h);
  return twin < 0 ? h : std::min(h, twin);
}

}  // namespace gvd
