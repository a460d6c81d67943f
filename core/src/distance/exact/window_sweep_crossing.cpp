// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
// Jindong Chen, Yijie Han. Shortest Paths on a Polyhedron. 1990
// Yipeng Qin, Xiaoguang Han, Hongchuan Yu, Yizhou Yu, Jianjun Zhang. Fast and Exact Discrete
// Geodesic Computation Based on Triangle-Oriented Wavefront Propagation. 2016
//
// WindowSweep::crossFace: carries the windows of a halfedge through its face. Most of the time for
// exact distances is spent here. What decides about a window varies without a pattern, and a branch
// that the processor predicts wrongly costs as much as a division: so numbers are chosen, where it
// is possible, instead of branches.
#include <algorithm>
#include <cmath>

#include "distance/exact/window_sweep.h"
#include "mesh/face_layout.h"

namespace gvd::exact {
namespace {

/// How far a virtual source is at least behind its halfedge, as a share of the halfedge: rounding
/// must not put it on the line of the halfedge, since crossings are divided by the depth. Too
/// little to turn a line, however near the source is to an end of the halfedge.
constexpr double kLeastDepth = 0x1p-200;

/// How far rounding may move the place where a line crosses a halfedge, as a share of the halfedge.
constexpr double kCrossingRounding = 0x1p-50;

/// Where the line from a window's source to the apex crosses the halfedge: on the true side of the
/// window's end. From the tail alone, a line that passes a very near tip seems to cross at the tip,
/// and the windows beyond it would be lost. So beside the end, the place as measured from the tip
/// decides. A window that begins at a very near vertex begins at the tail, where the place is
/// precise.
inline double crossingToApex(const Window& w, const Eigen::Vector2d& apex, double length) {
  const double at = w.crossing(apex.x(), apex.y());
  if (std::abs(at - w.end) > kCrossingRounding * length) return at;
  const double fromTip = w.fromTip + (length - apex.x() - w.fromTip) * (-w.y / (apex.y() - w.y));
  return fromTip > length - w.end ? std::min(at, std::nextafter(w.end, 0.0)) : std::max(at, w.end);
}

}  // namespace

long WindowSweep::crossFace(int h) {
  const long count = static_cast<long>(windows_[h].size());
  if (to_ == SpreadTo::kRequired && !offerAndGoOn(h)) return count;
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3, j = cornerAfter(i), k = cornerBefore(i);
  const int left = face.twins[k], right = face.twins[j];
  const WindowLists::List list = windows_.take(h);
  const std::span<const Window> windows = list.windows();
  revisits_.noteCrossing(vertices_.count());
  offerToApex(h, windows);
  if (to_ == SpreadTo::kSites) offerSites(h, windows);
  if (!points_.isEmpty() && to_ != SpreadTo::kRequired)
    for (const Window& w : windows) points_.offer(w, h);
  const End tail = endAt(face.vertices[i]), tip = endAt(face.vertices[j]),
            apex = endAt(face.vertices[k]);
  if (left >= 0) crossSide<Side::kLeft>(h, windows, portal(left, face.lengths[k], tail, apex));
  if (right >= 0) crossSide<Side::kRight>(h, windows, portal(right, face.lengths[j], apex, tip));
  windows_.free(list);
  return count;
}

void WindowSweep::offerToApex(int h, std::span<const Window> windows) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  const Eigen::Vector2d p = apexOf(face, i);
  const double grazed = grazing(face.lengths[i]);
  const int apex = face.vertices[cornerBefore(i)];
  if (toApex_.size() < windows.size()) toApex_.resize(windows.size());
  for (size_t n = 0; n < windows.size(); ++n) {
    const Window& w = windows[n];
    const double crossing = crossingToApex(w, p, face.lengths[i]);
    toApex_[n] = {crossing, -kInfinity};
    if (!((crossing >= w.begin - grazed) & (crossing <= w.end + grazed))) continue;
    const PathLength path = w.path(p.x(), p.y());
    if ((crossing > w.begin + grazed) & (crossing < w.end - grazed))
      toApex_[n].length = path.length;
    offer(apex, path.length,
          {w.crossingFromFoot(p.x(), p.y()), w.sourceDistance, w.direction, h, path.kind});
  }
}

WindowSweep::End WindowSweep::endAt(int v) const {
  if (to_ == SpreadTo::kSites) return {vertices_.distance(v), search_.mostAt(v)};
  return {vertices_.distance(v), bounds_[v].distance + tieMargin_};
}

WindowSweep::Portal WindowSweep::portal(int h, double length, const End& tail,
                                        const End& tip) const {
  return {h,
          length,
          {tail.own, tip.own},
          {tail.limit, tip.limit},
          to_ != SpreadTo::kRequired && (tail.limit < tail.own || tip.limit < tip.own)};
}

WindowSweep::Portal WindowSweep::portalTo(int h) const {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  return portal(h, face.lengths[i], endAt(face.vertices[i]), endAt(face.vertices[cornerAfter(i)]));
}

/// Trims a window that is about to arrive at its halfedge, the portal. False if it ends there: it
/// is dropped if the label's own paths over the ends of the halfedge are shorter everywhere on it;
/// if those of other labels are, it waits there. Inlined to keep the window in registers between
/// two steps.
[[gnu::always_inline]] inline bool WindowSweep::trimAtPortal(Window& w, const Portal& portal) {
  w.y = std::min(w.y, -kLeastDepth * portal.length);
  trim(w, portal.length, portal.own);
  if (!(w.begin < w.end)) return false;
  if (revisits_.drops(w, portal.halfedge)) return false;
  if (portal.isLimited) {
    Window owned = w;
    trim(owned, portal.length, portal.limit);
    if (!(owned.begin < owned.end)) {
      if (to_ == SpreadTo::kOwned) waiting_.windows.push_back({w, portal.halfedge});
      return false;
    }
    if (to_ == SpreadTo::kSites) w = owned;
  }
  return true;
}

/// Carries the batch at a halfedge through the face's side to the left or right of the apex.
template <Side kSide>
void WindowSweep::crossSide(int h, std::span<const Window> windows, const Portal& portal) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  constexpr bool kLeft = kSide == Side::kLeft;
  const int i = h % 3;
  // Of the windows of one halfedge that see the apex, only the one nearest to it has children on
  // both sides ("one angle, one split", Chen & Han 1990). If a path that turns on the halfedge is
  // the shortest one to the apex, only lines that cross its last piece are longer. None of this
  // applies if the apex is beside a window or at its end, up to rounding: all lines then pass it on
  // the same side, and a virtual source may lie on the line to the apex.
  const Vertex& apex = vertices_[face.vertices[cornerBefore(i)]];
  const bool isApexFromHere = apex.piece.arrival == h;
  const double longest = apex.distance + kDistanceTolerance * (apex.distance + face.lengths[i]);
  const bool isBent = apex.piece.kind == PathKind::kBent;
  const double lastCrossing = apexOf(face, i).x() + apex.piece.fromFoot;

  if (children_.size() < windows.size()) children_.resize(windows.size());
  size_t count = 0;
  for (size_t n = 0; n < windows.size(); ++n) {
    const Window& w = windows[n];
    const auto [crossing, length] = toApex_[n];
    const bool leaves = kLeft ? crossing > w.begin : crossing < w.end;
    const bool isDominated =
        isApexFromHere & (length > longest) & ((crossing < lastCrossing) != kLeft);
    if (!leaves || (isDominated && !isBent)) continue;
    Window part = w;
    if (isDominated) {
      (kLeft ? part.end : part.begin) = lastCrossing;
      if (!(part.begin < part.end)) continue;
    }
    Window beyond = windowBeyond<kSide>(part, face, i, crossing);
    const bool isKept = trimAtPortal(beyond, portal);
    children_[count] = beyond;
    count += isKept;
  }
  if (count == 0) return;
  const bool isFirst = windows_.isEmpty(portal.halfedge);
  windows_.add(portal.halfedge, {children_.data(), count});
  if (isFirst) queueBatch(portal.halfedge, std::min(portal.own.atTail, portal.own.atTip));
}

void WindowSweep::add(Window& w, const Portal& portal) {
  if (!trimAtPortal(w, portal)) return;
  const bool isFirst = windows_.isEmpty(portal.halfedge);
  windows_.add(portal.halfedge, {&w, 1});
  if (isFirst)
    queueBatch(portal.halfedge, std::min({portal.own.atTail, portal.own.atTip, w.least()}));
}

}  // namespace gvd::exact
