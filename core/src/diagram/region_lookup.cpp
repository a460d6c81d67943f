// SPDX-License-Identifier: MIT
#include "diagram/region_lookup.h"

#include <algorithm>

#include "mesh/incidence.h"

namespace gvd {
namespace {

/// How deep inside of a cell a point of its face is; negative outside.
double depthInCell(const TriangleMesh& mesh, const Diagram& diagram, const SurfacePoint& p,
                   int cell) {
  const auto points = diagram.cells[cell];
  double depth = kInfinity;
  const auto inFace = [&](int point) { return baryInFace(mesh, diagram.points[point], p.face); };
  Eigen::Vector3d from = inFace(points.back());
  for (const int point : points) {
    const Eigen::Vector3d to = inFace(point), side = to - from, way = p.bary - from;
    depth = std::min(depth, side[1] * way[2] - side[2] * way[1]);
    from = to;
  }
  return depth;
}

}  // namespace

int labelAt(const TriangleMesh& mesh, const Diagram& diagram, const SurfacePoint& p) {
  int label = diagram.faceLabel[p.face];
  double deepest = -kInfinity;
  const auto begin = diagram.cellFace.begin();
  const auto [first, last] = std::equal_range(begin, diagram.cellFace.end(), p.face);
  for (auto cell = first; cell != last; ++cell) {
    const int c = static_cast<int>(cell - begin);
    const double depth = depthInCell(mesh, diagram, p, c);
    if (depth <= deepest) continue;
    deepest = depth;
    label = diagram.cellLabel[c];
  }
  return label;
}

}  // namespace gvd
