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
  const Vector2d from(along, 0), tail(0, 0), tip(face.lengths[i], 0), apex = apexOf(face, i);
  const bool isLeft = cross(apex - from, source - from) > 0;
  const int side = isLeft ? cornerBefore(i) : cornerAfter(i);
  const Vector2d origin = isLeft ? apex : tip;
  const Vector2d axis = ((isLeft ? tail : apex) - origin) / face.lengths[side];
  const Vector2d there = turnedBackBy(source - origin, axis);
  const Vector2d here = turnedBackBy(from - origin, axis);
  const double height = std::max(here.y(), 0.0), depth = std::max(-there.y(), 0.0);
  const double share = depth > 0 ? height / (height + depth) : 1;
  halfedge += side - i;
  along = std::clamp(here.x() + (there.x() - here.x()) * share, 0.0, face.lengths[side]);
  source = there;
  return depth > 0;
}

}  // namespace gvd
