// SPDX-License-Identifier: MIT
#include "distance/bounds_lowering.h"

#include <algorithm>
#include <iterator>

#include "base/index_set.h"

namespace gvd {

void BoundsLowering::beginChange() {
  turns_.clear();
  goingOn_.clear();
  hasSpread_ = false;
  sequence_ = round_ = {};
}

bool BoundsLowering::step(long& budget) {
  return sequence_.run(
      forItems(change_.resetVertices, budget, kQuickRounds,
               [&](int v) { bounds_[v].distance = edgeBounds_[v]; }),
      // In the order in which vertices lie in memory, because the first change is of all of them.
      [&] { changedVertices_ = edgeBounds_.changed().sorted(); },
      forItems(changedVertices_, budget, kQuickRounds, [&](int v) { resetBound(v); }),
      [&] { return lowerBy(change_.resumed, budget); }, [&] { startTurns(); },
      [&] { return spread(budget); });
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

/// Lowers the bounds to the distances of some labels, in slices; true when done.
bool BoundsLowering::lowerBy(std::span<const int> labels, long& budget) {
  return reachedLoop_.run(spread_, labels, budget,
                          [&](int label, int /*i*/, const ReachedVertex& r) {
                            bounds_.lower(r.vertex, label, r.distance);
                          });
}

void BoundsLowering::startTurns() {
  edgeBounds_.clearChanged();
  for (const int label : change_.started) turns_.addStart(label);
  for (const int label : change_.resumed) turns_.addResume(label);
}

/// Lets labels spread, and then those go on that can reach missed vertices, until there are none.
bool BoundsLowering::spread(long& budget) {
  const std::vector<int>& bounded = change_.resetVertices;  // by paths along edges alone, at first
  do {
    if (!round_.runRound(
            [&] { return turns_.step(budget); }, [&] { hasSpread_ = true; },
            [&] { return lowerBy(goingOn_, budget); },
            forItems(bounded, budget, kQuickRounds, [&](int v) { return findMissed(v); }),
            [&] { requireMissed(); }))
      return false;
  } while (!turns_.isEmpty());
  return true;
}

/// Finds out whether no label has reached the edge bound of a vertex. In needles, and in faces much
/// longer than the distance, rounding may make straight paths longer than the path along edges, or
/// lose them. Then the label that is nearest by way of a neighbour has to go on to the vertex: by
/// windows that wait at its faces, or along the edge. Returns how many quick rounds it took.
long BoundsLowering::findMissed(int v) {
  if (bounds_[v].label >= 0) return 1;
  bounds_[v] = {};
  if (const Requirement nearest = nearestAround(v); nearest.label >= 0) missed_.push_back(nearest);
  return 1 + static_cast<long>(mesh_.fan(v).size());
}

/// Requires what is missed. No turns are left if that is nothing.
void BoundsLowering::requireMissed() {
  turns_.setRequired(missed_);
  goingOn_.clear();
  for (const Requirement& r : missed_) goingOn_.push_back(r.label);
  makeSet(goingOn_);
  missed_.clear();
  std::copy_if(goingOn_.begin(), goingOn_.end(), std::back_inserter(change_.resumed),
               [&](int label) { return !change_.hasStarted[label]; });
  makeSet(change_.resumed);
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
