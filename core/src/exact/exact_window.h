// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd::exact {

/// What a path or a window continues: a window, by its index, or
inline constexpr int kFromSite = -1;  ///< the site itself, which is seen from a corner of its face
/// or a vertex as virtual source, by its entry in the table of vertices.
constexpr int fromVertex(int entry) { return -2 - entry; }
constexpr int entryOf(int origin) { return -2 - origin; }

/// A window: the part of a halfedge through which a virtual source is seen along straight lines of
/// the unfolded faces. It belongs to the halfedge of the face that these lines enter, and is given
/// in the coordinates of that halfedge.
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
  double sourceDistance;  ///< from the virtual source to its site
  int label;
  int halfedge;
  int origin;
  int next;  ///< in a list of windows, -1 at the end

  /// The least distance of a point of the window.
  double least() const {
    const double beside = x < begin ? begin - x : x > end ? x - end : 0;
    return sourceDistance + (beside > 0 ? std::sqrt(beside * beside + y * y) : -y);
  }
  /// The distance of a point of the halfedge, seen or not.
  double distanceOnEdge(double at) const {
    return sourceDistance + std::sqrt((at - x) * (at - x) + y * y);
  }
  /// Where the line from the source to a point of the face crosses the halfedge.
  double crossing(double px, double py) const { return x + (px - x) * (-y / (py - y)); }
  /// The length of the shortest path through the window to a point of the face: straight if the
  /// crossing is inside the window, else bent at the end next to it.
  double distance(double px, double py) const {
    const double at = crossing(px, py);
    const double bend = std::clamp(at, begin, end);
    if (bend == at) return sourceDistance + std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
    return distanceOnEdge(bend) + std::sqrt((px - bend) * (px - bend) + py * py);
  }
};

/// Windows by index, in blocks: they stay in place as their number grows.
class WindowPool {
 public:
  int size() const { return size_; }
  Window& operator[](int i) { return blocks_[i / kBlock][i % kBlock]; }
  const Window& operator[](int i) const { return blocks_[i / kBlock][i % kBlock]; }
  int add(const Window& w) {
    if (size_ % kBlock == 0) blocks_.push_back(std::unique_ptr<Window[]>(new Window[kBlock]));
    blocks_.back()[size_ % kBlock] = w;
    return size_++;
  }

 private:
  static constexpr int kBlock = 1 << 12;
  std::vector<std::unique_ptr<Window[]>> blocks_;
  int size_ = 0;
};

/// Where a ray from (x, y), y < 0, through (at, 0) meets the side that leaves the origin under an
/// angle of the given cosine and sine, as the distance from the origin, in [0, length]. The ray is
/// known to meet the side or, by rounding, to pass an end of it.
inline double meetSide(double at, double x, double y, double cosine, double sine, double length) {
  if (at <= 0) return 0;
  const double numerator = -at * y;
  const double denominator = -cosine * y - sine * (at - x);
  return denominator * length > numerator ? numerator / denominator : length;
}

/// How far from a vertex v, along an edge, the path over v is shorter than a window's: it is up to
/// where `atVertex` + t = sourceDistance + |source, t|. There the square roots cancel and t follows
/// by division. 0 if the path over v is nowhere shorter, infinity if it is shorter everywhere.
/// `along` and `height` give the source as seen from v, `along` towards the edge's other end.
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

/// Cuts off what paths over the ends of the halfedge do shorter; `atTail` and `atTip` are distances
/// of the same label.
inline void trim(Window& w, double length, double atTail, double atTip) {
  const double height2 = w.y * w.y;
  if (atTail < kInfinity)
    w.begin = std::max(w.begin, reachOfVertex(atTail, w.sourceDistance, w.x, height2, length));
  if (atTip < kInfinity)
    w.end = std::min(
        w.end, length - reachOfVertex(atTip, w.sourceDistance, length - w.x, height2, length));
}

}  // namespace gvd::exact
