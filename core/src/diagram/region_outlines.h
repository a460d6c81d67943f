// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/bisector_graph.h"
#include "diagram/bisector_tracing.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Identifies a straight line: the roots of its two ends, ascending, and its face. The face is -1
/// if both ends are merged, because lines in two faces between the same merged points run along
/// their edge. Lines with equal keys lie on top of each other.
using PlaceOfLine = std::array<int, 3>;
PlaceOfLine placeOfLine(const BisectorGraph& graph, int from, int to, int face);

/// The closed outlines of regions: rings of darts and steps along the mesh boundary, without the
/// pieces that merging points has reduced to nothing.
///
/// A ring without merged points is an outline already. Other rings are turned into *steps* first.
/// Steps of no length are removed, and so are pairs of opposite steps of a region, between which it
/// has no width. This may join two rings, or split one.
class RegionOutlines {
 public:
  /// Traces the labels with `isTraced[label]`, or all if `isTraced` is empty. Adds points to the
  /// graph where outlines pass vertices on the mesh boundary.
  RegionOutlines(const TriangleMesh& mesh, const DistanceField& distances, NodePoints& nodePoints,
                 std::span<const char> isTraced, BisectorGraph& graph);
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

  /// A step of a region along the mesh boundary with a merged end.
  struct BoundaryStep {
    int label, from, to, face;
  };
  const std::vector<BoundaryStep>& boundarySteps() const { return boundarySteps_; }

 private:
  struct Outline {
    int label;
    int ring;          ///< of its first step
    int first, count;  ///< in points_
  };
  /// A step of a ring: a dart across `face`, or along a side of the face on the mesh boundary.
  struct Step {
    int label, ring, from, face;
    int previous, next;
    bool isOnBoundary, isGone;
  };

  void orderBoundary();
  static void chain(std::span<BisectorGraph::BoundaryPoint> points);
  bool traceRings(long& budget);
  void traceRing(int start, long& budget);
  template <class Visit>
  void walkRing(int start, Visit visit);
  template <class Visit>
  int followBoundary(int point, int label, Visit visit);
  bool traceUnbrokenBoundaries(long& budget);
  void traceUnbroken(int start, int owner, long& budget);
  template <class Walk>
  void addRing(int label, Walk walk, long& budget);
  void addStep(int label, int point, int face, bool isOnBoundary);
  void closeRing(int first);
  void cancelStep(int s);
  bool forgetWaiting(long& budget);
  void cancel(int s, int opposite);
  void collectOutline(int s);
  void sort();
  bool isTraced(int label) const { return isTraced_.empty() || isTraced_[label]; }
  int boundaryIndexOf(int point) const;
  int firstOnBoundary(int halfedge) const;
  int vertexPoint(int vertex);
  int tip(const Step& step) const { return steps_[step.next].from; }

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  NodePoints& nodePoints_;
  const std::span<const char> isTraced_;
  BisectorGraph& graph_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::vector<char> isVisited_;  ///< per dart
  int nextDart_ = 0, nextBoundary_ = 0;
  int ringCount_ = 0;
  std::vector<std::array<int, 2>> boundaryIndex_;  ///< points on the boundary, each with its index
  std::vector<Step> steps_;
  std::map<std::array<int, 4>, std::vector<int>> waiting_;  ///< uncancelled steps, by place
  std::vector<BoundaryStep> boundarySteps_;
  std::vector<Outline> outlines_;
  std::vector<int> points_;
};

}  // namespace gvd
