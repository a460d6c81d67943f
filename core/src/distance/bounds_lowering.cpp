// SPDX-License-Identifier: MIT
#include "distance/bounds_lowering.h"

#include "base/index_set.h"

namespace gvd {

void BoundsLowering::beginChange() {
  turns_.clear();
  missed_.clear();
  hasSpread_ = false;
  sequence_ = {};
}

bool BoundsLowering::step(long& budget) {
  return sequence_.run(
      forEach(change_.resetVertices, budget, kQuickRounds,
              [&](int i) {
                const int v = change_.resetVertices[i];
                bounds_[v].distance = edgeBounds_[v];
              }),
      forEach(edgeBounds_.changed(), budget, kQuickRounds,
              [&](int i) { resetBound(edgeBounds_.changed()[i]); }),
      [&] { startTurns(); }, [&] { return spread(budget); });
}

/// Hands an edge bound that has changed to the spread. Where a path along edges is now shorter than
/// the owner's distance, the owner is dropped: which labels reach the new bound must not depend on
/// earlier changes.
void BoundsLowering::resetBound(int v) {
  spread_.setEdgeBound(v, edgeBounds_[v]);
  if (bounds_.ties().isAtMost(bounds_[v].distance, edgeBounds_[v])) return;
  bounds_[v] = {-1, edgeBounds_[v]};
  change_.resetVertices.push_back(v);
}

void BoundsLowering::startTurns() {
  bounded_ = change_.resetVertices;
  edgeBounds_.clearChanged();
  for (const int label : change_.started) turns_.addStart(label);
  for (const int label : change_.resumed) {
    lowerBy(label);
    turns_.addResume(label);
  }
}

bool BoundsLowering::spread(long& budget) {
  do {
    if (!turns_.step(budget)) return false;
    hasSpread_ = true;
  } while (requireMissed());
  return true;
}

/// Lowers the bounds to the distances of a label.
void BoundsLowering::lowerBy(int label) {
  for (const ReachedVertex& r : spread_.reached(label)) bounds_.lower(r.vertex, label, r.distance);
}

/// Finds vertices where no label has reached the edge bound. In needles, and in faces much longer
/// than the distance, rounding may make straight paths longer than the path along edges, or lose
/// them. Requires the label that is nearest by way of a neighbour to go on to each such vertex: by
/// windows that wait at its faces, or along the edge. False if there are none.
bool BoundsLowering::requireMissed() {
  for (const Requirement& r : missed_) lowerBy(r.label);
  missed_.clear();
  turns_.clear();
  std::erase_if(bounded_, [&](int v) { return bounds_[v].label >= 0; });
  for (const int v : bounded_) {
    bounds_[v] = {};
    const Requirement nearest = nearestAround(v);
    if (nearest.label < 0) continue;
    missed_.push_back(nearest);
    if (!change_.hasStarted[nearest.label]) change_.resumed.push_back(nearest.label);
  }
  makeSet(change_.resumed);
  turns_.addRequired(missed_);
  return !turns_.isEmpty();
}

/// The label by which a path over a neighbour and the edge to it is shortest, and a face beside
/// that edge; -1 if the neighbours have no labels.
Requirement BoundsLowering::nearestAround(int vertex) const {
  Requirement nearest = {-1, -1};
  double least = kInfinity;
  const auto offer = [&](int neighbour, int side) {
    const LabelledDistance& there = bounds_[neighbour];
    if (there.label < 0 || !(there.distance + mesh_.length(side) < least)) return;
    least = there.distance + mesh_.length(side);
    nearest = {there.label, TriangleMesh::faceOf(side)};
  };
  for (const int h : mesh_.fan(vertex)) {
    offer(mesh_.tip(h), h);
    offer(mesh_.tail(TriangleMesh::previous(h)), TriangleMesh::previous(h));
  }
  return nearest;
}

}  // namespace gvd
