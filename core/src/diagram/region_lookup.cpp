// SPDX-License-Identifier: MIT
#include "diagram/region_lookup.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "mesh/representations.h"

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
  const auto inFace = [&](int point) { return baryInFace(mesh_, diagram_.points[point], p.face); };
  Vector3d from = inFace(points.back());
  for (const int point : points) {
    const Vector3d to = inFace(point), side = to - from, way = p.bary - from;
    depth = std::min(depth, side[1] * way[2] - side[2] * way[1]);
    from = to;
  }
  return depth;
}

}  // namespace gvd
