// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "base/lanes.h"
#include "base/tolerances.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// A vertex seen past the end of a window by at most this share of the halfedge gets the path that
/// turns at that end. Rounding leaves gaps of some 2^-53 of the distance between neighbouring
/// windows; this covers them up to distances of 2^29 times the halfedge. `WindowSweep::grazing`
/// covers the gaps behind longer edges. A path that turns exists, so it is never too short.
inline constexpr double kGrazing = 1e-7;

/// How a path reaches a vertex. The ends of a window depend on the distances it was trimmed by, and
/// so on the order in which labels spread; the length of a straight path depends only on the faces
/// it crosses. So a straight path wins a tie, and distances have the same bits in any order.
enum class PathKind : char {
  kStraight,    ///< through windows, over virtual sources
  kGrazingEnd,  ///< past the end of a window, by no more than rounding
  kBent,  ///< turning at the end of a window, or at a vertex that need not be a virtual source
};

struct PathLength {
  double length;
  PathKind kind;
};

/// Rounding makes the lengths of paths along one line differ by less than this, relatively; an
/// eighth of `kDistanceTolerance`.
inline constexpr double kLineDifference = 0x1p-44;

/// The value by which paths to a vertex are compared: the length, raised so that a straight path
/// wins a tie, and a grazing one against a bent one.
inline double rankOf(const PathLength& path) {
  return path.length * (1 + kLineDifference * static_cast<double>(path.kind));
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
  double begin, end;  ///< along the halfedge, from its tail
  double x, y;        ///< the virtual source, unfolded
  /// How far the source is from the tip: the halfedge's length - x, but as precise beside the tip
  /// as x is beside the tail. So lines turn precisely around a vertex that is very near to the
  /// source.
  double fromTip;
  double sourceDistance;  ///< of the virtual source from the site; 0: the source is the site
  /// If the source is the site, the angle of the halfedge in the site's frame; otherwise the angle
  /// at which the shortest path to the source leaves the site.
  double direction;

  /// Whether the source is the site.
  bool isFromSite() const { return sourceDistance == 0; }
  /// The least distance from the site of any point of the window.
  double least() const {
    const double beside = std::max({begin - x, x - end, 0.0});
    return sourceDistance + std::sqrt(beside * beside + y * y);
  }
  /// The distance of a point of the halfedge along the straight line from the source.
  double distanceOnEdge(double at) const {
    return sourceDistance + std::sqrt((at - x) * (at - x) + y * y);
  }
  /// Where the line from the source to a point of the face crosses the halfedge.
  double crossing(double px, double py) const { return x + (px - x) * (-y / (py - y)); }
  /// The same from the foot of the point on the halfedge.
  double crossingFromFoot(double px, double py) const { return (x - px) * (py / (py - y)); }
  /// The length of the straight line to a point of the face.
  double straightTo(double px, double py) const {
    return sourceDistance + std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
  }
  /// The shortest path through the window to a point of the face: straight if the crossing is
  /// inside the window, else bent at the window's end next to it.
  PathLength path(double px, double py) const {
    const double at = crossing(px, py);
    const double straight = straightTo(px, py);
    const double bend = std::clamp(at, begin, end);
    if (bend == at) return {straight, PathKind::kStraight};
    const double bent = distanceOnEdge(bend) + std::sqrt((px - bend) * (px - bend) + py * py);
    if (bent <= straight * (1 + kLineDifference)) return {straight, PathKind::kGrazingEnd};
    return {bent, PathKind::kBent};
  }
  double distance(double px, double py) const { return path(px, py).length; }
};

/// Where the rays through two points (at, 0), from a source `ahead` before them along the x axis,
/// at y < 0, meet the side that leaves the origin under an angle of the given cosine and sine, as
/// distances from the origin, in [0, length]. The rays are known to meet the side or, by rounding,
/// to pass an end of it.
inline Lanes meetSide(Lanes at, Lanes ahead, double y, double cosine, double sine, double length) {
  const Lanes numerator = -at * y;
  const Lanes denominator = -cosine * y - sine * ahead;
  const Lanes meets = denominator * length > numerator ? numerator / denominator : both(length);
  return at > 0.0 ? meets : both(0);
}

/// The sides by which windows leave a face, as seen from their halfedge.
enum class Side { kLeft, kRight };

/// The child of a window of side i beyond the left or right side of the face, in the coordinates of
/// the face beyond. The line from the source to the apex crosses side i at `crossing`; part of the
/// window must lie left or right of it. Inlined because all windows of a halfedge share the face.
template <Side kSide>
[[gnu::always_inline]] inline Window windowBeyond(const Window& w, const TriangleMesh::Face& face,
                                                  int i, double crossing) {
  const int j = cornerAfter(i), k = cornerBefore(i);
  const double length = face.lengths[i];
  // Begin and end, as seen from the source along the halfedge: the begin by the tail and the end by
  // the tip, since there windows begin and end that pass a vertex, which may be very near.
  const Lanes ahead = Lanes{w.begin, w.fromTip} - Lanes{w.x, length - w.end};
  Window beyond;
  beyond.sourceDistance = w.sourceDistance;
  if constexpr (kSide == Side::kLeft) {
    const double c = face.cosines[i], s = face.sines[i], side = face.lengths[k];
    const Lanes met = meetSide(Lanes{w.begin, w.end}, ahead, w.y, c, s, side);
    beyond.begin = met[0];
    beyond.end = crossing < w.end ? side : met[1];
    beyond.x = w.x * c + w.y * s;
    beyond.y = w.y * c - w.x * s;
    beyond.fromTip = side - beyond.x;
    beyond.direction = w.direction + (w.isFromSite() ? face.angles[i] : 0);
  } else {
    const double c = face.cosines[j], s = face.sines[j], side = face.lengths[j];
    const Lanes met = meetSide(length - Lanes{w.begin, w.end}, -ahead, w.y, c, s, side);
    beyond.begin = crossing > w.begin ? 0 : side - met[0];
    beyond.end = side - met[1];
    beyond.fromTip = w.fromTip * c + w.y * s;
    beyond.x = side - beyond.fromTip;
    beyond.y = w.y * c - w.fromTip * s;
    beyond.direction = w.direction - (w.isFromSite() ? face.angles[j] : 0);
  }
  return beyond;
}

/// Distances at the two ends of a halfedge.
struct EdgeDistances {
  double atTail, atTip;
};

/// Cuts off the parts of a window where a path over an end of the halfedge is shorter. The window
/// is empty unless begin < end afterwards.
///
/// From an end, the path over it is shorter up to the t where its distance + t =
/// sourceDistance + |source, t|, which squared is linear in t. `reach` is 0 if that path is nowhere
/// shorter, infinity if it is shorter everywhere. Within rounding the window wins: a lost path
/// makes a distance wrong, a superfluous one does not.
inline void trim(Window& w, double length, const EdgeDistances& ends) {
  const Lanes atEnds = {ends.atTail, ends.atTip};
  const Lanes along = {w.x, w.fromTip};  // the source, from each end towards the other one
  const Lanes lead = atEnds - w.sourceDistance + kDistanceTolerance * (atEnds + length);
  const Lanes approach = lead + along;
  const Lanes excess = approach * (along - lead) + w.y * w.y;  // |source, end|² - lead²
  const Lanes meets = excess / (2 * approach);
  const Lanes reach = excess <= 0.0 ? (lead > 0.0 ? both(0) : both(kInfinity))
                                    : (approach > 0.0 ? meets : both(kInfinity));
  w.begin = std::max(w.begin, reach[0]);
  w.end = std::min(w.end, length - reach[1]);
}

}  // namespace gvd::exact
