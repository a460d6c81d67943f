// SPDX-License-Identifier: MIT
#include "distance/owner_finding.h"

#include <algorithm>
#include <set>
#include <utility>

namespace gvd {

void OwnerFinding::beginChange() {
  affectedFaces_.clear();
  changedVertices_.clear();
  newlyFinal_.clear();
  ties_.clear();
  requirements_.clear();
}

void OwnerFinding::noteLeaving(int label) {
  for (const ReachedVertex& r : spread_.reached(label))
    if (r.isFinal)
      mesh_.visitFaces(r.vertex, [&](int f) {
        if (owners_.has(f, label)) affectedFaces_.add(f);
      });
  addFacesOfSite(label);
}

void OwnerFinding::addFacesOfSite(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) { affectedFaces_.add(site.face); });
}

void OwnerFinding::start(const LabelChange& change) {
  change_ = &change;
  sequence_ = {};
}

bool OwnerFinding::step(long& budget) {
  return sequence_.run(
      [&] { return markFinal(budget); }, [&] { findAffected(); }, [&] { return findTies(budget); },
      [&] {
        return loop_.run(affectedFaces_.size(), budget, kQuickRounds,
                         [&](int i) { owners_.reset(affectedFaces_.list()[i], requirements_); });
      },
      [&] { addTies(); });
}

/// Marks the distances that are final because the label owns the vertex or ties with its owner.
bool OwnerFinding::markFinal(long& budget) {
  const std::vector<int>&started = change_->started, &resumed = change_->resumed;
  return loop_.runWeighted(started.size() + resumed.size(), budget, kQuickRounds, [&](size_t i) {
    const int label = i < started.size() ? started[i] : resumed[i - started.size()];
    const std::vector<ReachedVertex>& reached = spread_.reached(label);
    for (size_t k = 0; k < reached.size(); ++k) {
      const ReachedVertex& r = reached[k];
      if (!bounds_.ties().isAtMost(r.distance, bounds_[r.vertex].distance)) continue;
      noteTie(r.vertex, label);
      if (r.isFinal) continue;
      spread_.markFinal(label, static_cast<int>(k));
      if (!change_->startsAll) newlyFinal_.push_back(r.vertex);
    }
    return 1 + static_cast<long>(reached.size());
  });
}

/// Notes that a label ties with the owner of a vertex. The lower one of the two owns it.
void OwnerFinding::noteTie(int vertex, int label) {
  int& owner = bounds_[vertex].label;
  if (owner == label) return;
  ties_.push_back({vertex, std::max(owner, label)});
  owner = std::min(owner, label);
}

/// Finds the faces whose owners may have changed: those around vertices whose owner is gone, or
/// where a label has become owner or ties with it.
void OwnerFinding::findAffected() {
  if (change_->startsAll) {
    affectedFaces_.addAll();
    changedVertices_.addAll();
    return;
  }
  const auto addFacesAround = [&](std::span<const int> vertices) {
    for (const int v : vertices) mesh_.visitFaces(v, [&](int f) { affectedFaces_.add(f); });
  };
  addFacesAround(change_->resetVertices);
  addFacesAround(newlyFinal_);
  for (const int label : change_->started) addFacesOfSite(label);
  for (const int f : affectedFaces_.list())
    for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
  dropInterpolated();
}

/// Drops the owners found by interpolation in all faces around changed vertices: they depend on the
/// distances at the corners of their faces. A label that was dropped from a face may not be known
/// at the corners of that face any more, so these corners count as changed, too, and so on. The
/// same goes for labels listed there with the distance of the dropped one (`equalizeTies`).
void OwnerFinding::dropInterpolated() {
  std::vector<LabelAtVertex> doubtful;
  std::set<std::pair<int, int>> isDoubtful;
  const auto doubt = [&](int vertex, int label) {
    if (isDoubtful.emplace(vertex, label).second) doubtful.push_back({vertex, label});
  };
  for (const int v : changedVertices_.list())
    mesh_.visitFaces(v, [&](int f) {
      if (affectedFaces_.contains(f)) return;
      for (const FaceOwners::Owner& owner : owners_.several(f))
        if (owner.isInterpolated) doubt(v, owner.label);
    });
  for (size_t i = 0; i < doubtful.size(); ++i) {
    const auto [vertex, label] = doubtful[i];
    changedVertices_.add(vertex);
    const double distance = lists_.distance(vertex, label);
    for (const LabelledDistance& d : lists_[vertex])
      if (d.distance == distance) doubt(vertex, d.label);
    mesh_.visitFaces(vertex, [&, label = label](int f) {
      if (affectedFaces_.contains(f) || !owners_.removeInterpolated(f, label)) return;
      for (int h = 3 * f; h < 3 * f + 3; ++h) doubt(mesh_.tail(h), label);
    });
  }
}

/// Finds the labels that tie at a changed vertex among those that were known there before.
bool OwnerFinding::findTies(long& budget) {
  return loop_.run(changedVertices_.size(), budget, kQuickRounds, [&](int i) {
    const int v = changedVertices_.list()[i];
    for (size_t k = 0; k < lists_[v].size(); ++k) {
      const int label = lists_[v][k].label;
      if (!sites_.contains(label) || change_->hasStarted[label]) continue;
      // The distance that the label has found: the listed one may have been lowered to that of a
      // label that is gone (`equalizeTies`).
      const ReachedVertex& r = spread_.reached(label)[lists_.reachedIndices(v)[k]];
      if (bounds_.ties().isAtMost(r.distance, bounds_[v].distance)) noteTie(v, label);
    }
  });
}

/// Makes labels that tie with the owner of a vertex owners of the affected faces around it.
void OwnerFinding::addTies() {
  for (const auto& [vertex, label] : ties_)
    mesh_.visitFaces(vertex, [&, tie = label](int f) {
      if (affectedFaces_.contains(f)) owners_.add(f, tie, false, requirements_);
    });
}

}  // namespace gvd
