// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_map.h"
#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "diagram/complex/face_complex.h"
#include "diagram/final/outline_steps.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The closed outlines of regions: rings of darts and steps along the mesh boundary, without the
/// pieces that merging points has reduced to nothing (`OutlineSteps`). A ring without merged points
/// is an outline already.
class RegionOutlines {
 public:
  /// Traces some labels, or all if `labels` is null. Adds points to the graph where outlines pass
  /// vertices on the mesh boundary.
  RegionOutlines(const FaceComplex& complex, const DistanceField& distances, IndexMap& pointOfNode,
                 const IndexSet* labels, BisectorGraph& graph);
  /// True when all outlines are traced. A step traces whole rings, whatever their length.
  bool step(long& budget);

  int size() const { return static_cast<int>(outlines_.size()); }
  /// Ascending.
  int label(int outline) const { return outlines_[outline].label; }
  /// In order, as roots of `BisectorGraph::merging`.
  std::span<const int> points(int outline) const {
    return std::span(points_).subspan(outlines_[outline].first, outlines_[outline].count);
  }
  /// The number of points of all outlines together.
  size_t pointCount() const { return points_.size(); }
  const std::vector<OutlineSteps::BoundaryStep>& boundarySteps() const {
    return steps_.boundarySteps();
  }

 private:
  struct Outline {
    int label;
    int ring;          ///< of its first step
    int first, count;  ///< in points_
  };

  /// A point of an outline, and the face that the step from there runs along.
  struct WayPoint {
    int point, face;
  };

  long traceRing(int dart);
  template <class Visit>
  void walkRing(int start, Visit visit);
  void orderBoundary();
  int firstFrom(int halfedge) const;
  bool isOn(int boundaryPoint, int halfedge) const;
  void addMerged(int halfedge, double after, double upTo);
  int followBoundary(int start, int label);
  long traceBoundary(int start);
  template <class Walk>
  long addRing(int label, Walk walk);
  void collectOutline(int s);
  void sort();
  bool isTraced(int label) const { return !labels_ || labels_->contains(label); }
  int vertexPoint(int vertex);

  const TriangleMesh& mesh_;
  const FaceComplex& complex_;
  const DistanceField& distances_;
  IndexMap& pointOfNode_;
  const IndexSet* const labels_;
  BisectorGraph& graph_;

  SlicedSequence sequence_;
  std::vector<char> isVisited_;  ///< per dart
  int ringCount_ = 0;
  OutlineSteps steps_;  ///< of rings with merged points
  std::vector<Outline> outlines_;
  std::vector<int> points_;
  std::vector<WayPoint> way_;                 ///< along the mesh boundary, in the current ring
  std::vector<NodeLabels::InnerNode> inner_;  ///< working memory
};

}  // namespace gvd
