// SPDX-License-Identifier: MIT
#include "distance/known_labels.h"

#include <algorithm>
#include <set>
#include <utility>

namespace gvd {

KnownLabels::KnownLabels(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                         LabelSpread& spread)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      spread_(spread),
      owners_(mesh, sites, bounds),
      lists_(mesh, spread, bounds),
      turns_(spread),
      closure_(mesh, spread, owners_, lists_),
      affectedFaces_(mesh.faceCount()),
      changedVertices_(mesh.vertexCount()),
      changedFaces_(mesh.faceCount()) {}

// --- A change ----------------------------------------------------------------------------------

void KnownLabels::beginChange() {
  affectedFaces_.clear();
  changedVertices_.clear();
  changedFaces_.clear();
  changedLabels_.clear();
  newlyFinal_.clear();
  ties_.clear();
  requirements_.clear();
  progress_ = 0;
}

void KnownLabels::noteLeaving(int label) {
  changedLabels_.push_back(label);
  for (const ReachedVertex& r : spread_.reached(label))
    if (r.isFinal)
      mesh_.visitFaces(r.vertex, [&](int f) {
        if (owners_.has(f, label)) affectedFaces_.add(f);
      });
  addFacesOfSite(label);
}

void KnownLabels::addFacesOfSite(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) { affectedFaces_.add(site.face); });
}

void KnownLabels::start(const LabelChange& change) {
  change_ = &change;
  sequence_ = {};
}

bool KnownLabels::step(long& budget) {
  return sequence_.run(
      // 1. Owners.
      [&] { return markFinal(budget); }, [&] { findAffected(); }, [&] { return findTies(budget); },
      [&] {
        return loop_.run(affectedFaces_.size(), budget, kQuickRounds,
                         [&](int i) { owners_.reset(affectedFaces_.list()[i], requirements_); });
      },
      [&] { addTies(); },
      // 2. Required distances.
      [&] {
        turns_.clear();
        turns_.addRequired(requirements_);
      },
      [&] {
        constexpr double kShare = 0.9;
        const bool isDone = turns_.step(budget);
        progress_ = kShare * turns_.progress();
        return isDone;
      },
      // 3. Lists.
      [&] { collectLists(); }, [&] { return listLabels(budget); },
      [&] {
        return loop_.run(changedVertices_.size(), budget, kQuickRounds,
                         [&](int i) { lists_.equalizeTies(changedVertices_.list()[i]); });
      },
      // 4. Closure.
      [&] { closure_.start(changedFaces_); }, [&] { return closure_.step(budget); },
      [&] {
        noteExtended();
        progress_ = 1;
      });
}

/// Marks the distances that are final because the label owns the vertex or ties with its owner.
bool KnownLabels::markFinal(long& budget) {
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
      if (!areAllNew()) newlyFinal_.push_back(r.vertex);
    }
    return 1 + static_cast<long>(reached.size());
  });
}

/// Notes that a label ties with the owner of a vertex. The lower one of the two owns it.
void KnownLabels::noteTie(int vertex, int label) {
  int& owner = bounds_[vertex].label;
  if (owner == label) return;
  ties_.push_back({vertex, std::max(owner, label)});
  owner = std::min(owner, label);
}

// --- Owners ------------------------------------------------------------------------------------

/// Finds the faces whose owners may have changed: those around vertices whose owner is gone, or
/// where a label has become owner or ties with it.
void KnownLabels::findAffected() {
  if (areAllNew()) {
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
void KnownLabels::dropInterpolated() {
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
bool KnownLabels::findTies(long& budget) {
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
void KnownLabels::addTies() {
  for (const auto& [vertex, label] : ties_)
    mesh_.visitFaces(vertex, [&, tie = label](int f) {
      if (affectedFaces_.contains(f)) owners_.add(f, tie, false, requirements_);
    });
}

// --- Lists -------------------------------------------------------------------------------------

/// Clears the lists of changed vertices and collects the labels that may go into them.
void KnownLabels::collectLists() {
  if (areAllNew()) {
    listed_ = change_->started;
    std::sort(listed_.begin(), listed_.end());
    changedFaces_.addAll();
    std::vector<int> counts(mesh_.vertexCount(), 0);
    for (const int label : listed_)
      for (const ReachedVertex& r : spread_.reached(label)) counts[r.vertex] += r.isFinal;
    lists_.allot(counts);
  } else {
    listed_.clear();
    for (const int v : changedVertices_.list()) {
      for (const LabelledDistance& d : lists_[v]) changedLabels_.push_back(d.label);
      lists_.clear(v);
      if (bounds_[v].label >= 0) listed_.push_back(bounds_[v].label);
      mesh_.visitFaces(v, [&](int f) {
        changedFaces_.add(f);
        for (const FaceOwners::Owner& owner : owners_.several(f)) listed_.push_back(owner.label);
      });
    }
    makeSet(listed_);
  }
  changedLabels_.insert(changedLabels_.end(), listed_.begin(), listed_.end());
  makeSet(changedLabels_);
}

bool KnownLabels::listLabels(long& budget) {
  // If all labels have just spread, every final distance goes into a list.
  const bool isAllWanted = areAllNew();
  return loop_.runWeighted(listed_.size(), budget, kQuickRounds, [&](size_t i) {
    const int label = listed_[i];
    const auto& reached = spread_.reached(label);
    for (int r = 0; r < static_cast<int>(reached.size()); ++r) {
      const auto& [vertex, isFinal, distance] = reached[r];
      if (isFinal &&
          (isAllWanted || (changedVertices_.contains(vertex) && ownsPartAround(label, vertex))))
        lists_.add(label, r);
    }
    return 1 + static_cast<long>(reached.size());
  });
}

/// Notes what the closure has changed.
void KnownLabels::noteExtended() {
  if (areAllNew()) return;
  for (const int v : closure_.extended()) {
    mesh_.visitFaces(v, [&](int f) { changedFaces_.add(f); });
    for (const LabelledDistance& d : lists_[v]) changedLabels_.push_back(d.label);
  }
  makeSet(changedLabels_);
}

/// Whether a label owns part of a face around a vertex.
bool KnownLabels::ownsPartAround(int label, int vertex) const {
  if (bounds_[vertex].label == label) return true;
  bool isOwner = false;
  mesh_.visitFaces(vertex, [&](int f) { isOwner = isOwner || owners_.has(f, label); });
  return isOwner;
}

}  // namespace gvd
