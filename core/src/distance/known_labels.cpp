// SPDX-License-Identifier: MIT
#include "distance/known_labels.h"

#include <cstddef>
#include <numeric>

namespace gvd {
namespace {

/// Vertices that, with the faces around them, take about as long to look at as one unit of the
/// budget.
constexpr long kVerticesPerUnit = 8;

}  // namespace

KnownLabels::KnownLabels(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                         LabelSpread& spread, const LabelChange& change)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      spread_(spread),
      change_(change),
      owners_(mesh, sites, bounds),
      lists_(spread, bounds),
      finding_(mesh, sites, bounds, spread, change, lists_, owners_),
      turns_(spread),
      closure_(mesh, spread, owners_, lists_, changedFaces_),
      changedFaces_(mesh.faceCount()) {}

void KnownLabels::beginChange() {
  finding_.beginChange();
  closure_.beginChange();
  changedFaces_.clear();
  changedLabels_.clear();
  progress_ = 0;
  sequence_ = allotting_ = {};
}

void KnownLabels::noteLeaving(int label) {
  changedLabels_.push_back(label);
  finding_.addFacesOfSite(label);
}

bool KnownLabels::step(long& budget) {
  const std::vector<int>& changed = finding_.changedVertices().list();
  return sequence_.run(
      // 1. Owners.
      [&] { return finding_.step(budget); },
      // 2. Required distances.
      [&] { turns_.setRequired(finding_.requirements()); },
      [&] {
        constexpr double kShare = 0.9;
        const bool isDone = turns_.step(budget);
        progress_ = kShare * turns_.progress();
        return isDone;
      },
      // 3. Lists.
      [&] { atChanged_ = IndexSet(sites_.labelCount()); },
      [&](SlicedLoop& loop) {
        return change_.startsAll ? allotLists(budget) : clearLists(loop, budget);
      },
      [&] { listed_ = change_.startsAll ? change_.started : atChanged_.sorted(); },
      [&] { return listLabels(budget); },
      forItems(changed, budget, kQuickRounds, [&](int v) { lists_.equalizeTies(v); }),
      // 4. Closure.
      [&] { return closure_.step(budget); },
      [&](SlicedLoop& loop) { return change_.startsAll || noteExtended(loop, budget); },
      [&] {
        changedLabels_.insert(changedLabels_.end(), atChanged_.list().begin(),
                              atChanged_.list().end());
        makeSet(changedLabels_);
        progress_ = 1;
      });
}

/// Makes room in the lists for just the labels that come: where all labels start, these are all
/// that have found a final distance.
bool KnownLabels::allotLists(long& budget) {
  const int vertices = mesh_.vertexCount();
  return allotting_.run(
      [&] {
        for (const int label : change_.started) atChanged_.add(label);
      },
      [&] { return changedFaces_.addAll(budget); },
      [&] { return fillInSlices(roomAt_, vertices, 0, budget); },
      [&] {
        return reachedLoop_.run(spread_, change_.started, budget,
                                [&](int /*label*/, int /*i*/, const ReachedVertex& r) {
                                  roomAt_[r.vertex] += r.isFinal;
                                });
      },
      [&] { lists_.beginAllotting(std::accumulate(roomAt_.begin(), roomAt_.end(), int64_t{0})); },
      forEach(vertices, budget, kQuickRounds, [&](int v) { lists_.allot(v, roomAt_[v]); }),
      [&] { release(roomAt_); });
}

/// Clears the lists of changed vertices and collects the labels known there before, and those that
/// may go into the lists.
bool KnownLabels::clearLists(SlicedLoop& loop, long& budget) {
  const std::vector<int>& changed = finding_.changedVertices().list();
  return loop.run(changed.size(), budget, kVerticesPerUnit, [&](int i) { clearList(changed[i]); });
}

void KnownLabels::clearList(int vertex) {
  for (const LabelledDistance& d : lists_[vertex]) atChanged_.add(d.label);
  lists_.clear(vertex);
  if (bounds_[vertex].label >= 0) atChanged_.add(bounds_[vertex].label);
  mesh_.visitFaces(vertex, [&](int f) {
    changedFaces_.add(f);
    for (const FaceOwners::Owner& owner : owners_.several(f)) atChanged_.add(owner.label);
  });
}

bool KnownLabels::listLabels(long& budget) {
  // If all labels have just spread, every final distance goes into a list.
  const bool isAllWanted = change_.startsAll;
  const IndexSet& changed = finding_.changedVertices();
  return reachedLoop_.run(spread_, listed_, budget, [&](int label, int i, const ReachedVertex& r) {
    if (r.isFinal &&
        (isAllWanted || (changed.contains(r.vertex) && ownsPartAround(label, r.vertex))))
      lists_.add(label, i);
  });
}

/// Notes what the closure has changed.
bool KnownLabels::noteExtended(SlicedLoop& loop, long& budget) {
  const std::vector<int>& extended = closure_.extended();
  return loop.run(extended.size(), budget, kVerticesPerUnit, [&](int i) {
    mesh_.visitFaces(extended[i], [&](int f) { changedFaces_.add(f); });
    for (const LabelledDistance& d : lists_[extended[i]]) atChanged_.add(d.label);
  });
}

/// Whether a label owns part of a face around a vertex.
bool KnownLabels::ownsPartAround(int label, int vertex) const {
  if (bounds_[vertex].label == label) return true;
  bool isOwner = false;
  mesh_.visitFaces(vertex, [&](int f) { isOwner = isOwner || owners_.has(f, label); });
  return isOwner;
}

}  // namespace gvd
