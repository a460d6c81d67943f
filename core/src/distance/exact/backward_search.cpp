// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
#include "distance/exact/backward_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "distance/face_layout.h"
#include "distance/path_points.h"
#include "mesh/surface_geometry.h"

namespace gvd::exact {

using Eigen::Vector2d;

const std::vector<FirstPiece>& BackwardSearch::run(const SurfacePoint& p, int label,
                                                   const VertexDistances& known) {
  label_ = label;
  known_ = &known;
  bound_ = kInfinity;
  queue_.clear();
  found_.clear();
  visitPlaces(mesh_, p, [&](const SurfacePoint& place) { startIn(place); });
  if (bound_ < kInfinity)
    visitPlaces(mesh_, p, [&](const SurfacePoint& place) { leave(place); });
  const auto isLater = [](const Item& a, const Item& b) { return a.least > b.least; };
  while (!queue_.empty() && queue_.front().least <= bound_) {
    std::pop_heap(queue_.begin(), queue_.end(), isLater);
    const Item item = queue_.back();
    queue_.pop_back();
    cross(item);
  }
  std::erase_if(found_, [&](const FirstPiece& piece) { return piece.distance > bound_; });
  return found_;
}

/// The straight pieces that end in a face which has the point.
void BackwardSearch::startIn(const SurfacePoint& place) {
  const TriangleMesh::Face& face = mesh_.face(place.face);
  for (const FaceSite& site : sites_.inFace(place.face)) {
    const double length = layOut(face, 0, site.bary - place.bary).norm();
    offer({.label = site.label, .distance = length, .length = length});
  }
  for (int i = 0; i < 3; ++i) {
    const double length = wayToCorner(face, place.bary, i).norm();
    offer({.vertex = face.vertices[i],
           .distance = length + known_->atMost(face.vertices[i]),
           .length = length});
  }
}

/// The windows through the sides of a face which has the point, but for one that the point is on.
void BackwardSearch::leave(const SurfacePoint& place) {
  const TriangleMesh::Face& face = mesh_.face(place.face);
  for (int i = 0; i < 3; ++i) {
    if (place.bary[cornerBefore(i)] == 0 || face.twins[i] < 0) continue;
    const Vector2d p = layOut(face, i, place.bary);
    add({.begin = 0,
         .end = face.lengths[i],
         .x = face.lengths[i] - p.x(),
         .y = -p.y(),
         .sourceDistance = 0,
         .direction = std::numbers::pi},
        face.twins[i], 3 * place.face + i);
  }
}

/// Offers what can be seen in a face through a window, and goes on beyond.
void BackwardSearch::cross(const Item& item) {
  const int h = item.halfedge, f = h / 3, i = h % 3;
  const TriangleMesh::Face& face = mesh_.face(f);
  const Window& w = item.window;
  const double grazing = kGrazing * face.lengths[i];
  const auto offerAt = [&](const Vector2d& end, FirstPiece piece, double rest) {
    const double crossing = w.crossing(end.x(), end.y());
    if (!(crossing >= w.begin - grazing && crossing <= w.end + grazing)) return;
    piece.length = w.distance(end.x(), end.y());
    piece.distance = piece.length + rest;
    piece.halfedge = item.first;
    piece.angle = w.direction + std::atan2(end.y() - w.y, end.x() - w.x);
    offer(piece);
  };
  for (const FaceSite& site : sites_.inFace(f))
    offerAt(layOut(face, i, site.bary), {.label = site.label}, 0);
  const int apex = face.vertices[cornerBefore(i)];
  const Vector2d p = apexOf(face, i);
  offerAt(p, {.vertex = apex}, known_->atMost(apex));

  const double crossing = w.crossing(p.x(), p.y());
  const int left = face.twins[cornerBefore(i)], right = face.twins[cornerAfter(i)];
  if (left >= 0 && crossing > w.begin)
    add(windowBeyond<Side::kLeft>(w, face, i, crossing), left, item.first);
  if (right >= 0 && crossing < w.end)
    add(windowBeyond<Side::kRight>(w, face, i, crossing), right, item.first);
}

/// Cuts off what is too long by the distances at the ends of the halfedge.
void BackwardSearch::add(Window w, int h, int first) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  const double length = face.lengths[i];
  const double atTail = known_->atLeast(face.vertices[i]);
  const double atTip = known_->atLeast(face.vertices[cornerAfter(i)]);
  w.y = std::min(w.y, -0x1p-52 * length);
  trim(w, length, {bound_ - atTail, bound_ - atTip});
  if (!(w.begin < w.end)) return;
  const double least = std::max(w.distanceOnEdge(w.end) - w.end + atTail,
                                w.distanceOnEdge(w.begin) - (length - w.begin) + atTip);
  if (least > bound_) return;
  queue_.push_back({least, first, h, w});
  std::push_heap(queue_.begin(), queue_.end(),
                 [](const Item& a, const Item& b) { return a.least > b.least; });
}

void BackwardSearch::offer(const FirstPiece& piece) {
  if (piece.label >= 0 && label_ >= 0 && piece.label != label_) return;
  if (!(piece.distance <= bound_) || piece.distance == kInfinity) return;
  bound_ = std::min(bound_, piece.distance * (1 + kDistanceTolerance));
  found_.push_back(piece);
}

StraightLine lineAlong(const TriangleMesh& mesh, const SurfacePoint& p, const FirstPiece& piece) {
  const int i = piece.halfedge % 3;
  const Vector2d from = layOut(mesh.face(piece.halfedge / 3), i, baryInFace(mesh, p, piece.halfedge / 3));
  const Vector2d end = from + piece.length * Vector2d(std::cos(piece.angle), std::sin(piece.angle));
  const double along = from.x() + (end.x() - from.x()) * (from.y() / (from.y() - end.y()));
  return {piece.halfedge, std::clamp(along, 0.0, mesh.length(piece.halfedge)), end};
}

}  // namespace gvd::exact
