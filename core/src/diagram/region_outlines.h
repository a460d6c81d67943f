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

/// The roots of two points of the graph, ascending, and the face that a straight line between them
/// is in, -1 if it does not matter: between merged points, what is in two faces is along their
/// edge. Lines of the same place lie on top of each other.
using PlaceOfLine = std::array<int, 3>;
PlaceOfLine placeOfLine(const BisectorGraph& graph, int from, int to, int face);

/// The closed outlines of regions as doubles see them: rings of darts and steps along the mesh
/// boundary, without what merging points has shrunk to nothing.
///
/// A ring without merged points is an outline as it is. The others become *steps* first, of which
/// those of no length go, and those that the region takes in both directions: it has no width
/// there. That may join two rings, or part one in two.
class RegionOutlines {
 public:
  /// Of the labels for which `isTraced`, one per label, says so; of all if it is empty. Adds points
  /// to the graph where outlines pass vertices on the mesh boundary.
  RegionOutlines(const TriangleMesh& mesh, const DistanceField& distances, NodePoints& nodePoints,
                 std::span<const char> isTraced, BisectorGraph& graph);
  /// True when all outlines are there. A step works on whole rings, each as long as it is.
  bool step(long& budget);

  int size() const { return static_cast<int>(outlines_.size()); }
  /// Ascending.
  int label(int outline) const { return outlines_[outline].label; }
  /// Roots.
  std::span<const int> points(int outline) const {
    return std::span(points_).subspan(outlines_[outline].first, outlines_[outline].count);
  }
  /// How many points all outlines have.
  size_t pointCount() const { return points_.size(); }

  /// A step of a region along the mesh boundary, of which an end is merged.
  struct BoundaryStep {
    int label, from, to, face;
  };
  const std::vector<BoundaryStep>& boundarySteps() const { return boundarySteps_; }

 private:
  struct Outline {
    int label;
    int ring;          ///< in which its first step was
    int first, count;  ///< in points_
  };
  /// Of a ring: across a face, or along a side of it that is on the mesh boundary.
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
  std::map<std::array<int, 4>, std::vector<int>> waiting_;  ///< steps by label and place
  std::vector<BoundaryStep> boundarySteps_;
  std::vector<Outline> outlines_;
  std::vector<int> points_;
};

}  // namespace gvd
