// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/plane.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The apex of a halfedge's face, laid out to the left of the halfedge, whose ends are given.
inline Eigen::Vector2d apexBeside(const TriangleMesh& mesh, int halfedge,
                                  const Eigen::Vector2d& tail, const Eigen::Vector2d& tip) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  return tail + turnedBy({l.x, l.y}, (tip - tail) * (2 * l.inverse));
}

/// A place that rounding alone may have put beyond a halfedge or its line, as a share of lengths.
inline constexpr double kUnfoldingRounding = 1e-12;

/// Where a source is behind a halfedge, in the halfedge's frame, that has these distances, finite
/// ones, from its two ends. Nothing if there is no such place.
inline std::optional<Eigen::Vector2d> virtualSource(const TriangleMesh& mesh, int halfedge,
                                                    double atTail, double atTip) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  const double x = ((atTail - atTip) * (atTail + atTip) + l.length * l.length) * l.inverse;
  const double squaredY = atTail * atTail - x * x;
  if (!(squaredY > -kUnfoldingRounding * atTail * atTail)) return std::nullopt;
  return Eigen::Vector2d(x, -std::sqrt(std::max(squaredY, 0.0)));
}

/// Whether a source behind a halfedge, in the halfedge's frame, sees the apex through it.
inline bool seesApex(const TriangleMesh& mesh, int halfedge, const Eigen::Vector2d& source) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  // Where the line between them crosses the halfedge's line, times their height.
  const double across = source.x() * l.y - l.x * source.y(), height = l.y - source.y();
  const double slack = kUnfoldingRounding * l.length * height;
  return across >= -slack && across <= l.length * height + slack;
}

/// The distance of a halfedge's apex from those at the halfedge's two ends, infinite where not
/// known: from the virtual source that these two put behind the halfedge if it sees the apex
/// through it, else along an edge (Melvær & Reimers 2012).
inline double unfold(const TriangleMesh& mesh, int halfedge, double atTail, double atTip) {
  if (std::isfinite(atTail) && std::isfinite(atTip)) {
    const auto source = virtualSource(mesh, halfedge, atTail, atTip);
    const TriangleMesh::Layout& l = mesh.layout(halfedge);
    if (source && seesApex(mesh, halfedge, *source))
      return (Eigen::Vector2d(l.x, l.y) - *source).norm();
  }
  return std::min(atTail + mesh.length(TriangleMesh::previous(halfedge)),
                  atTip + mesh.length(TriangleMesh::next(halfedge)));
}

}  // namespace gvd
