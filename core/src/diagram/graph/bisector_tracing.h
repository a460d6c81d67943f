// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/index_map.h"
#include "base/sliced_loop.h"
#include "diagram/complex/face_complex.h"
#include "diagram/graph/bisector_graph.h"
#include "diagram/graph/element_functions.h"
#include "diagram/graph/element_points.h"
#include "diagram/graph/face_envelope.h"
#include "gvd/diagram.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Builds the bisector graph from the lower envelope on every mixed element.
class BisectorTracing {
 public:
  /// Sets the areas of regions, the labels of faces and the indifferent faces of `diagram`, whose
  /// number of sites is set. If no face is split, the sole owners of the faces are their labels,
  /// and are taken out of the complex.
  BisectorTracing(FaceComplex& complex, IndexMap& pointOfNode, BisectorGraph& graph,
                  Diagram& diagram);
  /// True when the graph is complete.
  bool step(long& budget);

 private:
  void reserve();
  long add(int element);
  void assign(int element, int owner);
  long divide(int element);
  bool isIndifferent(int element, int owner) const;
  double addCell(int element, const FaceEnvelope::Cell& cell);
  void addAreas(double faceArea);
  void addUnmatchedSide(int element, int side, int vertex);
  void addBoundaryPoint(int h, int vertex);
  void addSegment(int element, const FaceEnvelope::Segment& added);
  void join(int point, int label, int dart, bool leaves);
  int segmentAcross(int point, int added);
  void link(int first, int second);

  const TriangleMesh& mesh_;
  FaceComplex& complex_;
  BisectorGraph& graph_;
  Diagram& out_;

  SlicedSequence sequence_;
  ElementFunctions functions_;
  FaceEnvelope envelope_;
  ElementPoints points_;

  std::vector<double> cellAreas_;  ///< of the current element
};

}  // namespace gvd
