// SPDX-License-Identifier: MIT
//
// BisectorTracing: the points of a diagram, and which of them are one because no error tells them
// apart.
#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "diagram/bisector_tracing.h"
#include "mesh/surface_geometry.h"

namespace gvd {

using Vertex = FaceEnvelope::Vertex;

/// As a share of the longest side, a distance that is far beyond what points are merged at.
constexpr double kPlainlyApart = 1000 * kMaxPointError;

void BisectorTracing::addPoints(const Element& element) {
  corners_.resize(envelope_.vertices().size());
  for (Corner& corner : corners_) corner.point = -1;
  bool hasInnerPoint = false;
  for (const FaceEnvelope::Cell& cell : envelope_.cells())
    for (const auto& [vertex, across] : cell.sides) {
      Corner& corner = corners_[vertex];
      if (corner.point >= 0) continue;
      envelope_.setBary(vertex, corner.bary);
      corner.isInside = envelope_.vertices()[vertex].kind == Vertex::kInside;
      corner.isBetweenSides = corner.isInside && isBetweenSides(element, corner.bary);
      if (!element.isWhole) corner.bary = complex_.faceBary(element.index, corner.bary);
      corner.point = pointAt(element, vertex);
      hasInnerPoint |= corner.isInside;
    }
  if (hasInnerPoint) tellApartInnerPoints();
}

/// Where slivers meet, an inner point may be where another one is, or a corner, that no segment
/// joins it to: they stay two points, and so have to be told apart by their places.
void BisectorTracing::tellApartInnerPoints() {
  for (size_t v = 0; v < corners_.size(); ++v) {
    Corner& inner = corners_[v];
    if (inner.point < 0 || envelope_.vertices()[v].kind != Vertex::kInside) continue;
    for (const Corner& other : corners_) {
      if (other.point < 0 || other.point == inner.point || other.bary != inner.bary) continue;
      Eigen::Index largest;
      inner.bary.maxCoeff(&largest);
      inner.bary[largest] = std::nextafter(inner.bary[largest], 0.0);
      graph_.places[inner.point].bary = inner.bary;
    }
  }
}

int BisectorTracing::pointAt(const Element& element, int vertex) {
  const Vertex& v = envelope_.vertices()[vertex];
  const Eigen::Vector3d& bary = corners_[vertex].bary;
  if (v.kind == Vertex::kCorner)
    return pointOfNode(element, tail_[3 * element.index + v.place], bary);
  if (v.kind == Vertex::kOnSide) return pointOnSide(element, v, bary);
  graph_.innerPoints.push_back(static_cast<int>(graph_.points.size()));
  return graph_.addPoint(element.face, bary, insideError(v, element.longest), label(v.functions[0]),
                         label(v.functions[1]), label(v.functions[2]));
}

/// The neighbour may have made the point already.
int BisectorTracing::pointOnSide(const Element& element, const Vertex& v,
                                 const Eigen::Vector3d& bary) {
  const int a = label(v.functions[0]), b = label(v.functions[1]);
  int& first = firstOnSide_[slotOf(element, v.place)];
  for (int p = first; p >= 0; p = graph_.points[p].nextOnSide) {
    const auto& labels = graph_.points[p].labels;
    if ((labels[0] == a && labels[1] == b) || (labels[0] == b && labels[1] == a)) return p;
  }
  const double error = sideError(element, v);
  const int point = graph_.addPoint(element.face, bary, error, a, b, -1);
  mergeOnSide(element, v.place, point, first, bary);
  graph_.points[point].nextOnSide = std::exchange(first, point);
  return point;
}

/// The point may be no other than an end of the side, or another point there.
void BisectorTracing::mergeOnSide(const Element& element, int side, int point, int others,
                                  const Eigen::Vector3d& bary) {
  const double error = graph_.points[point].error;
  for (const int end : {0, 1}) {
    const int corner = end == 0 ? side : (side + 1) % 3;
    if (isApart(element, side, bary[end == 0 ? (side + 1) % 3 : side], 2 * error)) continue;
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(corner);
    const Eigen::Vector3d place = complex_.faceBary(element.index, unit);
    if (squaredDistance(bary, place, element.squaredLength) <= error * error)
      graph_.unite(point, pointOfNode(element, tail_[3 * element.index + corner], place));
  }
  for (int p = others; p >= 0; p = graph_.points[p].nextOnSide) {
    const SurfacePoint& other = graph_.places[p];
    if (other.face == element.face &&
        isApart(element, side, other.bary[side] - bary[side], kPlainlyApart * element.longest))
      continue;
    const double both = graph_.points[p].error + error;
    const Eigen::Vector3d place = baryInFace(mesh_, other, element.face);
    if (squaredDistance(bary, place, element.squaredLength) <= both * both) graph_.unite(point, p);
  }
}

/// Whether a share of a side is longer than a distance. A quick way out, for most points are not
/// one. Elements that are a part of their face are measured in another way: false for them.
bool BisectorTracing::isApart(const Element& element, int side, double share, double distance) {
  return element.isWhole && share * share * element.squaredLength[side] > distance * distance;
}

/// Where in `firstOnSide_` a side of an element is. Of two elements with points on their common
/// side both are mixed, for the owners of its ends are not the same.
int BisectorTracing::slotOf(const Element& element, int side) const {
  const int twin = twin_[3 * element.index + side], neighbour = twin / 3;
  const bool isLater = twin < 0 || neighbour > element.index || mixedIndex_[neighbour] < 0;
  return isLater ? element.firstSlot + side : 3 * mixedIndex_[neighbour] + twin % 3;
}

/// `bary` is in terms of the element's face.
int BisectorTracing::pointOfNode(const Element& element, int node, const Eigen::Vector3d& bary) {
  if (const int known = nodePoints_[node]; known >= 0) return known;
  nodePoints_.note(node);
  return nodePoints_[node] = graph_.addNode(element.face, bary);
}

/// The share of a side by which an error of the functions moves a crossing, times the side.
double BisectorTracing::sideError(const Element& element, const Vertex& v) const {
  const int i = v.place, j = (i + 1) % 3;
  const auto &a = value(v.functions[0]), &b = value(v.functions[1]);
  const double noise = 2 * kDistanceTolerance * std::max({a[i], a[j], b[i], b[j]});
  const double slope = std::abs((a[i] - b[i]) - (a[j] - b[j]));
  const double side = element.isWhole ? mesh_.length(3 * element.face + i) : element.longest;
  return side * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
}

double BisectorTracing::insideError(const Vertex& v, double longest) const {
  const auto &a = value(v.functions[0]), &b = value(v.functions[1]), &c = value(v.functions[2]);
  const Eigen::Vector3d p(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const Eigen::Vector3d q(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  const double noise =
      2 * kDistanceTolerance * std::max({a[0], a[1], a[2]}) * (p.lpNorm<1>() + q.lpNorm<1>());
  const double slope = p.cross(q).lpNorm<1>();
  return longest * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
}

}  // namespace gvd
