// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "distance/face_layout.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Beside a window, as a share of its halfedge, a vertex still gets the path that turns at the
/// window's end. Neighbouring windows leave gaps of rounding, some 2^-53 of the distance; this
/// covers them up to distances of 2^20 edges and more, and a path that turns is never too short.
inline constexpr double kGrazing = 1e-7;

/// How a path gets to a vertex. What windows end at depends on what else is known when they spread;
/// the lengths of straight paths follow from the faces that they cross alone. So of paths that tie,
/// a straight one counts: the distance is the same to the last bit, in whatever order labels
/// spread.
enum class Course : char {
  kStraight,  ///< through windows, over virtual sources
  kBeside,    ///< past the end of a window, by no more than rounding
  kBent,      ///< turning at the end of a window, or at a vertex that need not be a virtual source
};

/// The length of a path, with how it comes to be.
struct PathLength {
  double length;
  Course course;
};

/// More than rounding makes paths along one line differ by, as a share of their length; an eighth
/// of what counts as a tie.
inline constexpr double kLineDifference = 0x1p-44;

/// What paths to one vertex are compared by.
inline double rankOf(const PathLength& path) {
  return path.length * (1 + kLineDifference * static_cast<double>(path.course));
}

/// A window: the part of a halfedge that a virtual source sees along straight lines of the unfolded
/// faces (Mitchell et al. 1987). It belongs to the halfedge of the face that these lines enter, and
/// is given in the coordinates of that halfedge.
///
///              apex
///             /    \             The face lies at y >= 0,
///            / face \            the virtual source at y < 0.
///    tail --[======]---- tip
///          begin   end
///             \  /
///            source
struct Window {
  double begin, end;      ///< along the halfedge, from its tail
  double x, y;            ///< the virtual source, unfolded
  double sourceDistance;  ///< of the virtual source from the site; 0: the source is the site
  /// If the source is the site, the angle of the halfedge in the site's frame; otherwise the angle
  /// at which the shortest path to the source leaves the site.
  double direction;

  /// The least distance of a point of the window.
  double least() const {
    const double beside = x < begin ? begin - x : x > end ? x - end : 0;
    return sourceDistance + (beside > 0 ? std::sqrt(beside * beside + y * y) : -y);
  }
  /// The distance of a point of the halfedge along the straight line from the source.
  double distanceOnEdge(double at) const {
    return sourceDistance + std::sqrt((at - x) * (at - x) + y * y);
  }
  /// Where the line from the source to a point of the face crosses the halfedge.
  double crossing(double px, double py) const { return x + (px - x) * (-y / (py - y)); }
  /// The shortest path through the window to a point of the face: straight if the crossing is
  /// inside the window, else bent at the window's end next to it.
  PathLength path(double px, double py) const {
    const double at = crossing(px, py);
    const double straight = sourceDistance + std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
    const double bend = std::clamp(at, begin, end);
    if (bend == at) return {straight, Course::kStraight};
    const double bent = distanceOnEdge(bend) + std::sqrt((px - bend) * (px - bend) + py * py);
    if (bent <= straight * (1 + kLineDifference)) return {straight, Course::kBeside};
    return {bent, Course::kBent};
  }
  double distance(double px, double py) const { return path(px, py).length; }
};

/// Where a ray from (x, y), y < 0, through (at, 0) meets the side that leaves the origin under an
/// angle of the given cosine and sine, as the distance from the origin, in [0, length]. The ray is
/// known to meet the side or, by rounding, to pass an end of it.
inline double meetSide(double at, double x, double y, double cosine, double sine, double length) {
  const double numerator = -at * y;
  const double denominator = -cosine * y - sine * (at - x);
  if (!(at > 0)) return 0;
  return denominator * length > numerator ? numerator / denominator : length;
}

/// The sides by which windows leave a face, as seen from their halfedge.
enum class Side { kLeft, kRight };

/// What goes on of a window of side i beyond another side of the face, in the coordinates of the
/// face beyond. `crossing` is where the line from the source to the apex crosses side i: the window
/// must have a part on that side of it. Inlined, for all windows of a halfedge share the face.
template <Side kSide>
[[gnu::always_inline]] inline Window windowBeyond(const Window& w, const TriangleMesh::Face& face,
                                                  int i, double crossing) {
  const int j = cornerAfter(i), k = cornerBefore(i);
  Window beyond;
  beyond.sourceDistance = w.sourceDistance;
  if constexpr (kSide == Side::kLeft) {
    const double c = face.cosines[i], s = face.sines[i], side = face.lengths[k];
    beyond.begin = meetSide(w.begin, w.x, w.y, c, s, side);
    beyond.end = crossing < w.end ? side : meetSide(w.end, w.x, w.y, c, s, side);
    beyond.x = w.x * c + w.y * s;
    beyond.y = w.y * c - w.x * s;
    beyond.direction = w.sourceDistance > 0 ? w.direction : w.direction + face.angles[i];
  } else {
    const double c = face.cosines[j], s = face.sines[j], side = face.lengths[j];
    const double length = face.lengths[i], x = length - w.x;
    beyond.begin = crossing > w.begin ? 0 : side - meetSide(length - w.begin, x, w.y, c, s, side);
    beyond.end = side - meetSide(length - w.end, x, w.y, c, s, side);
    beyond.x = side - (x * c + w.y * s);
    beyond.y = w.y * c - x * s;
    beyond.direction = w.sourceDistance > 0 ? w.direction : w.direction - face.angles[j];
  }
  return beyond;
}

/// How far from a vertex, along an edge, the path over the vertex is shorter than a window's: up to
/// the t where `atVertex` + t = sourceDistance + |source, t|. There the square roots cancel and t
/// follows by division. 0 if the path over the vertex is nowhere shorter, infinity if it is shorter
/// everywhere. `along` is the source's coordinate from the vertex towards the edge's other end,
/// `height2` its squared distance from the edge's line.
/// A window that is not longer by more than rounding keeps its ground: a path lost is an error, a
/// path too many is not.
inline double reachOfVertex(double atVertex, double sourceDistance, double along, double height2,
                            double length) {
  const double lead = atVertex - sourceDistance + kDistanceTolerance * (atVertex + length);
  const double distance2 = along * along + height2;
  if (distance2 <= lead * lead) return lead > 0 ? 0 : kInfinity;
  const double approach = lead + along;
  return approach > 0 ? (distance2 - lead * lead) / (2 * approach) : kInfinity;
}

/// Distances at the two ends of a halfedge.
struct EdgeDistances {
  double atTail, atTip;
};

/// Cuts off what paths over the ends of the halfedge do shorter; the window is empty if its begin
/// is not less than its end then.
inline void trim(Window& w, double length, const EdgeDistances& known) {
  const double height2 = w.y * w.y;
  w.begin = std::max(w.begin, reachOfVertex(known.atTail, w.sourceDistance, w.x, height2, length));
  w.end = std::min(
      w.end, length - reachOfVertex(known.atTip, w.sourceDistance, length - w.x, height2, length));
}

}  // namespace gvd::exact
