// SPDX-License-Identifier: MIT
// This work is based on:
// Shi-Qing Xin, Guo-Jin Wang. Efficiently Determining a Locally Exact Shortest Path on Polyhedral
// Surfaces. 2007
#include "dgpc/face_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/plane.h"
#include "dgpc/dgpc_view.h"
#include "distance/site_frame.h"
#include "mesh/surface_geometry.h"
#include "mesh/unfolding.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

/// The halfedge of a face that leaves one of its corners.
int outgoingOf(const TriangleMesh& mesh, int face, int vertex) {
  int h = 3 * face;
  while (mesh.tail(h) != vertex) ++h;
  return h;
}

/// The angle of a halfedge at its tail, counterclockwise from the first one there.
double angleOf(const TriangleMesh& mesh, int halfedge) {
  double angle = 0;
  for (int h = mesh.outgoing(mesh.tail(halfedge)); h != halfedge; h = mesh.rotate(h))
    angle += mesh.cornerAngle(h);
  return angle;
}

}  // namespace

// --- Faces ---

void FaceStrip::start(int face, std::span<const int> through) {
  lastFace_ = face;
  crossed_.clear();
  for (const int h : through) goThrough(h);
}

void FaceStrip::goThrough(int halfedge) {
  lastFace_ = TriangleMesh::faceOf(mesh_.twin(halfedge));
  if (!crossed_.empty() && mesh_.twin(crossed_.back()) == halfedge)
    crossed_.pop_back();
  else
    crossed_.push_back(halfedge);
}

bool FaceStrip::turn(int vertex, int face) {
  if (face == lastFace_) return true;
  // One step to the left and one to the right in turn, until one of them has arrived.
  int left = outgoingOf(mesh_, lastFace_, vertex), right = left, steps = 0;
  while (left >= 0 || right >= 0) {
    ++steps;
    if (left >= 0) left = mesh_.rotate(left);
    if (right >= 0) right = mesh_.twin(right);
    if (right >= 0) right = TriangleMesh::next(right);
    const bool isLeft = left >= 0 && TriangleMesh::faceOf(left) == face;
    if (!isLeft && (right < 0 || TriangleMesh::faceOf(right) != face)) continue;
    for (int h = outgoingOf(mesh_, lastFace_, vertex); steps > 0; --steps) {
      const int over = isLeft ? TriangleMesh::previous(h) : h;
      goThrough(over);
      h = isLeft ? mesh_.twin(over) : TriangleMesh::next(mesh_.twin(over));
    }
    return true;
  }
  return false;
}

// --- Straightening ---

std::optional<LocalGeodesic> FaceStrip::straighten(int vertex, const SurfacePoint& end) {
  constexpr int kMostFlips = 100;
  vertex_ = vertex;
  endVertex_ = vertexAt(mesh_, end);
  for (int flips = 0; flips < kMostFlips; ++flips) {
    trim(vertex, endVertex_);
    if (crossed_.empty()) {
      bends_.clear();
      const LocalGeodesic path = acrossOneFace(vertex, endVertex_, end);
      length_ = path.length;
      return path;
    }
    unfold(endVertex_, end);
    pullTight();
    // From the end, so that what comes before keeps its place. No two are in each other's way: the
    // path so far lies in the new strip as well.
    bool isFlipped = false;
    for (size_t i = bends_.size(); i-- > 0;) isFlipped |= mayFlip(i) && flip(bends_[i]);
    if (!isFlipped) return path(end);
  }
  return std::nullopt;
}

/// Takes away what leads around the path's own ends.
void FaceStrip::trim(int vertex, int endVertex) {
  size_t first = 0;
  while (first < crossed_.size() && isEnd(crossed_[first], vertex)) ++first;
  crossed_.erase(crossed_.begin(), crossed_.begin() + static_cast<std::ptrdiff_t>(first));
  while (!crossed_.empty() && isEnd(crossed_.back(), endVertex)) {
    lastFace_ = TriangleMesh::faceOf(crossed_.back());
    crossed_.pop_back();
  }
}

LocalGeodesic FaceStrip::acrossOneFace(int vertex, int endVertex, const SurfacePoint& end) const {
  LocalGeodesic path{0, {1, 0}};
  if (endVertex < 0) {
    const int corner = outgoingOf(mesh_, end.face, vertex) % 3;
    path.length = distanceOfCorner(mesh_, end, corner);
    path.departure = viewOfCorner(mesh_, end, corner).departure(mesh_, path.length);
  } else if (vertex != endVertex) {
    const double first = angleOfOutgoing(mesh_, end, mesh_.outgoing(endVertex));
    visitSpokes(mesh_, endVertex, [&](const Spoke& spoke) {
      if (spoke.neighbour == vertex) path = {spoke.length, unitVector(first + spoke.angle)};
    });
  }
  return path;
}

/// Into the frame of the first halfedge that is crossed.
void FaceStrip::unfold(int endVertex, const SurfacePoint& end) {
  const TriangleMesh::Layout& first = mesh_.layout(crossed_.front());
  start_ = {first.x, first.y};
  gates_.clear();
  Gate gate{{first.length, 0}, {0, 0}};
  for (size_t i = 0;; ++i) {
    gates_.push_back(gate);
    const int entry = mesh_.twin(crossed_[i]);
    const Vector2d apex = apexBeside(mesh_, entry, gate.left, gate.right);
    if (i + 1 == crossed_.size()) {
      const int corner = entry % 3;
      end_ = endVertex >= 0
                 ? apex
                 : Vector2d(end.bary[corner] * gate.left + end.bary[(corner + 1) % 3] * gate.right +
                            end.bary[(corner + 2) % 3] * apex);
      return;
    }
    (crossed_[i + 1] == TriangleMesh::next(entry) ? gate.left : gate.right) = apex;
  }
}

/// Finds the bends of the shortest path in the strip: all that is in sight through the gates from
/// the last bend lies between two ends of gates; where the way out lies beside these, the path
/// bends at the one on that side.
void FaceStrip::pullTight() {
  bends_.clear();
  Vector2d from = start_;
  size_t left = 0, right = 0;
  for (size_t i = 1; i <= gates_.size();) {
    const Gate gate = i < gates_.size() ? gates_[i] : Gate{end_, end_};
    const Vector2d toLeft = gates_[left].left - from, toRight = gates_[right].right - from;
    const bool bendsLeft = cross(toLeft, gate.right - from) > 0;
    if (bendsLeft || cross(toRight, gate.left - from) < 0) {
      const Side side = bendsLeft ? Side::kLeft : Side::kRight;
      size_t next = bendsLeft ? left : right;
      from = bendsLeft ? gates_[left].left : gates_[right].right;
      const int vertex = endAt(next, side);
      bends_.push_back({from, vertex, next, side});
      while (next < gates_.size() && endAt(next, side) == vertex) ++next;
      if (next == gates_.size()) return;  // the end is in sight
      left = right = next;
      i = next + 1;
      continue;
    }
    if (i < gates_.size()) {
      if (cross(toLeft, gate.left - from) <= 0) left = i;
      if (cross(toRight, gate.right - from) >= 0) right = i;
    }
    ++i;
  }
}

/// Whether the path is shorter on the other side of a vertex at which it bends: the angle there is
/// less than π.
bool FaceStrip::mayFlip(size_t bend) const {
  constexpr double kRounding = 1e-12;
  const int vertex = bends_[bend].vertex;
  if (mesh_.onBoundary(vertex)) return false;
  const double excess = mesh_.angleSum(vertex) - 2 * pi + kRounding;
  if (excess < 0) return true;
  const Vector2d before = bend > 0 ? bends_[bend - 1].place : start_;
  const Vector2d after = bend + 1 < bends_.size() ? bends_[bend + 1].place : end_;
  const Vector2d in = bends_[bend].place - before, out = after - bends_[bend].place;
  return std::abs(std::atan2(cross(in, out), in.dot(out))) > excess;
}

size_t FaceStrip::firstGate(const Bend& bend) const {
  size_t gate = bend.gate;
  while (gate > 0 && endAt(gate - 1, bend.side) == bend.vertex) --gate;
  return gate;
}

size_t FaceStrip::lastGate(const Bend& bend) const {
  size_t gate = bend.gate;
  while (gate + 1 < crossed_.size() && endAt(gate + 1, bend.side) == bend.vertex) ++gate;
  return gate;
}

/// Leads the strip around the other side of a vertex. False if the strip has come to pass it
/// otherwise meanwhile.
bool FaceStrip::flip(const Bend& bend) {
  const auto passes = [&](size_t gate) { return endAt(gate, bend.side) == bend.vertex; };
  if (bend.gate >= crossed_.size() || !passes(bend.gate)) return false;
  const size_t first = firstGate(bend), last = lastGate(bend);
  const int goal = TriangleMesh::faceOf(mesh_.twin(crossed_[last]));
  detour_.clear();
  int h = outgoingOf(mesh_, TriangleMesh::faceOf(crossed_[first]), bend.vertex);
  do {
    const int over = bend.side == Side::kLeft ? h : TriangleMesh::previous(h);
    const int twin = mesh_.twin(over);
    detour_.push_back(over);
    h = bend.side == Side::kLeft ? TriangleMesh::next(twin) : twin;
  } while (TriangleMesh::faceOf(h) != goal);

  // One by one, for the strip may have come through one of them, or go on through one.
  rest_.assign(crossed_.begin() + static_cast<std::ptrdiff_t>(last) + 1, crossed_.end());
  crossed_.resize(first);
  for (const int over : detour_) goThrough(over);
  for (const int over : rest_) goThrough(over);
  return true;
}

const std::vector<FaceStrip::Piece>& FaceStrip::pieces() {
  pieces_.clear();
  if (bends_.empty()) {
    const int face = crossed_.empty() ? lastFace_ : TriangleMesh::faceOf(crossed_.front());
    pieces_.push_back({vertex_, face, crossed_, length_, 0});
    return pieces_;
  }
  const std::span<const int> crossed = crossed_;
  for (size_t i = 0; i <= bends_.size(); ++i) {
    // Two bends may be the ends of one gate: between them, then, nothing is crossed.
    const size_t begin = i > 0 ? lastGate(bends_[i - 1]) + 1 : 0;
    const size_t end = i < bends_.size() ? firstGate(bends_[i]) : crossed_.size();
    const size_t first = std::min(begin, end);
    const int face = first < crossed_.size() ? TriangleMesh::faceOf(crossed_[first]) : lastFace_;
    const Vector2d from = i > 0 ? bends_[i - 1].place : start_;
    const Vector2d way = (i < bends_.size() ? bends_[i].place : end_) - from;
    pieces_.push_back({i > 0 ? bends_[i - 1].vertex : vertex_, face,
                       crossed.subspan(first, end - first), way.norm(),
                       i > 0 ? angleBehind(bends_[i - 1], way) : 0});
  }
  return pieces_;
}

/// The angle of a direction at a bend, in the frame of the faces behind it.
double FaceStrip::angleBehind(const Bend& bend, const Vector2d& direction) const {
  const bool isLeft = bend.side == Side::kLeft;
  const size_t gate = lastGate(bend);
  const int outgoing = isLeft ? mesh_.twin(crossed_[gate]) : crossed_[gate];
  const Vector2d along = placeAt(gate, isLeft ? Side::kRight : Side::kLeft) - bend.place;
  return angleOf(mesh_, outgoing) + std::atan2(cross(along, direction), along.dot(direction));
}

double FaceStrip::angleAtEnd() const {
  if (crossed_.empty()) {
    const int outgoing = outgoingOf(mesh_, lastFace_, endVertex_);
    const bool isAlong = mesh_.tip(outgoing) == vertex_;
    return angleOf(mesh_, outgoing) + (isAlong ? 0 : mesh_.cornerAngle(outgoing));
  }
  const int entry = mesh_.twin(crossed_.back());
  const Vector2d aside = gates_.back().left - end_;
  const Vector2d back = (bends_.empty() ? start_ : bends_.back().place) - end_;
  return angleOf(mesh_, TriangleMesh::previous(entry)) +
         std::atan2(cross(aside, back), aside.dot(back));
}

LocalGeodesic FaceStrip::path(const SurfacePoint& end) {
  length_ = 0;
  Vector2d before = start_;
  for (const Bend& bend : bends_) {
    length_ += (bend.place - before).norm();
    before = bend.place;
  }
  const Vector2d back = before - end_;
  length_ += back.norm();
  const int entry = mesh_.twin(crossed_.back());
  const Vector2d along = (gates_.back().right - gates_.back().left) / mesh_.length(entry);
  return {length_, inSiteFrame(mesh_, end, entry, turnedBackBy(back, along)), !bends_.empty()};
}

}  // namespace gvd
