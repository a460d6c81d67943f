// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "diagram/complex/face_complex.h"
#include "diagram/final/final_points.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/diagram.h"

namespace gvd {

/// Makes the cells of a diagram from those of its graph, ascending by face. Cells that merging
/// points has left without width are dropped. A face whose remaining cells all belong to one
/// region, with nodes as their only points, becomes a region triangle.
class FinalCells {
 public:
  /// Takes the cells out of the graph.
  FinalCells(const FaceComplex& complex, BisectorGraph& graph, FinalPoints& points,
             Diagram& diagram)
      : complex_(complex), graph_(graph), points_(points), out_(diagram) {}
  bool step(long& budget);

 private:
  void addFace(std::span<const int> cells);
  void addCell(int cell);
  bool isRegionTriangle(size_t firstCell, size_t firstPoint) const;

  const FaceComplex& complex_;
  BisectorGraph& graph_;
  FinalPoints& points_;
  Diagram& out_;
  SlicedSequence sequence_;
  Grouping byFace_;  ///< cells
};

}  // namespace gvd
