// SPDX-License-Identifier: MIT
#include "dgpc/dynamic_sweep.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/tolerances.h"

namespace gvd {
namespace {

constexpr long kAll = std::numeric_limits<long>::max();

}  // namespace

DynamicSweep::DynamicSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites)
    : DgpcSweep(mesh, sites, Spread::kAsNeeded),
      verticesOf_(sites.size()),
      touched_(mesh.vertexCount()),
      labels_(static_cast<int>(sites.size())),
      isWhole_(sites.size()),
      changeAt_(mesh.vertexCount(), kInfinity) {
  while (!step(kAll)) {
  }
  state_.resize(entries_.size(), State::kUnlisted);
  isLate_.resize(entries_.size());
  for (int e = 0; e < static_cast<int>(entries_.size()); ++e)
    if (entries_[e].label >= 0) list(e);
  for (const int e : std::exchange(late_, {})) isLate_[e] = true;
  notesAccepted_ = true;
}

void DynamicSweep::setSite(int label, const SurfacePoint& site) {
  if (label >= static_cast<int>(sites_.size())) {
    addLabels(label + 1);
    verticesOf_.resize(label + 1);
    isWhole_.resize(label + 1);
    labels_ = IndexSet(label + 1);
  }
  sites_[label] = site;
  undoAll(label);
  do {
    replay();
  } while (findAffected());
  while (reachTheUnseen()) drain(kAll);
  noteAccepted();
  finish();
}

std::vector<int> DynamicSweep::takeTouched() {
  std::vector<int> touched = touched_.list();
  touched_.clear();
  return touched;
}

void DynamicSweep::list(int entry) {
  verticesOf_[entries_[entry].label].push_back(vertexOf(entry));
  state_[entry] = State::kAsBefore;
}

// --- What a change affects ---

/// Finds who reads what has changed since this was called last. Returns whether anything has to be
/// replayed that was not.
bool DynamicSweep::findAffected() {
  const size_t undone = undone_.size(), settledAgain = settledAgain_.size();
  for (const int label : labels_.list())
    if (mustBeWhole(label)) undoAll(label);
  for (; read_ < changed_.size(); ++read_) {
    const int v = changed_[read_];
    const double change = changeAt_[v];
    readFrom(v, 0, change);
    visitSpokes(mesh_, v,
                [&](const Spoke& spoke) { readFrom(spoke.neighbour, spoke.length, change); });
  }
  return undone_.size() > undone || settledAgain_.size() > settledAgain;
}

/// The entries of a vertex read what has changed at so long a way from it, if they would get there
/// at no less than the distance that has.
void DynamicSweep::readFrom(int vertex, double way, double change) {
  for (int e = vertex; e >= 0; e = entries_[e].next)
    if ((state_[e] == State::kAsBefore || state_[e] == State::kBesideUndone) &&
        (isEntangled_[entries_[e].label] ||
         change <= (entries_[e].distance + way) * (1 + kDistanceTolerance)))
      affect(e);
}

/// An entry that is affected stays what it is; if it is late, an earlier one of it was affected
/// too.
void DynamicSweep::affect(int entry) {
  const int label = entries_[entry].label;
  labels_.add(label);
  if (mustBeWhole(label)) return undoAll(label);
  if (isLate_[entry]) {
    undo(entry);
  } else {
    if (state_[entry] == State::kAsBefore) settledAgain_.push_back(entry);
    state_[entry] = State::kAffected;
    const double distance = entries_[entry].distance;
    mesh_.visitNeighbours(vertexOf(entry), [&](int v) { undoIfFollowing(v, label, distance); });
  }
  undoWhatFollows();
}

/// Whether what entries read does not tell all that a label depends on.
bool DynamicSweep::mustBeWhole(int label) const { return isEntangled_[label] && !isWhole_[label]; }

void DynamicSweep::undoAll(int label) {
  labels_.add(label);
  isWhole_[label] = true;
  for (const int v : verticesOf_[label])
    if (const int e = find(v, label); state_[e] != State::kUndone) undo(e);
}

void DynamicSweep::undo(int entry) {
  state_[entry] = State::kUndone;
  undone_.push_back(
      {entry, vertexOf(entry), entries_[entry].label, entries_[entry].distance, views_[entry]});
}

void DynamicSweep::undoWhatFollows() {
  for (; followed_ < undone_.size(); ++followed_) {
    const int label = undone_[followed_].label;
    const double distance = undone_[followed_].distance;
    if (isWhole_[label]) continue;
    mesh_.visitNeighbours(undone_[followed_].vertex,
                          [&](int v) { undoIfFollowing(v, label, distance); });
  }
}

/// What a label knows at a neighbour of a vertex may follow from what it knows there, at the given
/// distance: if that is less, or if the neighbour has improved late. What a late one was before may
/// have been carried on, too.
void DynamicSweep::undoIfFollowing(int vertex, int label, double distance) {
  const int e = find(vertex, label);
  if (e < 0 || state_[e] == State::kUndone) return;
  if (entries_[e].distance >= distance || isLate_[e]) undo(e);
}

// --- Replaying ---

void DynamicSweep::replay() {
  for (const Undone& u : undone_) {
    entries_[u.entry].distance = kInfinity;
    isLate_[u.entry] = false;
    if (owner_[u.vertex] == u.label) findOwner(u.vertex);
  }
  startAnew();
  for (const int label : labels_.list()) {
    if (isWhole_[label]) meetsShadows_[label] = isEntangled_[label] = false;
    if (sites_[label].face >= 0) seed(label);
  }
  for (const Undone& u : undone_)
    if (!isWhole_[u.label]) mesh_.visitNeighbours(u.vertex, [&](int v) { markBeside(v, u.label); });
  for (const int e : settledAgain_)
    if (state_[e] != State::kUndone) queue(e);
  drain(kAll);
  noteAccepted();
  noteDifferences();
}

void DynamicSweep::markBeside(int vertex, int label) {
  const int e = find(vertex, label);
  if (e < 0 || state_[e] != State::kAsBefore) return;
  state_[e] = State::kBesideUndone;
  settledAgain_.push_back(e);
}

/// Everything that has come or improved belongs to what is undone.
void DynamicSweep::noteAccepted() {
  state_.resize(entries_.size(), State::kUnlisted);
  isLate_.resize(entries_.size());
  for (const int e : accepted_) {
    if (state_[e] == State::kUndone) continue;
    if (state_[e] == State::kUnlisted) list(e);
    state_[e] = State::kUndone;
    undone_.push_back({e, vertexOf(e), entries_[e].label, kInfinity, {}});
  }
  accepted_.clear();
  for (const int e : late_) isLate_[e] = true;
  late_.clear();
}

void DynamicSweep::noteDifferences() {
  for (const Undone& u : undone_) {
    const double distance = entries_[u.entry].distance;
    const bool isSame =
        distance == u.distance && (distance == kInfinity || views_[u.entry] == u.view);
    const double change = std::min(distance, u.distance);
    if (isSame || change >= changeAt_[u.vertex]) continue;
    changeAt_[u.vertex] = change;
    changed_.push_back(u.vertex);
  }
}

/// Drops what is not known any more, and makes ready for the next change.
void DynamicSweep::finish() {
  for (const int e : settledAgain_) state_[e] = State::kAsBefore;
  std::vector<std::pair<int, int>> gone;  // vertices, labels
  for (const Undone& u : undone_) {
    state_[u.entry] = State::kAsBefore;
    touched_.add(u.vertex);
    if (entries_[u.entry].distance == kInfinity) gone.emplace_back(u.vertex, u.label);
  }
  IndexSet losing(static_cast<int>(sites_.size()));
  for (const auto& [vertex, label] : gone) {
    remove(find(vertex, label));
    losing.add(label);
  }
  for (const int label : losing.list())
    std::erase_if(verticesOf_[label], [&](int v) { return find(v, label) < 0; });
  for (const int label : labels_.list()) isWhole_[label] = false;
  for (const int v : changed_) changeAt_[v] = kInfinity;
  labels_.clear();
  undone_.clear();
  settledAgain_.clear();
  changed_.clear();
  followed_ = read_ = 0;
}

/// The nearest label of those that know their distance.
void DynamicSweep::findOwner(int vertex) {
  int nearest = vertex;
  for (int e = vertex; e >= 0; e = entries_[e].next)
    if (entries_[e].distance < entries_[nearest].distance) nearest = e;
  const bool isReached = entries_[nearest].distance < kInfinity;
  owner_[vertex] = isReached ? entries_[nearest].label : -1;
  if (!isReached) --reachedVertices_;
}

void DynamicSweep::remove(int entry) {
  const int vertex = vertexOf(entry);
  if (entry != vertex) {
    int before = vertex;
    while (entries_[before].next != entry) before = entries_[before].next;
    entries_[before].next = entries_[entry].next;
    release(entry);
  } else if (const int next = entries_[entry].next; next >= 0) {
    entries_[entry] = entries_[next];
    views_[entry] = views_[next];
    state_[entry] = state_[next];
    isLate_[entry] = isLate_[next];
    release(next);
  } else {
    clear(entry);
  }
}

void DynamicSweep::release(int entry) {
  clear(entry);
  released_.push_back(entry);
}

void DynamicSweep::clear(int entry) {
  entries_[entry] = {};
  state_[entry] = State::kUnlisted;
  isLate_[entry] = false;
}

}  // namespace gvd
