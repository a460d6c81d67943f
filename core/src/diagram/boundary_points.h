// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "diagram/bisector_graph.h"

namespace gvd {

/// The boundary points of a graph in order along the mesh boundary, to walk from one to the next.
class BoundaryPoints {
 public:
  explicit BoundaryPoints(BisectorGraph& graph) : graph_(graph) {}

  /// Puts the boundary points in order along their halfedges.
  void order();
  /// The index in `BisectorGraph::boundary` of a point of the graph, which is on the boundary.
  int indexOf(int point) const;
  /// The index of the first boundary point on a halfedge, -1 if there is none.
  int firstOn(int halfedge) const;
  /// The index of the next boundary point on the same halfedge, -1 if there is none.
  int nextOnHalfedge(int index) const;

 private:
  static void chain(std::span<BisectorGraph::BoundaryPoint> points);

  BisectorGraph& graph_;
  std::vector<std::array<int, 2>> indices_;  ///< ascending: points, each with its index
};

}  // namespace gvd
