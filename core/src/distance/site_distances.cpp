// SPDX-License-Identifier: MIT
#include "distance/site_distances.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/index_set.h"
#include "distance/dgpc/unfolding_spread.h"
#include "distance/edge_share.h"
#include "distance/exact/window_spread.h"

namespace gvd {
namespace {

/// Faces or vertices that take about as long as one unit of the budget, a batch of windows.
constexpr int kPerUnit = 32;

}  // namespace

SiteDistances::SiteDistances(const TriangleMesh& mesh, Metric metric, Spread spread)
    : mesh_(mesh),
      isUnbounded_(spread == Spread::kEverywhere),
      isExact_(metric == Metric::kExact),
      sites_(mesh),
      edgeBounds_(mesh, sites_),
      bounds_(mesh.vertexCount()),
      owners_(mesh, sites_, bounds_),
      lists_(mesh.vertexCount()),
      affectedFaces_(mesh.faceCount()),
      changedVertices_(mesh.vertexCount()),
      changedFaces_(mesh.faceCount()) {
  if (metric == Metric::kDgpc)
    spread_ = std::make_unique<dgpc::UnfoldingSpread>(mesh, sites_, edgeBounds_, bounds_,
                                                      isUnbounded_);
  else
    spread_ = std::make_unique<exact::WindowSpread>(
        mesh, sites_, bounds_,
        isUnbounded_ ? exact::SpreadTo::kEverywhere : exact::SpreadTo::kOwned);
}

// --- A change ----------------------------------------------------------------------------------

void SiteDistances::change(std::span<const SiteChange> changes) {
  started_.clear();
  resumed_.clear();
  resetVertices_.clear();
  affectedFaces_.clear();
  changedVertices_.clear();
  changedFaces_.clear();
  changedLabels_.clear();
  ties_.clear();
  for (const SiteChange& c : changes) {
    changedLabels_.push_back(c.label);
    if (!sites_.contains(c.label)) continue;
    forget(c.label);
    const SurfacePoint site = sites_[c.label];
    sites_.remove(c.label);
    edgeBounds_.remove(c.label, site);
  }
  for (const SiteChange& c : changes) {
    if (c.site.face < 0) continue;
    sites_.insert(c.label, c.site);
    edgeBounds_.insert(c.label);
    started_.push_back(c.label);
  }
  requirements_.clear();
  isFirstRound_ = true;
  stage_ = Stage::kBounds;
  cursor_ = 0;
}

/// Forgets what a label has found. The labels that were known there may have to go on.
void SiteDistances::forget(int label) {
  for (const ReachedVertex& r : spread_->reached(label)) {
    if (!r.isFinal) continue;
    for (const LabelledDistance& d : lists_[r.vertex]) resumed_.push_back(d.label);
    if (bounds_[r.vertex].label == label) {
      spread_->appendReaching(r.vertex, resumed_);
      bounds_[r.vertex] = {};
      resetVertices_.push_back(r.vertex);
    }
    mesh_.visitFaces(r.vertex, [&](int f) {
      if (owners_.has(f, label)) affectedFaces_.add(f);
    });
  }
  makeSet(resumed_);
  for (const int f : sites_.facesOf(label)) affectedFaces_.add(f);
  spread_->remove(label);
  found_.remove(label);
}

bool SiteDistances::step(long budget) {
  while (stage_ != Stage::kDone) {
    if (!runStage(budget)) return false;
    cursor_ = 0;
    stage_ = nextStage();
  }
  return true;
}

SiteDistances::Stage SiteDistances::nextStage() {
  if (stage_ == Stage::kRequire && !isFirstRound_) return Stage::kExtend;
  if (stage_ == Stage::kLists) return Stage::kClosure;
  if (stage_ == Stage::kClosure) {
    isFirstRound_ = false;
    return requirements_.empty() ? Stage::kDone : Stage::kRequire;
  }
  return static_cast<Stage>(static_cast<int>(stage_) + 1);
}

bool SiteDistances::runStage(long& budget) {
  switch (stage_) {
    case Stage::kBounds:
      return edgeBounds_.run(budget);
    case Stage::kStart:
      lowerBounds();
      return true;
    case Stage::kSpread:
      return spread(budget);
    case Stage::kFinal:
      return markFinal(budget);
    case Stage::kAffected:
      findAffected();
      return true;
    case Stage::kCorners:
      return findOwnersOfCorners(budget);
    case Stage::kTies:
      return findTies(budget);
    case Stage::kRequire:
      return require(budget);
    case Stage::kCollect:
      collectLists();
      return true;
    case Stage::kLists:
      return listLabels(budget);
    case Stage::kExtend:
      extendLists();
      return true;
    case Stage::kClosure:
      return close(budget);
    case Stage::kDone:
      break;
  }
  return true;
}

/// Calls work(i), which returns the units that it took, for i from the cursor on up to `count`.
template <class Work>
bool SiteDistances::forEach(size_t count, long& budget, Work work) {
  for (; cursor_ < count; ++cursor_) {
    if (budget <= 0) return false;
    budget -= work(cursor_);
  }
  return true;
}

double SiteDistances::progress() const {
  const auto share = [&](size_t count) {
    return count == 0 ? 1.0 : static_cast<double>(cursor_) / static_cast<double>(count);
  };
  if (stage_ < Stage::kSpread) return 0;
  if (stage_ == Stage::kSpread) return 0.6 * share(started_.size() + resumed_.size());
  if (stage_ < Stage::kRequire) return 0.6;
  if (stage_ == Stage::kDone) return 1;
  if (stage_ == Stage::kRequire && isFirstRound_) return 0.6 + 0.3 * share(requirements_.size());
  return isFirstRound_ ? 0.9 : 0.95;
}

// --- Bounds and labels -------------------------------------------------------------------------

/// Limits the distance of the nearest site by paths along edges, and by what labels that may go on
/// know already.
void SiteDistances::lowerBounds() {
  if (!areAllNew())
    for (const int label : spread_->outdated(edgeBounds_.changed())) {
      forget(label);
      started_.push_back(label);
      changedLabels_.push_back(label);
    }
  // Labels near one another in succession, for what they touch is in the cache then.
  std::sort(started_.begin(), started_.end(),
            [&](int a, int b) { return std::pair(sites_[a].face, a) < std::pair(sites_[b].face, b); });
  hasStarted_.assign(sites_.labelCount(), false);
  for (const int label : started_) hasStarted_[label] = true;
  makeSet(resumed_);
  std::erase_if(resumed_, [&](int label) { return !sites_.contains(label) || hasStarted(label); });
  for (const int v : edgeBounds_.changed())
    if (bounds_[v].label < 0) bounds_[v].distance = edgeBounds_[v];
  edgeBounds_.clearChanged();
  for (const int v : resetVertices_) bounds_[v].distance = edgeBounds_[v];
  for (const int label : resumed_)
    for (const ReachedVertex& r : spread_->reached(label))
      lower(bounds_[r.vertex], label, r.distance);
}

bool SiteDistances::spread(long& budget) {
  for (; cursor_ < started_.size() + resumed_.size(); ++cursor_) {
    if (!std::exchange(isLabelBegun_, true)) {
      if (cursor_ < started_.size())
        spread_->start(started_[cursor_]);
      else
        spread_->resume(resumed_[cursor_ - started_.size()]);
    }
    if (!spread_->run(budget)) return false;
    isLabelBegun_ = false;
  }
  return true;
}

/// Marks the distances that are final because the label owns the vertex, and notes ties.
bool SiteDistances::markFinal(long& budget) {
  return forEach(started_.size() + resumed_.size(), budget, [&](size_t i) {
    const int label = i < started_.size() ? started_[i] : resumed_[i - started_.size()];
    std::vector<ReachedVertex>& reached = spread_->reached(label);
    for (ReachedVertex& r : reached) {
      const LabelledDistance& nearest = bounds_[r.vertex];
      if (!isAtMost(r.distance, nearest.distance)) continue;
      r.isFinal = true;
      if (nearest.label != label) ties_.push_back({r.vertex, label});
    }
    return 1 + static_cast<long>(reached.size()) / kPerUnit;
  });
}

// --- Owners ------------------------------------------------------------------------------------

/// Finds the faces of which the owners may have changed: those around vertices that are or were owned
/// by a label that has come or gone.
void SiteDistances::findAffected() {
  if (areAllNew()) {
    affectedFaces_.addAll();
    changedVertices_.addAll();
    return;
  }
  const auto addFacesAround = [&](int v) {
    mesh_.visitFaces(v, [&](int f) { affectedFaces_.add(f); });
  };
  for (const int v : resetVertices_) addFacesAround(v);
  for (const int label : started_) {
    for (const ReachedVertex& r : spread_->reached(label))
      if (r.isFinal) addFacesAround(r.vertex);
    for (const int f : sites_.facesOf(label)) affectedFaces_.add(f);
  }
  for (const int f : affectedFaces_.list())
    for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
  resetInterpolatedAround();
}

/// Interpolation is done again around the affected faces, as far as it depends on what is known there.
void SiteDistances::resetInterpolatedAround() {
  for (int i = 0; i < changedVertices_.size(); ++i)
    mesh_.visitFaces(changedVertices_.list()[i], [&](int f) {
      if (affectedFaces_.contains(f) || !owners_.removeInterpolated(f)) return;
      for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
    });
}

bool SiteDistances::findOwnersOfCorners(long& budget) {
  const auto& faces = affectedFaces_.list();
  return forEach(faces.size() / kPerUnit + 1, budget, [&](size_t i) {
    const size_t end = std::min(faces.size(), (i + 1) * kPerUnit);
    for (size_t f = i * kPerUnit; f < end; ++f) owners_.reset(faces[f], requirements_);
    return 1;
  });
}

/// Finds the labels that tie with the owner of a vertex: those that have spread now, and others that were
/// known there.
bool SiteDistances::findTies(long& budget) {
  const auto& vertices = changedVertices_.list();
  const auto add = [&](int vertex, int label) {
    mesh_.visitFaces(vertex, [&](int f) {
      if (affectedFaces_.contains(f)) owners_.add(f, label, false, requirements_);
    });
  };
  return forEach(vertices.size() / kPerUnit + 1, budget, [&](size_t i) {
    if (i == 0)
      for (const auto& [vertex, label] : ties_) add(vertex, label);
    const size_t end = std::min(vertices.size(), (i + 1) * kPerUnit);
    for (size_t v = i * kPerUnit; v < end; ++v)
      for (const LabelledDistance& d : lists_[vertices[v]]) {
        const LabelledDistance& nearest = bounds_[vertices[v]];
        if (d.label != nearest.label && sites_.contains(d.label) &&
            isAtMost(d.distance, nearest.distance) && !hasStarted(d.label))
          add(vertices[v], d.label);
      }
    return 1;
  });
}

// --- Required distances ------------------------------------------------------------------------

bool SiteDistances::require(long& budget) {
  if (isUnbounded_) requirements_.clear();
  if (cursor_ == 0 && !isLabelBegun_) sortRequirements();
  while (cursor_ < requirements_.size()) {
    const int label = requirements_[cursor_].label;
    size_t end = cursor_;
    while (end < requirements_.size() && requirements_[end].label == label) ++end;
    if (!std::exchange(isLabelBegun_, true)) {
      requiredFaces_.clear();
      for (size_t i = cursor_; i < end; ++i) requiredFaces_.push_back(requirements_[i].face);
      spread_->require(label, requiredFaces_);
    }
    if (!spread_->run(budget)) return false;
    isLabelBegun_ = false;
    cursor_ = end;
  }
  return true;
}

/// By label.
void SiteDistances::sortRequirements() {
  std::vector<int> offset(sites_.labelCount() + 1, 0);
  for (const Requirement& r : requirements_) ++offset[r.label + 1];
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<Requirement> sorted(requirements_.size());
  for (const Requirement& r : requirements_) sorted[offset[r.label]++] = r;
  requirements_.swap(sorted);
}

// --- Lists -------------------------------------------------------------------------------------

/// Finds the vertices of which the lists have to be made anew, and the labels in question.
void SiteDistances::collectLists() {
  requirements_.clear();
  listed_.clear();
  if (areAllNew()) {
    listed_ = started_;
    std::sort(listed_.begin(), listed_.end());
    changedFaces_.addAll();
    std::vector<int> counts(mesh_.vertexCount(), 0);
    for (const int label : listed_)
      for (const ReachedVertex& r : spread_->reached(label))
        counts[r.vertex] += isUnbounded_ || r.isFinal;
    lists_.allot(counts);
  } else {
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
  openFaces_ = changedFaces_.list();
}

bool SiteDistances::listLabels(long& budget) {
  // Where all is new, what is final is required now.
  const bool isAllWanted = areAllNew();
  if (!forEach(listed_.size(), budget, [&](size_t i) {
        const int label = listed_[i];
        const auto& reached = spread_->reached(label);
        for (int r = 0; r < static_cast<int>(reached.size()); ++r) {
          const auto& [vertex, isFinal, distance] = reached[r];
          if ((isFinal && (isAllWanted || (changedVertices_.contains(vertex) &&
                                           isKnownAround(vertex, label)))) ||
              isUnbounded_)
            list(label, r);
        }
        return 1 + static_cast<long>(reached.size()) / kPerUnit;
      }))
    return false;
  for (const int v : changedVertices_.list()) lists_.equalizeTies(v);
  return true;
}

/// Adds a label to the list of a vertex that it has reached.
void SiteDistances::list(int label, int reachedIndex) {
  const auto& [vertex, isFinal, distance] = spread_->reached(label)[reachedIndex];
  // An approximation of a required distance may be too short: the owner remains nearer.
  const double nearest = bounds_[vertex].distance;
  const double listed = distance < nearest ? std::nextafter(nearest, kInfinity) : distance;
  lists_.add(vertex, {label, listed}, reachedIndex);
}

/// Adds what the last round of the closure has required. The faces around are open again.
void SiteDistances::extendLists() {
  openFaces_.clear();
  std::vector<int> vertices;
  for (size_t begin = 0, end; begin < requirements_.size(); begin = end) {
    const int label = requirements_[begin].label;
    vertices.clear();
    for (end = begin; end < requirements_.size() && requirements_[end].label == label; ++end)
      for (const int v : mesh_.face(requirements_[end].face).vertices)
        if (lists_.distance(v, label) == kInfinity) vertices.push_back(v);
    makeSet(vertices);
    const auto& reached = spread_->reached(label);
    for (int r = 0; r < static_cast<int>(reached.size()); ++r)
      if (std::binary_search(vertices.begin(), vertices.end(), reached[r].vertex)) list(label, r);
    for (const int v : vertices) {
      lists_.equalizeTies(v);
      mesh_.visitFaces(v, [&](int f) { openFaces_.push_back(f); });
      for (const LabelledDistance& d : lists_[v]) changedLabels_.push_back(d.label);
    }
  }
  requirements_.clear();
  makeSet(openFaces_);
  makeSet(changedLabels_);
  for (const int f : openFaces_) changedFaces_.add(f);
}

/// Whether a label owns part of a face around a vertex.
bool SiteDistances::isKnownAround(int vertex, int label) const {
  if (bounds_[vertex].label == label) return true;
  bool isKnown = false;
  mesh_.visitFaces(vertex, [&](int f) { isKnown = isKnown || owners_.has(f, label); });
  return isKnown;
}

// --- Closure -----------------------------------------------------------------------------------

/// A diagram takes squared distances as linear within a face, up to what all labels have in common.
/// If by that a label owns part of an edge, the faces on both sides have to know it.
bool SiteDistances::close(long& budget) {
  if (isUnbounded_) return true;
  return forEach(openFaces_.size() / kPerUnit + 1, budget, [&](size_t i) {
    const size_t end = std::min(openFaces_.size(), (i + 1) * kPerUnit);
    for (size_t f = i * kPerUnit; f < end; ++f)
      for (int h = 3 * openFaces_[f]; h < 3 * openFaces_[f] + 3; ++h) requireAcross(h);
    return 1;
  });
}

/// Requires, at the apex of a halfedge, the labels that own part of the halfedge.
void SiteDistances::requireAcross(int h) {
  const int tail = mesh_.tail(h), tip = mesh_.tip(h);
  const auto atTail = lists_[tail], atTip = lists_[tip];
  if (atTail.size() < 2 || atTip.size() < 2) return;
  const auto atApex = lists_[mesh_.tail(TriangleMesh::previous(h))];
  const int owner = bounds_[tail].label;
  const double ownerAtTail = bounds_[tail].distance, ownerAtTip = lists_.distance(tip, owner);
  auto there = atTip.begin(), across = atApex.begin();
  for (const LabelledDistance& d : atTail) {
    while (there != atTip.end() && there->label < d.label) ++there;
    while (across != atApex.end() && across->label < d.label) ++across;
    if (there == atTip.end()) return;
    if (there->label != d.label || (across != atApex.end() && across->label == d.label)) continue;
    // Most labels are farther than one owner at both ends.
    if (d.distance > ownerAtTail && there->distance > ownerAtTip) continue;
    if (ownsPartOfEdge(d.label, h))
      owners_.add(TriangleMesh::faceOf(h), d.label, true, requirements_);
  }
}

/// Whether a label is least anywhere on an edge by interpolation, compared with the true owners of the
/// faces beside it: so what is found does not depend on the order in which it is.
bool SiteDistances::ownsPartOfEdge(int label, int h) const {
  EdgeShare share(label, lists_.distance(mesh_.tail(h), label),
                  lists_.distance(mesh_.tip(h), label));
  const auto yieldTo = [&](int other) {
    const double atTail = lists_.distance(mesh_.tail(h), other);
    const double atTip = lists_.distance(mesh_.tip(h), other);
    if (other != label && atTail < kInfinity && atTip < kInfinity)
      share.yieldTo(other, atTail, atTip);
  };
  for (const int side : {h, mesh_.twin(h)}) {
    if (side < 0) continue;
    const int face = TriangleMesh::faceOf(side);
    if (owners_.sole(face) >= 0) yieldTo(owners_.sole(face));
    for (const FaceOwners::Owner& owner : owners_.several(face))
      if (!owner.isInterpolated) yieldTo(owner.label);
  }
  return !share.isEmpty();
}

// --- Queries -----------------------------------------------------------------------------------

LabelledDistance SiteDistances::nearest(const SurfacePoint& p) const {
  for (int i = 0; i < 3; ++i)
    if (p.bary[i] == 1) return nearestOf(at(mesh_.tail(3 * p.face + i)));
  std::vector<int> labels;
  for (int h = 3 * p.face; h < 3 * p.face + 3; ++h)
    for (const LabelledDistance& d : at(mesh_.tail(h))) labels.push_back(d.label);
  spread_->appendLabelsInside(p.face, labels);
  makeSet(labels);
  LabelledDistance best;
  bool isBestKnown = false;
  for (const int label : labels) {
    const std::array<double, 3> atCorners = distancesAtCorners(p.face, label);
    const double distance = spread_->distance(label, p, atCorners);
    if (!(isAtMost(distance, best.distance) && distance < kInfinity)) continue;
    bool isKnown = true;
    for (int i = 0; i < 3; ++i) isKnown = isKnown && !(p.bary[i] > 0 && atCorners[i] == kInfinity);
    // Of labels that tie, the lowest, but first those that are known around the point.
    if (!isAtMost(best.distance, distance) || best.label < 0 || isKnown > isBestKnown) {
      best.label = label;
      isBestKnown = isKnown;
    }
    best.distance = std::min(best.distance, distance);
  }
  return best;
}

std::array<double, 3> SiteDistances::distancesAtCorners(int face, int label) const {
  const auto& corners = mesh_.face(face).vertices;
  return {lists_.distance(corners[0], label), lists_.distance(corners[1], label),
          lists_.distance(corners[2], label)};
}

double SiteDistances::distance(int label, const SurfacePoint& p) const {
  const std::array<double, 3> atCorners = distancesAtCorners(p.face, label);
  for (int i = 0; i < 3; ++i) {
    if (p.bary[i] == 1) return atCorners[i];
    if (p.bary[i] > 0 && atCorners[i] == kInfinity) return kInfinity;
  }
  return spread_->distance(label, p, atCorners);
}

Eigen::Vector2d SiteDistances::direction(int label, int vertex) const {
  const int index = lists_.reachedIndex(vertex, label);
  return index < 0 ? DistanceField::direction(label, vertex) : spread_->direction(label, index);
}

}  // namespace gvd
