// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "gvd/triangle_mesh.h"

namespace gvd {

/// The rest of a straight line of the unfolded faces: from a point of a halfedge to a virtual
/// source, in the coordinates of the halfedge. The line is about to leave the halfedge's face, so
/// the source lies at y <= 0.
struct StraightLine {
  int halfedge = -1;
  double along = 0;  ///< the point, from the halfedge's tail
  Eigen::Vector2d source = {0, 0};

  double length() const { return (source - Eigen::Vector2d(along, 0)).norm(); }

  /// Turns to the face behind the halfedge: the source lies at y >= 0 then. False at the boundary.
  bool enterFace(const TriangleMesh& mesh);
  /// Goes on to the side by which the line leaves the face that it has entered. If the source lies
  /// in the face, goes to the point of that side next to the source, and returns false. Each face
  /// aims the line at its source anew, so that it stays in connected faces even if rounding puts it
  /// on the wrong side of a vertex.
  bool crossFace(const TriangleMesh& mesh);
};

}  // namespace gvd
