// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/sliced_loop.h"
#include "diagram/bisector_graph.h"
#include "diagram/face_complex.h"
#include "diagram/final_points.h"
#include "gvd/diagram.h"

namespace gvd {

/// Makes the cells of a diagram from those of its graph, ascending by face. Cells that merging
/// points has left no width go. A face of which all that is left is one region's, with no points on
/// its outline but nodes, is a region triangle after all.
class FinalCells {
 public:
  /// Takes the cells out of the graph, and the labels of faces.
  FinalCells(const FaceComplex& complex, BisectorGraph& graph, FinalPoints& points,
             Diagram& diagram);
  bool step(long& budget);

 private:
  bool putInOrder(long& budget);
  void linkCell(int cell);
  void copyCellsOf(int faceIndex);
  bool collect(long& budget);
  void collectFace();
  void addFinalPoints(int cell, int begin, int end);
  bool isRegionTriangle(int firstCell, int firstPoint) const;

  const FaceComplex& complex_;
  BisectorGraph& graph_;
  FinalPoints& points_;
  Diagram& out_;
  SlicedSequence sequence_, order_;
  SlicedLoop loop_;
  /// Lists of cells by face, where they are not in order.
  std::vector<int> firstOfFace_, nextOfFace_;
  // What is read of out_.cells and what is written to it, in one pass; the former is ahead.
  int read_ = 0, readBegin_ = 0;
  int written_ = 0, pointsWritten_ = 0;
};

}  // namespace gvd
