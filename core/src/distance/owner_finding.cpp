// SPDX-License-Identifier: MIT
#include "distance/owner_finding.h"

#include <algorithm>

namespace gvd {

void OwnerFinding::beginChange() {
  affectedFaces_.clear();
  changedVertices_.clear();
  newlyFinal_.clear();
  ties_.clear();
  requirements_.clear();
  doubtful_.clear();
  isDoubtful_.clear();
  droppedCount_ = 0;
  sequence_ = affecting_ = {};
}

void OwnerFinding::noteLeavingFrom(int vertex, int label) {
  mesh_.visitFaces(vertex, [&](int f) {
    if (owners_.has(f, label)) affectedFaces_.add(f);
  });
}

void OwnerFinding::addFacesOfSite(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) { affectedFaces_.add(site.face); });
}

bool OwnerFinding::step(long& budget) {
  constexpr long kLabelsPerUnit = 16;  // of `findTies`
  return sequence_.run(
      [&] { return markFinal(change_.started, budget); },
      [&] { return markFinal(change_.resumed, budget); },
      [&] { return change_.startsAll ? affectAll(budget) : findAffected(budget); },
      [&](SlicedLoop& loop) {
        return change_.startsAll ||
               loop.run(changedVertices_.size(), budget, kLabelsPerUnit,
                        [&](int i) { return findTies(changedVertices_.list()[i]); });
      },
      forItems(affectedFaces_.list(), budget, kQuickRounds,
               [&](int f) { owners_.reset(f, requirements_); }),
      forItems(ties_, budget, kQuickRounds, [&](const LabelAtVertex& tie) { addTie(tie); }));
}

/// Marks the distances that are final because the label owns the vertex or ties with its owner.
bool OwnerFinding::markFinal(std::span<const int> labels, long& budget) {
  return reachedLoop_.run(spread_, labels, budget, [&](int label, int i, const ReachedVertex& r) {
    if (!bounds_.ties().isAtMost(r.distance, bounds_[r.vertex].distance)) return;
    noteTie(r.vertex, label);
    if (r.isFinal) return;
    spread_.markFinal(label, i);
    if (!change_.startsAll) newlyFinal_.push_back(r.vertex);
  });
}

/// Notes that a label ties with the owner of a vertex. The lower one of the two owns it.
void OwnerFinding::noteTie(int vertex, int label) {
  int& owner = bounds_[vertex].label;
  if (owner == label) return;
  ties_.push_back({vertex, std::max(owner, label)});
  owner = std::min(owner, label);
}

/// Where all labels start, the owners of all faces may have changed.
bool OwnerFinding::affectAll(long& budget) {
  return affecting_.run([&] { affectedFaces_.clear(); },
                        [&] { return affectedFaces_.addAll(budget); },
                        [&] { return changedVertices_.addAll(budget); });
}

/// Finds the faces whose owners may have changed: those around vertices whose owner is gone, or
/// where a label has become owner or ties with it.
///
/// Drops the owners found by interpolation in all faces around changed vertices: they depend on the
/// distances at the corners of their faces. A label that was dropped from a face may not be known
/// at the corners of that face any more, so these corners count as changed, too, and so on.
bool OwnerFinding::findAffected(long& budget) {
  const auto forAll = [&](const std::vector<int>& list, auto body) {
    return forItems(list, budget, 8, body);
  };
  const auto addFacesAround = [&](int v) {
    mesh_.visitFaces(v, [&](int f) { affectedFaces_.add(f); });
  };
  return affecting_.run(
      forAll(change_.resetVertices, addFacesAround), forAll(newlyFinal_, addFacesAround),
      [&] {
        for (const int label : change_.started) addFacesOfSite(label);
      },
      forAll(affectedFaces_.list(),
             [&](int f) {
               for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
             }),
      forAll(changedVertices_.list(), [&](int v) { doubtInterpolated(v); }),
      [&] { return dropDoubtful(budget); });
}

/// Notes that a label may not be known at a vertex any more.
void OwnerFinding::doubt(int vertex, int label) {
  if (isDoubtful_.emplace(vertex, label).second) doubtful_.push_back({vertex, label});
}

/// Doubts the owners found by interpolation in the faces around a vertex.
void OwnerFinding::doubtInterpolated(int vertex) {
  mesh_.visitFaces(vertex, [&](int f) {
    if (affectedFaces_.contains(f)) return;
    for (const FaceOwners::Owner& owner : owners_.several(f))
      if (owner.isInterpolated) doubt(vertex, owner.label);
  });
}

/// Drops doubtful labels from the faces around their vertices, and doubts them at the other
/// corners.
bool OwnerFinding::dropDoubtful(long& budget) {
  for (; droppedCount_ < doubtful_.size(); ++droppedCount_) {
    if (budget <= 0) return false;
    const auto [vertex, label] = doubtful_[droppedCount_];
    budget -= 1 + static_cast<long>(mesh_.fan(vertex).size()) / kQuickRounds;
    changedVertices_.add(vertex);
    mesh_.visitFaces(vertex, [&, label = label](int f) {
      if (affectedFaces_.contains(f) || !owners_.removeInterpolated(f, label)) return;
      for (int h = 3 * f; h < 3 * f + 3; ++h) doubt(mesh_.tail(h), label);
    });
  }
  return true;
}

/// Finds the labels that tie at a changed vertex among those that were known there before. Returns
/// the number of labels looked at, and 1 for the vertex.
long OwnerFinding::findTies(int v) {
  for (size_t k = 0; k < lists_[v].size(); ++k) {
    const int label = lists_[v][k].label;
    if (!sites_.contains(label) || change_.hasStarted[label]) continue;
    // The distance that the label has found: the listed one may have been lowered to that of a
    // label that is gone (`equalizeTies`).
    const ReachedVertex& r = spread_.reached(label)[lists_.reachedIndices(v)[k]];
    if (bounds_.ties().isAtMost(r.distance, bounds_[v].distance)) noteTie(v, label);
  }
  return 1 + static_cast<long>(lists_[v].size());
}

/// Makes a label that ties with the owner of a vertex an owner of the affected faces around it.
void OwnerFinding::addTie(const LabelAtVertex& tie) {
  mesh_.visitFaces(tie.vertex, [&](int f) {
    if (affectedFaces_.contains(f)) owners_.add(f, tie.label, false, requirements_);
  });
}

}  // namespace gvd
