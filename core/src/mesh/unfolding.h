// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/plane.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The apex of a halfedge's face, laid out to the left of the halfedge, whose ends are given.
inline Eigen::Vector2d apexBeside(const TriangleMesh& mesh, int halfedge,
                                  const Eigen::Vector2d& tail, const Eigen::Vector2d& tip) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  return tail + turnedBy({l.x, l.y}, (tip - tail) * (2 * l.inverse));
}

/// The distance of a halfedge's apex from those at the halfedge's two ends, infinite where not
/// known: from the virtual source that these two put behind the halfedge if it sees the apex
/// through it, else along an edge (Melvær & Reimers 2012).
inline double unfold(const TriangleMesh& mesh, int halfedge, double atTail, double atTip) {
  constexpr double kRounding = 1e-12;
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  if (std::isfinite(atTail) && std::isfinite(atTip)) {
    // The virtual source is at (x, -y), the apex at (l.x, l.y).
    const double x = ((atTail - atTip) * (atTail + atTip) + l.length * l.length) * l.inverse;
    const double squaredY = atTail * atTail - x * x;
    if (squaredY > -kRounding * atTail * atTail) {
      const double y = squaredY > 0 ? std::sqrt(squaredY) : 0;
      // Where the line between them crosses the halfedge's line, times (y + l.y).
      const double across = x * l.y + l.x * y, height = l.y + y;
      const double slack = kRounding * l.length * height;
      if (across >= -slack && across <= l.length * height + slack) {
        return std::sqrt((l.x - x) * (l.x - x) + height * height);
      }
    }
  }
  return std::min(atTail + mesh.length(TriangleMesh::previous(halfedge)),
                  atTip + mesh.length(TriangleMesh::next(halfedge)));
}

}  // namespace gvd
