// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "exact/exact_frame.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Whether shortest paths may bend at a vertex: at saddles, and on the boundary where it is not
/// convex.
bool bendsPaths(const TriangleMesh& mesh, int vertex);

/// A part of the side across from a vertex in a face around it.
struct OppositeSide {
  int outgoing;     ///< the halfedge of the face that leaves the vertex
  double from, to;  ///< along the side, from the tip of that halfedge
};

/// How paths that have come to a vertex go on there as shortest ones: with angles of π at least on
/// both sides (Mitchell et al. 1987, §3).
class Bend {
 public:
  Bend(const TriangleMesh& mesh, std::span<const Frame> frames) : mesh_(mesh), frames_(frames) {}

  /// The opposite sides, or parts of them, that the vertex is seen from as a virtual source.
  /// `arrival` is the halfedge across which the path has entered its last face, of which the vertex
  /// is the apex, and `crossing` the place on it; arrival -1: the path starts at the vertex, and
  /// all around see it. Valid until the next call.
  std::span<const OppositeSide> sidesBehind(int vertex, int arrival, double crossing);

 private:
  /// Where a turn by π ends: in the face met after so many steps, -1 if before; and the direction
  /// there, from the side by which the turn entered that face.
  struct Turn {
    int step = -1;
    Eigen::Vector2d rest = {0, 0};
  };
  template <class OutgoingAt>
  Turn turnByPi(Eigen::Vector2d turned, int steps, OutgoingAt outgoingAt) const;

  void collectFan(int vertex);
  double oppositeLength(int outgoing) const;
  double meetOpposite(int outgoing, const Eigen::Vector2d& direction) const;

  const TriangleMesh& mesh_;
  std::span<const Frame> frames_;
  std::vector<int> fan_;  ///< halfedges that leave the vertex, counterclockwise
  bool isClosed_ = false;
  std::vector<OppositeSide> sides_;
};

}  // namespace gvd::exact
