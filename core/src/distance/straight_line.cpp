// SPDX-License-Identifier: MIT
#include "distance/straight_line.h"

#include <algorithm>

#include "base/plane.h"
#include "mesh/face_layout.h"

namespace gvd {

using Eigen::Vector2d;

bool StraightLine::enterFace(const TriangleMesh& mesh) {
  const int twin = mesh.twin(halfedge);
  if (twin < 0) return false;
  const double end = mesh.length(halfedge);
  halfedge = twin;
  along = end - along;
  source = Vector2d(end, 0) - source;
  return true;
}

bool StraightLine::crossFace(const TriangleMesh& mesh) {
  const TriangleMesh::Face& face = mesh.face(halfedge / 3);
  const int i = halfedge % 3;
  const Vector2d from(along, 0), apex = apexOf(face, i);
  const bool isLeft = cross(apex - from, source - from) > 0;
  const int corner = isLeft ? i : cornerAfter(i), side = isLeft ? cornerBefore(i) : corner;
  // In the coordinates of the side, which is turned by the face's own angle: a needle's short side
  // has no precise direction in the coordinates of its ends.
  const double c = face.cosines[corner], s = face.sines[corner];
  const auto fromSide = [&](const Vector2d& p) {
    const double ahead = isLeft ? p.x() : face.lengths[i] - p.x();
    const double onSide = c * ahead + s * p.y();
    return Vector2d(isLeft ? face.lengths[side] - onSide : onSide, s * ahead - c * p.y());
  };
  const Vector2d there = fromSide(source), here = fromSide(from);
  const double height = std::max(here.y(), 0.0), depth = std::max(-there.y(), 0.0);
  const double share = depth > 0 ? height / (height + depth) : 1;
  halfedge += side - i;
  along = std::clamp(here.x() + (there.x() - here.x()) * share, 0.0, face.lengths[side]);
  source = there;
  return depth > 0;
}

}  // namespace gvd
