// SPDX-License-Identifier: MIT
#pragma once

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "diagram/bisector_graph.h"
#include "diagram/face_complex.h"
#include "diagram/final_points.h"
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
  bool putInOrder(long& budget);
  void copyCell(int cell);
  bool collect(long& budget);
  void collectFace();
  void addFinalPoints(int cell, int begin, int end);
  bool isRegionTriangle(int firstCell, int firstPoint) const;

  const FaceComplex& complex_;
  BisectorGraph& graph_;
  FinalPoints& points_;
  Diagram& out_;
  SlicedSequence sequence_, order_;
  Grouping byFace_;  ///< cells, where they are not in order
  // `out_.cells` is compacted in one pass: the positions read from and written to; the former is
  // ahead.
  int read_ = 0, readBegin_ = 0;
  int written_ = 0, pointsWritten_ = 0;
};

}  // namespace gvd
