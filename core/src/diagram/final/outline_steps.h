// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/graph/bisector_graph.h"

namespace gvd {

/// Identifies a straight line: the roots of its two ends, ascending, and its face. The face is -1
/// if both ends are merged, because lines in two faces between the same merged points run along
/// their edge. Lines with equal keys lie on top of each other.
using PlaceOfLine = std::array<int, 3>;
PlaceOfLine placeOfLine(const BisectorGraph& graph, int from, int to, int face);

/// The rings with merged points of a diagram's outlines, as *steps* from point to point. Steps of
/// no length are removed, and so are pairs of opposite steps of a region, between which it has no
/// width. This may join two rings, or split one.
class OutlineSteps {
 public:
  explicit OutlineSteps(BisectorGraph& graph) : graph_(graph) {}

  /// Adds the ring of a region. `walk` takes a function of a step's first point, its face, and
  /// whether the step runs along the mesh boundary, and calls it with each step.
  template <class Walk>
  void addRing(int label, int ring, Walk walk) {
    const int first = size();
    walk([&](int point, int face, bool isOnBoundary) {
      steps_.push_back({label, ring, graph_.merging.root(point), face, size() - 1, size() + 1,
                        isOnBoundary, false});
    });
    closeRing(first);
  }
  /// Removes what merging has reduced to nothing; true when done.
  bool cancel(long& budget);

  int size() const { return static_cast<int>(steps_.size()); }
  int label(int s) const { return steps_[s].label; }
  int ring(int s) const { return steps_[s].ring; }
  /// Adds the points of the ring that a step is in now, unless the step is gone, and removes its
  /// steps.
  void takeRing(int s, std::vector<int>& points);

  /// A step of a region along the mesh boundary with a merged end.
  struct BoundaryStep {
    int label, from, to, face;
  };
  const std::vector<BoundaryStep>& boundarySteps() const { return boundarySteps_; }

 private:
  /// A step of a ring: a dart across `face`, or along a side of the face on the mesh boundary.
  struct Step {
    int label, ring, from, face;
    int previous, next;
    bool isOnBoundary, isGone;
  };

  void closeRing(int first);
  void cancelStep(int s);
  void cancelPair(int s, int opposite);
  bool forgetWaiting(long& budget);
  bool isMerged(int point) const { return graph_.merging.isMerged(point); }
  int tip(const Step& step) const { return steps_[step.next].from; }

  BisectorGraph& graph_;
  SlicedSequence sequence_;
  std::vector<Step> steps_;
  std::map<std::array<int, 4>, std::vector<int>> waiting_;  ///< uncancelled steps, by place
  std::vector<BoundaryStep> boundarySteps_;
};

}  // namespace gvd
