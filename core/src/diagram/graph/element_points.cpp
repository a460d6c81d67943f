// SPDX-License-Identifier: MIT
#include "diagram/graph/element_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sorting.h"
#include "base/tolerances.h"
#include "gvd/diagram.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

/// Points nearer than this may become one: 64 times the largest error bound, because a chain of
/// merged points may be as long.
constexpr double kNear = 64 * kMaxPointError;

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

/// The error of a vertex on a side, where two functions are equal. The same in both triangles.
double sideError(const FaceEnvelope& envelope, const FaceEnvelope::Vertex& v) {
  const int i = v.place, j = cornerAfter(i);
  const auto &a = envelope.value(v.functions[0]), &b = envelope.value(v.functions[1]);
  const double noise = 2 * kDistanceTolerance * std::max({a[i], a[j], b[i], b[j]});
  return placeError(noise, std::abs((a[i] - b[i]) - (a[j] - b[j])));
}

/// The error of a vertex, at most `kMaxPointError`.
double errorOf(const FaceEnvelope& envelope, const FaceEnvelope::Vertex& v) {
  switch (v.kind) {
    case FaceEnvelope::Vertex::kInside:
      return insideError(envelope, v);
    case FaceEnvelope::Vertex::kOnSide:
      return sideError(envelope, v);
    default:
      return 0;
  }
}

double largestDifference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

}  // namespace

ElementPoints::ElementPoints(const FaceComplex& complex, IndexMap& pointOfNode,
                             BisectorGraph& graph)
    : mesh_(complex.mesh()), complex_(complex), pointOfNode_(pointOfNode), graph_(graph) {}

bool ElementPoints::prepare(long& budget) {
  return pointOfNode_.extend(complex_.nodes().count(), budget) &&
         fillInSlices(firstPoint_, complex_.elementCount(), -1, budget);
}

void ElementPoints::make(int element, const FaceEnvelope& envelope) {
  const std::vector<Vertex>& vertices = envelope.vertices();
  placed_.assign(vertices.size(), {});
  for (int i = 0; i < 3; ++i)
    placed_[i].bary = complex_.faceBary(element, Eigen::Vector3d::Unit(i));
  const bool isFace = complex_.isFace(element);
  bool hasInnerPoint = false;
  for (const auto& [vertex, across] : envelope.sides()) {
    PlacedVertex& placed = placed_[vertex];
    if (placed.point >= 0) continue;
    if (vertex < 3) {
      placed.point = atNode(element, complex_.nodesOf(element)[vertex], placed.bary);
      continue;
    }
    const Vertex& v = vertices[vertex];
    const bool isInside = v.kind == Vertex::kInside;
    envelope.setBary(v, placed.bary);
    if (!isFace) placed.bary = complex_.faceBary(element, placed.bary);
    placed.point =
        isInside ? graph_.addInner(complex_.face(element), placed.bary,
                                   {envelope.label(v.functions[0]), envelope.label(v.functions[1]),
                                    envelope.label(v.functions[2])})
                 : makeOnSide(element, envelope, v, placed.bary);
    hasInnerPoint |= isInside;
  }
  if (hasInnerPoint && areNear(vertices)) tellApartInnerPoints(complex_.face(element), vertices);
}

/// Goes through the segments again as long as points are merged: beside a corner, each point that
/// is merged with it may let the next one follow.
void ElementPoints::mergeEnds(const FaceEnvelope& envelope) {
  bool hasMerged;
  do {
    hasMerged = false;
    for (const FaceEnvelope::Segment& segment : envelope.segments())
      hasMerged |= mergeEnds(envelope, segment);
  } while (hasMerged);
}

/// Merging must not join points of two sides beside their common corner without the corner itself:
/// that would pinch off the surface. Returns whether points were merged.
bool ElementPoints::mergeEnds(const FaceEnvelope& envelope, const FaceEnvelope::Segment& segment) {
  const int tail = segment.tail, tip = segment.tip;
  const double distance = largestDifference(placed_[tail].bary, placed_[tip].bary);
  if (distance > 2 * kMaxPointError) return false;  // as mostly
  const Vertex &from = envelope.vertices()[tail], &to = envelope.vertices()[tip];
  if (distance > errorOf(envelope, from) + errorOf(envelope, to)) return false;
  const int a = placed_[tail].point, b = placed_[tip].point;
  if (!graph_.isInner(a) && !graph_.isInner(b)) return false;
  const bool isBesideCorner = isNearCorner(envelope, from) || isNearCorner(envelope, to);
  const auto isAtNode = [&](int point) { return graph_.isNode(graph_.merging.root(point)); };
  return (!isBesideCorner || isAtNode(a) || isAtNode(b)) && graph_.unite(a, b);
}

/// Whether a vertex is inside, and so near to a corner of the element that it could be merged with
/// it.
bool ElementPoints::isNearCorner(const FaceEnvelope& envelope, const Vertex& v) const {
  if (v.kind != Vertex::kInside) return false;
  Eigen::Vector3d bary;
  envelope.setBary(v, bary);
  double size = 1;  // of its shortest side, in the face
  for (int i = 0; i < 3; ++i)
    size = std::min(size, largestDifference(placed_[i].bary, placed_[cornerAfter(i)].bary));
  return (size * bary.array() <= kNear).count() >= 2;
}

/// Whether any inner vertex is near another vertex. For each vertex, the inner vertices near it are
/// counted; they are sorted by one coordinate. As each inner vertex is near itself, a sum larger
/// than their number tells of a pair.
bool ElementPoints::areNear(std::span<const Vertex> vertices) {
  inner_.clear();
  for (size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v].kind == Vertex::kInside && placed_[v].point >= 0)
      inner_.push_back(placed_[v].bary);
  sortStably(std::span(inner_), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  size_t found = 0;
  for (const PlacedVertex& vertex : placed_) {
    if (vertex.point < 0) continue;
    const double least = vertex.bary[0] - kNear, most = vertex.bary[0] + kNear;
    auto inner = std::partition_point(inner_.begin(), inner_.end(),
                                      [&](const auto& place) { return place[0] < least; });
    for (; inner != inner_.end() && (*inner)[0] <= most; ++inner)
      found += largestDifference(*inner, vertex.bary) <= kNear;
  }
  return found > inner_.size();
}

/// Where slivers meet, an inner point may get the same place as another point that no segment joins
/// it to. The two are not merged, so the inner point is moved by one rounding step, or several, to
/// have a place of its own. If a neighbour face made a point on the common side, that has two
/// places here: rounded as in this face and, in the graph, as in the other one.
void ElementPoints::tellApartInnerPoints(int face, std::span<const Vertex> vertices) {
  std::vector<Eigen::Vector3d> places;  // that have a point
  for (const PlacedVertex& placed : placed_) {
    if (placed.point < 0) continue;
    places.push_back(placed.bary);
    const Eigen::Vector3d inGraph = baryInFace(mesh_, graph_.places[placed.point], face);
    if (inGraph != placed.bary) places.push_back(inGraph);
  }
  for (size_t i = 0; i < vertices.size(); ++i) {
    PlacedVertex& inner = placed_[i];
    if (vertices[i].kind != Vertex::kInside) continue;
    while (std::count(places.begin(), places.end(), inner.bary) > 1) {
      Eigen::Vector3d& place = *std::find(places.begin(), places.end(), inner.bary);
      Eigen::Index largest;
      place.maxCoeff(&largest);
      place[largest] = std::nextafter(place[largest], 0.0);
      inner.bary = graph_.places[inner.point].bary = place;
    }
  }
}

/// Returns the point of the neighbour element if that has made it already.
int ElementPoints::makeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v,
                              const Eigen::Vector3d& bary) {
  const int h = 3 * element + v.place, twin = complex_.twin(element, v.place);
  const int side = twin < 0 ? h : std::min(h, twin);
  const int before = envelope.label(v.functions[side == h ? 0 : 1]);
  int& first = firstPoint_[side / 3];
  for (int p = first; p >= 0; p = graph_.points[p].next)
    if (graph_.points[p].side == side && graph_.points[p].before == before) return p;
  const int point = graph_.addPoint(complex_.face(element), bary, side, before);
  graph_.points[point].next = std::exchange(first, point);
  mergeOnSide(element, envelope, v, point, bary);
  return point;
}

/// Merges a new point on a side with the ends of the side and with other points there, within their
/// error bounds.
void ElementPoints::mergeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v,
                                int point, const Eigen::Vector3d& bary) {
  for (const int corner : {v.place, cornerAfter(v.place)}) {
    const Eigen::Vector3d& place = placed_[corner].bary;
    const double distance = largestDifference(bary, place);
    if (distance <= kMaxPointError && distance <= errorOf(envelope, v))
      graph_.unite(point, atNode(element, complex_.nodesOf(element)[corner], place));
  }
  for (int p = graph_.points[point].next; p >= 0; p = graph_.points[p].next) {
    if (graph_.points[p].side != graph_.points[point].side) continue;
    const Eigen::Vector3d place = baryInFace(mesh_, graph_.places[p], complex_.face(element));
    const double distance = largestDifference(bary, place);
    if (distance > 2 * kMaxPointError) continue;
    const auto other = std::find_if(placed_.begin(), placed_.end(),
                                    [&](const PlacedVertex& placed) { return placed.point == p; });
    if (other != placed_.end() &&
        distance <=
            errorOf(envelope, v) + errorOf(envelope, envelope.vertices()[other - placed_.begin()]))
      graph_.unite(point, p);
  }
}

}  // namespace gvd
