// SPDX-License-Identifier: MIT
#include "diagram/region_lookup.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace gvd {

using Eigen::Vector3d;

RegionLookup::RegionLookup(const TriangleMesh& mesh, const Diagram& diagram)
    : mesh_(mesh), diagram_(diagram), firstCell_(mesh.faceCount() + 1, 0) {
  for (const int face : diagram.cellFace) ++firstCell_[face + 1];
  for (int f = 0; f < mesh.faceCount(); ++f) firstCell_[f + 1] += firstCell_[f];
}

int RegionLookup::labelAt(const SurfacePoint& p) const {
  int label = diagram_.faceLabel[p.face];
  double deepest = -std::numeric_limits<double>::infinity();
  for (int c = firstCell_[p.face]; c < firstCell_[p.face + 1]; ++c) {
    const double depth = depthInCell(p, c);
    if (depth <= deepest) continue;
    deepest = depth;
    label = diagram_.cellLabel[c];
  }
  return label;
}

/// Not negative inside of a cell.
double RegionLookup::depthInCell(const SurfacePoint& p, int cell) const {
  const auto points = diagram_.cells[cell];
  double depth = std::numeric_limits<double>::infinity();
  Vector3d from = inFace(p.face, points.back());
  for (const int point : points) {
    const Vector3d to = inFace(p.face, point), side = to - from, way = p.bary - from;
    depth = std::min(depth, side[1] * way[2] - side[2] * way[1]);
    from = to;
  }
  return depth;
}

/// A point that is named once for all faces around it, in terms of one of them.
Vector3d RegionLookup::inFace(int face, int point) const {
  const SurfacePoint& p = diagram_.points[point];
  if (p.face == face) return p.bary;
  Vector3d bary = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (mesh_.tail(3 * face + i) == mesh_.tail(3 * p.face + k)) bary[i] = p.bary[k];
  return bary;
}

}  // namespace gvd
