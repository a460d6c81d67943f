// SPDX-License-Identifier: MIT
//
// Points given by callers, whose coordinates are rounded.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "base/rejection.h"
#include "base/tolerances.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Barycentric coordinates below this are set to zero in points given by callers: 512 times the
/// rounding 2^-53, and less than `kMaxPointError`.
inline constexpr double kCoordinateRounding = 0x1p-44;

/// Barycentric coordinates that are valid within `kBarycentricTolerance` as coordinates that are
/// not negative and sum to 1 but for rounding. A point within rounding of an edge or vertex is
/// moved onto it: unfolded into the faces beside it, it might come out on the wrong side.
inline Eigen::Vector3d cleanBarycentric(const Eigen::Vector3d& bary) {
  const Eigen::Vector3d clamped = (bary.array() < kCoordinateRounding).select(0, bary);
  const double sum = clamped.sum();
  if (clamped == bary && std::abs(sum - 1) <= kCoordinateRounding) return bary;
  return clamped / sum;
}

/// A point from outside with clean coordinates. Throws `Error(kInvalidPoint)` if it is not on the
/// mesh; the message begins with `what`.
inline SurfacePoint onMesh(const TriangleMesh& mesh, const SurfacePoint& p,
                           const std::string& what = {}) {
  if (const std::string fault = mesh.faultOfPoint(p); !fault.empty()) rejectPoint(what + fault);
  return {p.face, cleanBarycentric(p.bary)};
}

/// The same of a point of a list; the message begins with `what` and the index.
inline SurfacePoint onMesh(const TriangleMesh& mesh, const SurfacePoint& p, const char* what,
                           std::size_t index) {
  if (const std::string fault = mesh.faultOfPoint(p); !fault.empty())
    rejectPoint(std::string(what) + " " + std::to_string(index) + ": " + fault);
  return {p.face, cleanBarycentric(p.bary)};
}

}  // namespace gvd
