// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "gvd/diagram.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The points on the sides of faces that are not mixed. With detail, a diagram has points on the
/// sides of mixed faces that the region triangle beyond does not list.
class SidePoints {
 public:
  struct Point {
    int halfedge;  ///< of a face that is not mixed
    int order;     ///< ascending along the halfedge
    int vertex;
  };

  /// `vertexOfPoint` gives each point of the diagram a vertex. All must outlive this.
  SidePoints(const TriangleMesh& mesh, const Diagram& diagram,
             const std::vector<int>& vertexOfPoint)
      : mesh_(mesh), diagram_(diagram), vertexOfPoint_(vertexOfPoint) {}
  bool step(long& budget);
  /// The points on the sides of a face, in order. Faces come in ascending order, each once.
  std::span<const Point> next(int face);

 private:
  void collect(int firstCell);
  void gatherSides(int firstCell);
  void followSide(int h);
  bool hasSide(int from, int to) const;

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const std::vector<int>& vertexOfPoint_;

  SlicedSequence sequence_;
  /// The two ends of each side of the cells of the current face, ascending; the third is not used.
  std::vector<KeyedItem> sides_;
  std::vector<Point> points_;  ///< ascending by halfedge and order
  std::size_t next_ = 0;       ///< point
};

}  // namespace gvd
