// SPDX-License-Identifier: MIT
//
// Equality of results, number by number: what slices, seeds and the order of work may not change.
// Not a property of the types themselves, because a point on an edge has several representations.
#pragma once

#include "gvd/diagram.h"
#include "gvd/surface_point.h"

namespace gvd {

inline bool operator==(const SurfacePoint& p, const SurfacePoint& q) {
  return p.face == q.face && p.bary == q.bary;
}

inline bool operator==(const PointLists& a, const PointLists& b) {
  return a.offset == b.offset && a.points == b.points;
}

inline bool operator==(const Diagram::Segment& s, const Diagram::Segment& t) {
  return s.points == t.points && s.labels == t.labels && s.face == t.face && s.arc == t.arc;
}

inline bool operator==(const Diagram::VoronoiPoint& v, const Diagram::VoronoiPoint& w) {
  return v.point == w.point && v.labels == w.labels;
}

inline bool operator==(const Diagram& a, const Diagram& b) {
  return a.siteCount == b.siteCount && a.points == b.points && a.segments == b.segments &&
         a.arcs == b.arcs && a.arcLabels == b.arcLabels && a.voronoiPoints == b.voronoiPoints &&
         a.loops == b.loops && a.loopLabel == b.loopLabel && a.regionArea == b.regionArea &&
         a.faceLabel == b.faceLabel && a.indifferentFaces == b.indifferentFaces &&
         a.cells == b.cells && a.cellFace == b.cellFace && a.cellLabel == b.cellLabel;
}

}  // namespace gvd
