// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A face laid out for unfolding, with all that a sweep reads of it side by side. Side i runs from
/// corner i to the next one. The coordinates of a halfedge: the origin is its tail, the x axis runs
/// along it, its face lies at y >= 0.
struct alignas(128) FaceLayout {
  double length[3];
  double angle[3], cosine[3], sine[3];  ///< at corner i
  int vertex[3];
  int twin[3];

  static constexpr int after(int i) { return i == 2 ? 0 : i + 1; }
  static constexpr int before(int i) { return i == 0 ? 2 : i - 1; }

  /// The corner across from side i, in the coordinates of that side.
  double apexX(int i) const { return length[before(i)] * cosine[i]; }
  double apexY(int i) const { return length[before(i)] * sine[i]; }
  /// A point in the coordinates of side i; linear, so of differences of points too.
  Eigen::Vector2d at(int i, const Eigen::Vector3d& bary) const {
    const double toTip = bary[after(i)], toApex = bary[before(i)];
    return {toTip * length[i] + toApex * apexX(i), toApex * apexY(i)};
  }
};

/// The layouts of all faces. O(F).
std::vector<FaceLayout> layOutFaces(const TriangleMesh& mesh);

/// The corner or side of its face that a point lies on, -1 if on none; on a corner, no side.
struct Incidence {
  int corner = -1;
  int side = -1;
};
Incidence incidenceOf(const Eigen::Vector3d& bary);

/// A point of halfedge `h`, given in the halfedge's face, in terms of the face of its twin.
SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h);

}  // namespace gvd
