// SPDX-License-Identifier: MIT
#include "distance/known_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "distance/edge_share.h"
#include "distance/face_layout.h"

namespace gvd {
namespace {

/// Faces or vertices that take about as long as one unit of the budget, a batch of windows.
constexpr int kPerUnit = 32;

}  // namespace

KnownLabels::KnownLabels(const TriangleMesh& mesh, const SiteSet& sites,
                         const NearestBounds& bounds, LabelSpread& spread, bool isUnbounded)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      spread_(spread),
      isUnbounded_(isUnbounded),
      owners_(mesh, sites, bounds),
      lists_(mesh.vertexCount()),
      affectedFaces_(mesh.faceCount()),
      changedVertices_(mesh.vertexCount()),
      changedFaces_(mesh.faceCount()),
      marked_(mesh.vertexCount()) {}

// --- A change ----------------------------------------------------------------------------------

void KnownLabels::beginChange() {
  affectedFaces_.clear();
  changedVertices_.clear();
  changedFaces_.clear();
  changedLabels_.clear();
  ties_.clear();
  requirements_.clear();
}

void KnownLabels::leave(int label) {
  changedLabels_.push_back(label);
  for (const ReachedVertex& r : spread_.reached(label))
    if (r.isFinal)
      mesh_.visitFaces(r.vertex, [&](int f) {
        if (owners_.has(f, label)) affectedFaces_.add(f);
      });
  for (const int f : sites_.facesOf(label)) affectedFaces_.add(f);
}

void KnownLabels::start(std::span<const int> started, std::span<const int> resumed,
                        std::span<const int> resetVertices) {
  started_ = started;
  resumed_ = resumed;
  resetVertices_ = resetVertices;
  hasStarted_.assign(sites_.labelCount(), false);
  for (const int label : started_) hasStarted_[label] = true;
  isFirstRound_ = true;
  cursor_ = 0;
  stage_ = Stage::kFinal;
}

bool KnownLabels::step(long& budget) {
  while (stage_ != Stage::kDone) {
    if (!runStage(budget)) return false;
    cursor_ = 0;
    stage_ = nextStage();
  }
  return true;
}

KnownLabels::Stage KnownLabels::nextStage() {
  if (stage_ == Stage::kRequire && !isFirstRound_) return Stage::kExtend;
  if (stage_ == Stage::kLists) return Stage::kClosure;
  if (stage_ == Stage::kClosure) {
    isFirstRound_ = false;
    return requirements_.empty() ? Stage::kDone : Stage::kRequire;
  }
  return static_cast<Stage>(static_cast<int>(stage_) + 1);
}

bool KnownLabels::runStage(long& budget) {
  switch (stage_) {
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
bool KnownLabels::forEach(size_t count, long& budget, Work work) {
  for (; cursor_ < count; ++cursor_) {
    if (budget <= 0) return false;
    budget -= work(cursor_);
  }
  return true;
}

double KnownLabels::progress() const {
  if (stage_ == Stage::kDone) return 1;
  if (!isFirstRound_) return 0.95;
  if (stage_ < Stage::kRequire) return 0;
  if (stage_ > Stage::kRequire || requirements_.empty()) return 0.9;
  return 0.9 * static_cast<double>(cursor_) / static_cast<double>(requirements_.size());
}

/// Marks the distances that are final because the label owns the vertex, and notes ties.
bool KnownLabels::markFinal(long& budget) {
  return forEach(started_.size() + resumed_.size(), budget, [&](size_t i) {
    const int label = i < started_.size() ? started_[i] : resumed_[i - started_.size()];
    std::vector<ReachedVertex>& reached = spread_.reached(label);
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

/// Finds the faces of which the owners may have changed: those around vertices that are or were
/// owned by a label that has come or gone.
void KnownLabels::findAffected() {
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
    for (const ReachedVertex& r : spread_.reached(label))
      if (r.isFinal) addFacesAround(r.vertex);
    for (const int f : sites_.facesOf(label)) affectedFaces_.add(f);
  }
  for (const int f : affectedFaces_.list())
    for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
  resetInterpolatedAround();
}

/// Interpolation is done again around the affected faces, as far as it depends on what is known
/// there.
void KnownLabels::resetInterpolatedAround() {
  for (int i = 0; i < changedVertices_.size(); ++i)
    mesh_.visitFaces(changedVertices_.list()[i], [&](int f) {
      if (affectedFaces_.contains(f) || !owners_.removeInterpolated(f)) return;
      for (int h = 3 * f; h < 3 * f + 3; ++h) changedVertices_.add(mesh_.tail(h));
    });
}

bool KnownLabels::findOwnersOfCorners(long& budget) {
  const auto& faces = affectedFaces_.list();
  return forEach(faces.size() / kPerUnit + 1, budget, [&](size_t i) {
    const size_t end = std::min(faces.size(), (i + 1) * kPerUnit);
    for (size_t f = i * kPerUnit; f < end; ++f) owners_.reset(faces[f], requirements_);
    return 1;
  });
}

/// Finds the labels that tie with the owner of a vertex: those that have spread now, and others
/// that were known there.
bool KnownLabels::findTies(long& budget) {
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
            isAtMost(d.distance, nearest.distance) && !hasStarted_[d.label])
          add(vertices[v], d.label);
      }
    return 1;
  });
}

// --- Required distances ------------------------------------------------------------------------

bool KnownLabels::require(long& budget) {
  if (isUnbounded_) requirements_.clear();
  if (cursor_ == 0 && !isLabelBegun_) sortRequirements();
  while (cursor_ < requirements_.size()) {
    const int label = requirements_[cursor_].label;
    size_t end = cursor_;
    while (end < requirements_.size() && requirements_[end].label == label) ++end;
    if (!std::exchange(isLabelBegun_, true)) {
      requiredFaces_.clear();
      for (size_t i = cursor_; i < end; ++i) requiredFaces_.push_back(requirements_[i].face);
      spread_.require(label, requiredFaces_);
    }
    if (!spread_.run(budget)) return false;
    isLabelBegun_ = false;
    cursor_ = end;
  }
  return true;
}

/// By label; labels in the order of the faces at which they are required first, for what they touch
/// is in the cache then.
void KnownLabels::sortRequirements() {
  std::vector<int> rank(sites_.labelCount(), -1), offset = {0};
  for (const Requirement& r : requirements_) {
    if (rank[r.label] < 0) {
      rank[r.label] = static_cast<int>(offset.size()) - 1;
      offset.push_back(0);
    }
    ++offset[rank[r.label] + 1];
  }
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<Requirement> sorted(requirements_.size());
  for (const Requirement& r : requirements_) sorted[offset[rank[r.label]]++] = r;
  requirements_.swap(sorted);
}

// --- Lists -------------------------------------------------------------------------------------

/// Finds the vertices of which the lists have to be made anew, and the labels in question.
void KnownLabels::collectLists() {
  requirements_.clear();
  listed_.clear();
  if (areAllNew()) {
    listed_.assign(started_.begin(), started_.end());
    std::sort(listed_.begin(), listed_.end());
    changedFaces_.addAll();
    std::vector<int> counts(mesh_.vertexCount(), 0);
    for (const int label : listed_)
      for (const ReachedVertex& r : spread_.reached(label))
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
}

bool KnownLabels::listLabels(long& budget) {
  // Where all is new, what is final is required now.
  const bool isAllWanted = areAllNew();
  if (!forEach(listed_.size(), budget, [&](size_t i) {
        const int label = listed_[i];
        const auto& reached = spread_.reached(label);
        for (int r = 0; r < static_cast<int>(reached.size()); ++r) {
          const auto& [vertex, isFinal, distance] = reached[r];
          if ((isFinal && (isAllWanted ||
                           (changedVertices_.contains(vertex) && isKnownAround(vertex, label)))) ||
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
void KnownLabels::list(int label, int reachedIndex) {
  const auto& [vertex, isFinal, distance] = spread_.reached(label)[reachedIndex];
  // An approximation of a required distance may be too short: the owner remains nearer.
  const double nearest = bounds_[vertex].distance;
  const double listed = distance < nearest ? std::nextafter(nearest, kInfinity) : distance;
  lists_.add(vertex, {label, listed}, reachedIndex);
}

/// Adds what the last round of the closure has required.
void KnownLabels::extendLists() {
  added_.clear();
  for (size_t begin = 0, end; begin < requirements_.size(); begin = end) {
    const int label = requirements_[begin].label;
    for (end = begin; end < requirements_.size() && requirements_[end].label == label; ++end)
      for (const int v : mesh_.face(requirements_[end].face).vertices)
        if (lists_.distance(v, label) == kInfinity && marked_.add(v)) added_.push_back({v, label});
    const auto& reached = spread_.reached(label);
    for (int r = 0; r < static_cast<int>(reached.size()) && marked_.size() > 0; ++r)
      if (marked_.contains(reached[r].vertex)) list(label, r);
    marked_.clear();
  }
  for (const LabelAtVertex& added : added_)
    if (marked_.add(added.vertex)) noteAdded(added.vertex);
  marked_.clear();
  requirements_.clear();
  makeSet(changedLabels_);
}

void KnownLabels::noteAdded(int vertex) {
  lists_.equalizeTies(vertex);
  if (areAllNew()) return;
  mesh_.visitFaces(vertex, [&](int f) { changedFaces_.add(f); });
  for (const LabelledDistance& d : lists_[vertex]) changedLabels_.push_back(d.label);
}

/// Whether a label owns part of a face around a vertex.
bool KnownLabels::isKnownAround(int vertex, int label) const {
  if (bounds_[vertex].label == label) return true;
  bool isKnown = false;
  mesh_.visitFaces(vertex, [&](int f) { isKnown = isKnown || owners_.has(f, label); });
  return isKnown;
}

// --- Closure -----------------------------------------------------------------------------------

/// A diagram takes squared distances as linear within a face, up to what all labels have in common.
/// If by that a label owns part of an edge, the faces on both sides have to know it.
bool KnownLabels::close(long& budget) {
  if (isUnbounded_) return true;
  const size_t count = isFirstRound_ ? changedFaces_.size() : added_.size();
  return forEach(count / kPerUnit + 1, budget, [&](size_t i) {
    const size_t end = std::min(count, (i + 1) * kPerUnit);
    for (size_t k = i * kPerUnit; k < end; ++k) {
      if (isFirstRound_)
        closeFace(changedFaces_.list()[k]);
      else
        closeAround(added_[k].vertex, added_[k].label);
    }
    return 1;
  });
}

/// Finds the labels that are known at two corners of a face, and looks at the edge between them.
void KnownLabels::closeFace(int f) {
  const auto& corners = mesh_.face(f).vertices;
  const auto atA = lists_[corners[0]], atB = lists_[corners[1]], atC = lists_[corners[2]];
  if ((atA.size() > 1) + (atB.size() > 1) + (atC.size() > 1) < 2) return;
  constexpr int kNone = std::numeric_limits<int>::max();
  auto a = atA.begin(), b = atB.begin(), c = atC.begin();
  while (true) {
    const int labelA = a == atA.end() ? kNone : a->label;
    const int labelB = b == atB.end() ? kNone : b->label;
    const int labelC = c == atC.end() ? kNone : c->label;
    const int label = std::min({labelA, labelB, labelC});
    if (label == kNone) return;
    const bool isAtA = labelA == label, isAtB = labelB == label, isAtC = labelC == label;
    if (isAtA + isAtB + isAtC == 2) requireAcross(3 * f + (isAtC ? isAtB ? 1 : 2 : 0), label);
    a += isAtA;
    b += isAtB;
    c += isAtC;
  }
}

/// Looks at the edges around a vertex at which a label has become known.
void KnownLabels::closeAround(int vertex, int label) {
  mesh_.visitFaces(vertex, [&](int f) {
    const auto& corners = mesh_.face(f).vertices;
    const int i = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    const bool isAfter = lists_.distance(corners[cornerAfter(i)], label) < kInfinity;
    const bool isBefore = lists_.distance(corners[cornerBefore(i)], label) < kInfinity;
    if (isAfter != isBefore) requireAcross(3 * f + (isAfter ? i : cornerBefore(i)), label);
  });
}

/// Requires, at the apex of a halfedge, a label that is known at both ends, if the label owns part
/// of the halfedge.
void KnownLabels::requireAcross(int h, int label) {
  const int tail = mesh_.tail(h), tip = mesh_.tip(h), owner = bounds_[tail].label;
  // Most labels are farther than one owner at both ends.
  if (lists_.distance(tail, label) > bounds_[tail].distance &&
      lists_.distance(tip, label) > lists_.distance(tip, owner))
    return;
  if (ownsPartOfEdge(label, h)) owners_.add(TriangleMesh::faceOf(h), label, true, requirements_);
}

/// Whether a label is least anywhere on an edge by interpolation, compared with the true owners of
/// the faces beside it: so what is found does not depend on the order in which it is.
bool KnownLabels::ownsPartOfEdge(int label, int h) const {
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

}  // namespace gvd
