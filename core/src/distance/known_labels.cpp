// SPDX-License-Identifier: MIT
#include "distance/known_labels.h"

#include <algorithm>

namespace gvd {

KnownLabels::KnownLabels(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                         LabelSpread& spread)
    : mesh_(mesh),
      bounds_(bounds),
      spread_(spread),
      owners_(mesh, sites, bounds),
      lists_(mesh, spread, bounds),
      finding_(mesh, sites, bounds, spread, lists_, owners_),
      turns_(spread),
      closure_(mesh, spread, owners_, lists_),
      changedFaces_(mesh.faceCount()) {}

void KnownLabels::beginChange() {
  finding_.beginChange();
  changedFaces_.clear();
  changedLabels_.clear();
  progress_ = 0;
}

void KnownLabels::noteLeaving(int label) {
  changedLabels_.push_back(label);
  finding_.noteLeaving(label);
}

void KnownLabels::start(const LabelChange& change) {
  change_ = &change;
  finding_.start(change);
  sequence_ = {};
}

bool KnownLabels::step(long& budget) {
  const std::vector<int>& changed = finding_.changedVertices().list();
  return sequence_.run(
      // 1. Owners.
      [&] { return finding_.step(budget); },
      // 2. Required distances.
      [&] {
        turns_.clear();
        turns_.addRequired(finding_.requirements());
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
        return loop_.run(changed.size(), budget, kQuickRounds,
                         [&](int i) { lists_.equalizeTies(changed[i]); });
      },
      // 4. Closure.
      [&] { closure_.start(changedFaces_); }, [&] { return closure_.step(budget); },
      [&] {
        noteExtended();
        progress_ = 1;
      });
}

/// Clears the lists of changed vertices and collects the labels that may go into them.
void KnownLabels::collectLists() {
  if (change_->startsAll) {
    listed_ = change_->started;
    std::sort(listed_.begin(), listed_.end());
    changedFaces_.addAll();
    std::vector<int> counts(mesh_.vertexCount(), 0);
    for (const int label : listed_)
      for (const ReachedVertex& r : spread_.reached(label)) counts[r.vertex] += r.isFinal;
    lists_.allot(counts);
  } else {
    listed_.clear();
    for (const int v : finding_.changedVertices().list()) {
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
  const bool isAllWanted = change_->startsAll;
  return loop_.runWeighted(listed_.size(), budget, kQuickRounds, [&](size_t i) {
    const int label = listed_[i];
    const auto& reached = spread_.reached(label);
    for (int r = 0; r < static_cast<int>(reached.size()); ++r) {
      const auto& [vertex, isFinal, distance] = reached[r];
      if (isFinal && (isAllWanted || (finding_.changedVertices().contains(vertex) &&
                                      ownsPartAround(label, vertex))))
        lists_.add(label, r);
    }
    return 1 + static_cast<long>(reached.size());
  });
}

/// Notes what the closure has changed.
void KnownLabels::noteExtended() {
  if (change_->startsAll) return;
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
