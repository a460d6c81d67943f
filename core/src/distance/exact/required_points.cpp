// SPDX-License-Identifier: MIT
#include "distance/exact/required_points.h"

#include <algorithm>
#include <tuple>

#include "base/sorting.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd::exact {

void RequiredPoints::set(std::span<const RequiredPoint> points, const LabelVertices& vertices) {
  inFaces_.clear();
  for (const auto& [point, distance, nearest] : points) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      place += point.bary[i] * distances_.placeOf(mesh_.tail(3 * point.face + i));
    const int index = distances_.add(place, distance, nearest);
    visitRepresentations(mesh_, point, [&](const SurfacePoint& p) {
      inFaces_.push_back({p.face, p.bary, index});
      const TriangleMesh::Face& face = mesh_.face(p.face);
      for (int i = 0; i < 3; ++i)
        distances_.lower(index,
                         vertices.distance(face.vertices[i]) + distanceToCorner(face, p.bary, i));
    });
  }
  sortStably(std::span(inFaces_), [](const InFace& a, const InFace& b) {
    return std::tie(a.face, a.index) < std::tie(b.face, b.index);
  });
}

std::span<const RequiredPoints::InFace> RequiredPoints::in(int face) const {
  const auto [first, last] =
      std::equal_range(inFaces_.begin(), inFaces_.end(), InFace{face, {}, 0},
                       [](const InFace& a, const InFace& b) { return a.face < b.face; });
  return std::span(inFaces_).subspan(first - inFaces_.begin(), last - first);
}

void RequiredPoints::offer(const Window& w, int h) {
  for (const InFace& p : in(h / 3)) {
    const Eigen::Vector2d q = layOut(mesh_.face(h / 3), h % 3, p.bary);
    distances_.lower(p.index, w.distance(q.x(), q.y()));
  }
}

void RequiredPoints::offerFrom(int corner, int face, double distance) {
  for (const InFace& p : in(face))
    distances_.lower(p.index, distance + distanceToCorner(mesh_.face(face), p.bary, corner));
}

}  // namespace gvd::exact
