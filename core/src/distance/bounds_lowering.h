// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "distance/edge_bounds.h"
#include "distance/label_change.h"
#include "distance/label_spread.h"
#include "distance/label_turns.h"
#include "distance/nearest_bounds.h"
#include "distance/reached_loop.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Lets labels spread, one after another, until the bound at every vertex that sites reach is the
/// distance of a label. Bounds begin with the lengths of paths along edges.
class BoundsLowering {
 public:
  /// All arguments must outlive this. `step` adds to the current change the vertices where the
  /// owner exceeds the edge bound, and the labels that resume to reach vertices that no other label
  /// has reached.
  BoundsLowering(const TriangleMesh& mesh, LabelSpread& spread, EdgeBounds& edgeBounds,
                 NearestBounds& bounds, LabelChange& change)
      : mesh_(mesh),
        edgeBounds_(edgeBounds),
        bounds_(bounds),
        spread_(spread),
        change_(change),
        turns_(spread) {}

  /// Forgets the previous change.
  void beginChange();
  /// Works on at most `budget` units and lowers it by their number; true when the bounds are
  /// distances. Call it once the edge bounds are up to date.
  bool step(long& budget);
  double progress() const { return hasSpread_ ? 1 : turns_.progress(); }

 private:
  void resetBound(int vertex);
  bool lowerBy(std::span<const int> labels, long& budget);
  void startTurns();
  bool spread(long& budget);
  long findMissed(int vertex);
  void requireMissed();
  Requirement nearestAround(int vertex) const;

  const TriangleMesh& mesh_;
  EdgeBounds& edgeBounds_;
  NearestBounds& bounds_;
  LabelSpread& spread_;

  // The current change.
  LabelChange& change_;
  SlicedSequence sequence_, round_;
  ReachedLoop reachedLoop_;
  LabelTurns turns_;
  std::vector<int> changedVertices_;  ///< the vertices whose edge bounds have changed, ascending
  bool hasSpread_ = false;            ///< whether all labels have; only missed vertices are left
  std::vector<Requirement> missed_;   ///< of labels that go on to missed vertices
  std::vector<int> goingOn_;          ///< these labels
};

}  // namespace gvd
