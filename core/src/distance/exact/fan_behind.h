// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Whether shortest paths may turn at a vertex: at saddle vertices, and at boundary vertices unless
/// they are convex by more than rounding.
bool isSaddle(const TriangleMesh& mesh, int vertex);

/// A part of the side across from a vertex in a face around it.
struct OppositeSide {
  int outgoing;     ///< the halfedge of the face that leaves the vertex
  double from, to;  ///< along the side, from the tip of that halfedge
};

/// The fan behind a vertex: where shortest paths that come to the vertex go on from it as a virtual
/// source, with angles of at least π on both sides (Mitchell et al. 1987, §3).
class FanBehind {
 public:
  /// The lengths of paths round by up to `rounding`.
  FanBehind(const TriangleMesh& mesh, double rounding) : mesh_(mesh), rounding_(rounding) {}

  /// The parts of the opposite sides that the vertex sees. The path to the vertex enters its last
  /// face across the halfedge `arrival`, at `fromFoot` from the foot of the vertex on it. Arrival
  /// -1: the path starts at the vertex, which sees all sides. Valid until the next call.
  std::span<const OppositeSide> sides(int vertex, int arrival, double fromFoot);

 private:
  /// The end of a turn by π, begun in the face that the path arrives by: the number of faces
  /// passed, -1 if the fan ends before π; and the direction, relative to the side by which the turn
  /// entered its last face.
  struct Turn {
    int step = -1;
    Eigen::Vector2d rest = {0, 0};
  };
  template <class OutgoingAt>
  Turn turnByPi(Eigen::Vector2d turned, int steps, OutgoingAt outgoingAt) const;

  double oppositeLength(int outgoing) const;
  double meetOpposite(int outgoing, const Eigen::Vector2d& direction) const;

  const TriangleMesh& mesh_;
  const double rounding_;
  std::vector<OppositeSide> sides_;
};

}  // namespace gvd::exact
