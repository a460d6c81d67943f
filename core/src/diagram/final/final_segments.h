// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/final/final_points.h"
#include "diagram/final/outline_steps.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/diagram.h"

namespace gvd {

/// Makes the bisector segments of a diagram from those of its graph. Segments that end at merged
/// points may lie on top of each other, or on the mesh boundary, with a region of no width between
/// them. Such segments are joined, and the outermost labels remain. A point on an edge or a vertex
/// is given in a face of one of its segments.
class FinalSegments {
 public:
  /// Takes the segments out of the graph.
  FinalSegments(const TriangleMesh& mesh, BisectorGraph& graph,
                std::span<const OutlineSteps::BoundaryStep> boundarySteps, FinalPoints& points,
                Diagram& diagram);
  bool step(long& budget);

 private:
  /// The labels on the sides of a line from the lower point to the higher one; -1 off the mesh.
  struct Line {
    int left, right, face;
  };
  void addSegment(const Diagram::Segment& segment);
  void stack(int from, int to, int left, int right, int face);
  bool addStacks(long& budget);
  void addLines(const PlaceOfLine& place, std::vector<Line>& lines);
  static void joinLines(std::vector<Line>& lines);
  void noteInFace(const Diagram::Segment& segment);
  void moveToFaceOf(const Diagram::Segment& segment);

  const TriangleMesh& mesh_;
  BisectorGraph& graph_;
  const std::span<const OutlineSteps::BoundaryStep> boundarySteps_;
  FinalPoints& points_;
  Diagram& out_;
  SlicedSequence sequence_;
  size_t kept_ = 0;
  std::map<PlaceOfLine, std::vector<Line>> stacks_;  ///< the lines at each place
  std::vector<char> isInFaceOfSegment_;  ///< per point: given in a face of one of its segments
};

}  // namespace gvd
