// SPDX-License-Identifier: MIT
//
// WindowSweep::require: spreads a label on to vertices or other points that it does not own.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/prefetch.h"
#include "distance/exact/window_sweep.h"
#include "mesh/face_layout.h"

namespace gvd::exact {
namespace {

/// Windows that would sleep for fewer approaches than this stay awake: to look at them as often
/// takes less than to sort them in and out.
constexpr double kLeastApproachesAsleep = 4;

const Window& windowOf(const Window& w) { return w; }
const Window& windowOf(const WaitingWindow& w) { return w.window; }

}  // namespace

long WindowSweep::require(int label, LabelState& state, std::span<const int> faces, double atMost) {
  const size_t loaded = beginToRequire(label, state);
  for (size_t i = 0; i < faces.size(); ++i) {
    for (const int next : itemsToPrefetch(faces, i)) prefetchInBatch(mesh_.face(next));
    requireCorners(faces[i], atMost);
  }

  // Good first distances leave few windows that have to go on. They come along the sides of the
  // faces, and from windows that wait at a face with a required corner. Some corner is always known
  // of a label that owns part of the face: it has its site there, owns a corner, or is known at
  // both ends of a side.
  if (required_.hasRecent()) {
    // First distances tell how near the places have come.
    for (const int f : faces) offerAlongSides(f);
    required_.approach();
    state.waiting.wake(required_.travel());
  }
  visitAwake([&](int h, std::span<const WaitingWindow> windows) {
    if (!hasRequiredCorner(h / 3)) return;
    for (const WaitingWindow& w : windows) offerToCorners(w.window, h);
  });
  for (const int f : faces) offerAlongSides(f);
  const size_t awake = state.waiting.awake().size() + state.waiting.sources.size();
  continueNeeded();
  return static_cast<long>(loaded + faces.size() + awake * required_.cost());
}

/// Calls `visit` with each run of windows that are awake at one halfedge. A halfedge may have
/// several.
template <class Visit>
void WindowSweep::visitAwake(Visit visit) const {
  const std::span<const WaitingWindow> awake = state_->waiting.awake();
  for (size_t begin = 0, end; begin < awake.size(); begin = end) {
    const int h = awake[begin].halfedge;
    for (const WaitingWindow& next : itemsToPrefetch(awake, begin))
      prefetchInBatch(mesh_.face(next.halfedge / 3));
    for (end = begin + 1; end < awake.size() && awake[end].halfedge == h;) ++end;
    visit(h, awake.subspan(begin, end - begin));
  }
}

/// Requires the distances of a face's corners that are not final yet.
void WindowSweep::requireCorners(int f, double atMost) {
  for (const int v : mesh_.face(f).vertices) {
    Vertex& own = vertices_.touched(v);
    if (own.isFinal | own.isRequired()) continue;
    own.required =
        required_.add(required_.placeOf(v), std::min(own.distance, atMost), bounds_[v].distance);
  }
}

bool WindowSweep::hasRequiredCorner(int f) const {
  bool isAny = false;
  for (const int v : mesh_.face(f).vertices) isAny |= vertices_[v].isRequired();
  return isAny;
}

/// Offers the corners of a face the paths along its sides from other corners.
void WindowSweep::offerAlongSides(int f) {
  const TriangleMesh::Face& face = mesh_.face(f);
  for (int i = 0; i < 3; ++i) {
    const int v = face.vertices[i];
    const double distance = vertices_[v].distance;
    // All neighbours of a site on a vertex know it.
    if (distance == kInfinity || vertices_[v].piece.isAtSite()) continue;
    const auto offerTo = [&](int corner, double length, int arrival, double fromFoot) {
      const int to = face.vertices[corner];
      const bool isShorter = distance + length < vertices_[to].distance;
      if (vertices_[to].isRequired() & isShorter)
        offer(to, distance + length,
              {fromFoot, distance, directionAt(v), arrival, PathKind::kBent});
    };
    const int j = cornerAfter(i), k = cornerBefore(i);
    offerTo(j, face.lengths[i], 3 * f + k, face.lengths[i] * face.cosines[i]);
    offerTo(k, face.lengths[k], 3 * f + i, -face.lengths[k] * face.cosines[i]);
  }
}

/// Offers the paths through a window to the required corners of its face: straight ones, or those
/// that turn at the window's end.
void WindowSweep::offerToCorners(const Window& w, int h) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3, j = cornerAfter(i), k = cornerBefore(i);
  const double length = face.lengths[i];
  const double grazed = grazing(length);
  if (vertices_[face.vertices[k]].isRequired()) {
    const Eigen::Vector2d p = apexOf(face, i);
    const double straight = w.crossing(p.x(), p.y());
    const double crossing = std::clamp(straight, w.begin, w.end);
    // A path that turns at a vertex is offered by that vertex, with the direction of the path to
    // it.
    const bool turnsAtVertex =
        std::abs(crossing - straight) > grazed && (crossing < grazed || crossing > length - grazed);
    if (!turnsAtVertex) {
      const PathLength path = w.path(p.x(), p.y());
      const double fromFoot =
          crossing == straight ? w.crossingFromFoot(p.x(), p.y()) : crossing - p.x();
      offer(face.vertices[k], path.length, {fromFoot, w.sourceDistance, w.direction, h, path.kind});
    }
  }
  // Along the halfedge from an end of the window. A window that ends at the vertex has offered the
  // straight path already, with the direction in which it arrives.
  if (vertices_[face.vertices[i]].isRequired() && w.begin > grazed)
    offer(face.vertices[i], w.distanceOnEdge(w.begin) + w.begin,
          {-length * face.cosines[j], w.sourceDistance, w.direction, h - i + j, PathKind::kBent});
  if (vertices_[face.vertices[j]].isRequired() && w.end < length - grazed)
    offer(face.vertices[j], w.distanceOnEdge(w.end) + length - w.end,
          {length * face.cosines[i], w.sourceDistance, w.direction, h - i + k, PathKind::kBent});
}

// --- Points --------------------------------------------------------------------------------------

void WindowSweep::start(int label, LabelState& state, std::span<const RequiredPoint> points) {
  begin(label, SpreadTo::kOwned, state);
  points_.set(points, vertices_);
  startAt(sites_[label]);
}

void WindowSweep::require(int label, LabelState& state, std::span<const RequiredPoint> points) {
  begin(label, SpreadTo::kRequired, state);
  vertices_.load(state);
  state.waiting.asleep = 0;
  points_.set(points, vertices_);
  for (const WaitingWindow& w : state.waiting.windows) points_.offer(w.window, w.halfedge);
  continueNeeded();
}

// --- Which windows go on -------------------------------------------------------------------------

/// The paths through windows at a halfedge; none if all of them have at least the excess
/// `mostExcess`. Inlined, as it is the innermost loop of requirements.
template <class AnyWindow>
[[gnu::always_inline]] inline std::optional<RequiredDistances::Paths> WindowSweep::pathsThrough(
    int h, std::span<const AnyWindow> windows, double mostExcess) const {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3, j = cornerAfter(i);
  const double length = face.lengths[i];
  const double nearTail = bounds_[face.vertices[i]].distance;
  const double nearTip = bounds_[face.vertices[j]].distance;
  double begin = length, end = 0, least = kInfinity, excess = kInfinity;
  for (const AnyWindow& any : windows) {
    const Window& w = windowOf(any);
    // Lower bounds on the excess: the nearest distance rises at most by the way along the halfedge.
    const double atEnd = w.distanceOnEdge(w.end) - (nearTail + w.end);
    if (atEnd >= mostExcess) continue;
    const double atBegin = w.distanceOnEdge(w.begin) - (nearTip + length - w.begin);
    if (atBegin >= mostExcess) continue;
    excess = std::min(excess, std::max(atEnd, atBegin));
    begin = std::min(begin, w.begin);
    end = std::max(end, w.end);
    least = std::min(least, w.least());
  }
  if (excess == kInfinity) return std::nullopt;
  const double middle = (begin + end) / 2, share = middle / length;
  const Eigen::Vector3d place = (1 - share) * required_.placeOf(face.vertices[i]) +
                                share * required_.placeOf(face.vertices[j]);
  return required_.paths(place, end - middle, least, excess);
}

/// Whether paths through windows at a halfedge can shorten a required distance outside the
/// halfedge's face. Inside the face they have already been offered.
bool WindowSweep::canGain(int h, const std::optional<Paths>& paths) const {
  return paths && required_.canGain(*paths, [&](auto ignore) {
    for (const int v : mesh_.face(h / 3).vertices) ignore(vertices_[v].required);
    for (const auto& p : points_.in(h / 3)) ignore(p.index);
  });
}

/// Queues the windows that are awake and the waiting sources, if they can shorten a required
/// distance. The other windows sleep if distances of the label were required before: then they are
/// likely to be required again.
void WindowSweep::continueNeeded() {
  required_.findMostExcess();
  Waiting& waiting = state_->waiting;
  const bool isRepeated = required_.hasRecent();
  const double mostExcess = isRepeated ? kInfinity : required_.mostExcess();
  auto kept = waiting.awake().begin();
  visitAwake([&](int h, std::span<const WaitingWindow> windows) {
    const auto paths = pathsThrough(h, windows, mostExcess);
    if (!canGain(h, paths)) {
      const float sleepsUntil = isRepeated ? required_.sleepsUntil(*paths) : 0;
      for (const WaitingWindow& w : windows) *kept++ = {w.window, h, sleepsUntil};
      return;
    }
    const bool isFirst = windows_.isEmpty(h);
    double least = kInfinity;
    for (const WaitingWindow& w : windows) {
      windows_.add(h, {&w.window, 1});
      least = std::min(least, w.window.least());
    }
    if (isFirst) queueBatch(h, least);
  });
  waiting.windows.erase(waiting.windows.end() - (waiting.awake().end() - kept),
                        waiting.windows.end());
  if (isRepeated)
    waiting.sleep(required_.travel() + kLeastApproachesAsleep * required_.lastApproach());
  std::erase_if(waiting.sources, [&](int v) {
    if (!maySpreadFrom(v)) return false;
    queueSource(v);
    return true;
  });
}

/// Offers the paths through the batch at a halfedge to the required places of its face. If the
/// batch can shorten no other required distance, its windows wait there, and the answer is false.
bool WindowSweep::offerAndGoOn(int h) {
  const std::span<const Window> windows = windows_[h];
  const bool hasCorner = hasRequiredCorner(h / 3), hasPoints = !points_.in(h / 3).empty();
  if (hasCorner || hasPoints)
    for (const Window& w : windows) {
      if (hasCorner) offerToCorners(w, h);
      if (hasPoints) points_.offer(w, h);
    }
  if (canGain(h, pathsThrough(h, windows, required_.mostExcess()))) return true;
  for (const Window& w : windows) waiting_.windows.push_back({w, h});
  windows_.free(windows_.take(h));
  return false;
}

}  // namespace gvd::exact
