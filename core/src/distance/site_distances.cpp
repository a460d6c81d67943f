// SPDX-License-Identifier: MIT
#include "distance/site_distances.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "base/tolerances.h"
#include "distance/exact/window_spread.h"
#include "distance/face_layout.h"
#include "mesh/surface_geometry.h"

namespace gvd {

SiteDistances::SiteDistances(const TriangleMesh& mesh, Metric metric, Spread spread)
    : mesh_(mesh),
      isUnbounded_(spread == Spread::kEverywhere),
      sites_(mesh),
      edgeBounds_(mesh, sites_),
      bounds_(mesh.vertexCount()),
      faceLabels_(mesh.faceCount()),
      lists_(mesh.vertexCount()),
      records_(mesh.vertexCount()),
      affectedFaces_(mesh.faceCount()),
      affectedVertices_(mesh.vertexCount()),
      changedFaces_(mesh.faceCount()) {
  static_cast<void>(metric);
  spread_ = std::make_unique<exact::WindowSpread>(
      mesh, sites_, bounds_,
      isUnbounded_ ? exact::SpreadTo::kEverywhere : exact::SpreadTo::kOwned);
}

void SiteDistances::change(std::span<const SiteChange> changes) {
  started_.clear();
  resumed_.clear();
  resetVertices_.clear();
  affectedFaces_.clear();
  affectedVertices_.clear();
  changedFaces_.clear();
  changedLabels_.clear();
  requirements_.clear();
  for (const SiteChange& c : changes) {
    changedLabels_.push_back(c.label);
    if (sites_.contains(c.label)) forget(c.label);
  }
  for (const SiteChange& c : changes) {
    if (c.site.face < 0) continue;
    sites_.insert(c.label, c.site);
    edgeBounds_.insert(c.label);
    started_.push_back(c.label);
  }
  // Labels near one another in succession, for what they touch is in the cache then.
  std::sort(started_.begin(), started_.end(),
            [&](int a, int b) { return std::pair(sites_[a].face, a) < std::pair(sites_[b].face, b); });
  makeSet(resumed_);
  std::erase_if(resumed_, [&](int label) { return !sites_.contains(label); });
  std::erase_if(resumed_, [&](int label) {
    return std::find(started_.begin(), started_.end(), label) != started_.end();
  });
  stage_ = Stage::kBounds;
  cursor_ = 0;
}

/// Takes a label away, and the vertices that it owns.
void SiteDistances::forget(int label) {
  for (const ReachedVertex& r : spread_->reached(label)) {
    if (!r.isFinal) continue;
    const int v = r.vertex;
    for (const LabelledDistance& d : lists_[v]) resumed_.push_back(d.label);
    if (bounds_[v].label == label) {
      bounds_[v] = {};
      resetVertices_.push_back(v);
    }
    mesh_.visitFaces(v, [&](int f) {
      if (has(f, label)) affectedFaces_.add(f);
    });
  }
  makeSet(resumed_);
  for (const int f : sites_.facesOf(label)) affectedFaces_.add(f);
  const SurfacePoint site = sites_[label];
  spread_->remove(label);
  sites_.remove(label);
  edgeBounds_.remove(label, site);
}

bool SiteDistances::step(long budget) {
  while (stage_ != Stage::kDone) {
    if (budget <= 0) return false;
    const auto t0 = std::chrono::steady_clock::now(); const int st = (int)stage_;
    switch (stage_) {
      case Stage::kBounds:
        if (!edgeBounds_.run(budget)) return false;
        findBounds();
        stage_ = Stage::kSpread;
        break;
      case Stage::kSpread:
        if (!spread(budget)) return false;
        stage_ = Stage::kOwners;
        break;
      case Stage::kOwners:
        findOwners();
        stage_ = Stage::kRequire;
        break;
      case Stage::kRequire:
        if (!require(budget)) return false;
        stage_ = Stage::kLists;
        break;
      case Stage::kLists:
        listLabels();
        stage_ = Stage::kClosure;
        break;
      case Stage::kClosure:
        stage_ = close() ? Stage::kRequire : Stage::kDone;
        break;
      case Stage::kDone:
        break;
    }
    cursor_ = 0;
    times[st] += std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
  }
  return true;
}

void SiteDistances::findBounds() {
  for (const int v : edgeBounds_.changed())
    if (bounds_[v].label < 0) bounds_[v].distance = edgeBounds_[v];
  edgeBounds_.clearChanged();
  for (const int v : resetVertices_) bounds_[v].distance = edgeBounds_[v];
  for (const int label : resumed_)
    for (const ReachedVertex& r : spread_->reached(label)) lower(bounds_[r.vertex], label, r.distance);
}

bool SiteDistances::spread(long& budget) {
  for (; cursor_ < started_.size() + resumed_.size(); ++cursor_) {
    const bool isNew = cursor_ < started_.size();
    const int label = isNew ? started_[cursor_] : resumed_[cursor_ - started_.size()];
    if (!isRunning_) {
      if (isNew)
        spread_->start(label);
      else
        spread_->resume(label);
    }
    isRunning_ = true;
    if (!spread_->run(budget)) return false;
    isRunning_ = false;
  }
  return true;
}

bool SiteDistances::isOwnerOfAll(int face, int label) const {
  const auto isOwner = [&](int h) { return bounds_[mesh_.tail(h)].label == label; };
  return isOwner(3 * face) && isOwner(3 * face + 1) && isOwner(3 * face + 2);
}

bool SiteDistances::has(int face, int label) const {
  for (const FaceLabel& l : faceLabels_[face])
    if (l.label == label) return true;
  return false;
}

/// Notes that a label owns part of a face, with the owners of its corners.
void SiteDistances::addOwner(int face, int label) {
  const bool isFirst = faceLabels_.empty(face);
  const auto add = [&](int l) {
    if (l < 0 || has(face, l)) return;
    faceLabels_.add(face, {l, false});
    requirements_.push_back({l, face});
  };
  if (isFirst)
    for (int h = 3 * face; h < 3 * face + 3; ++h) add(bounds_[mesh_.tail(h)].label);
  add(label);
}

void SiteDistances::findOwners() {
  const auto isKnownAt = [&](int v, int label) {
    for (const LabelledDistance& d : lists_[v])
      if (d.label == label) return true;
    return false;
  };
  static_cast<void>(isKnownAt);
  for (const int v : resetVertices_) affectedVertices_.add(v);
  for (const auto* labels : {&started_, &resumed_})
    for (const int label : *labels) {
      for (ReachedVertex& r : spread_->reached(label)) {
        if (!isAtMost(r.distance, bounds_[r.vertex].distance)) continue;
        r.isFinal = true;
        affectedVertices_.add(r.vertex);
      }
    }
  for (const int v : affectedVertices_.list())
    mesh_.visitFaces(v, [&](int f) { affectedFaces_.add(f); });
  // Labels that have come into faces of which others own all corners.
  std::vector<int> faces;
  for (const int label : started_)
    spread_->appendPartlyOwned(
        label, [&](int f) { return !affectedFaces_.contains(f); }, faces);
  for (const int label : started_)
    for (const int f : sites_.facesOf(label)) faces.push_back(f);
  for (const int f : faces) affectedFaces_.add(f);

  // The labels that may own part of the affected faces.
  std::vector<int> candidates = started_;
  candidates.insert(candidates.end(), resumed_.begin(), resumed_.end());
  for (const int f : affectedFaces_.list()) {
    faceLabels_.clear(f);
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      affectedVertices_.add(mesh_.tail(h));
    }
  }
  for (const int v : affectedVertices_.list())
    for (const LabelledDistance& d : lists_[v]) candidates.push_back(d.label);
  makeSet(candidates);
  std::erase_if(candidates, [&](int label) { return !sites_.contains(label); });
  // Added labels of faces around depend on what is known in the affected ones.
  for (size_t i = 0; i < affectedVertices_.list().size(); ++i)
    mesh_.visitFaces(affectedVertices_.list()[i], [&](int f) {
      if (affectedFaces_.contains(f)) return;
      auto labels = faceLabels_[f];
      if (std::none_of(labels.begin(), labels.end(), [](const FaceLabel& l) { return l.isByClosure; }))
        return;
      faceLabels_.eraseIf(f, [](const FaceLabel& l) { return l.isByClosure; });
      for (int h = 3 * f; h < 3 * f + 3; ++h) affectedVertices_.add(mesh_.tail(h));
    });

  for (const int f : affectedFaces_.list()) {
    const int label = bounds_[mesh_.tail(3 * f)].label;
    if (!isOwnerOfAll(f, label)) addOwner(f, label);
    for (const FaceSite& site : sites_.inFace(f))
      if (!faceLabels_.empty(f) || !isOwnerOfAll(f, site.label)) addOwner(f, site.label);
  }
  for (const int label : candidates) {
    for (const ReachedVertex& r : spread_->reached(label)) {
      const LabelledDistance& nearest = bounds_[r.vertex];
      if (nearest.label != label && isAtMost(r.distance, nearest.distance))
        mesh_.visitFaces(r.vertex, [&](int f) {
          if (affectedFaces_.contains(f)) addOwner(f, label);
        });
    }
    faces.clear();
    spread_->appendPartlyOwned(
        label,
        [&](int f) {
          return affectedFaces_.contains(f) && !has(f, label) &&
                 !(faceLabels_.empty(f) && isOwnerOfAll(f, label));
        },
        faces);
    for (const int f : faces) addOwner(f, label);
  }
  if (isUnbounded_) requirements_.clear();
}

bool SiteDistances::require(long& budget) {
  if (cursor_ == 0 && !isRunning_)
    std::sort(requirements_.begin(), requirements_.end(),
              [&](const Requirement& a, const Requirement& b) {
                const int fa = sites_[a.label].face, fb = sites_[b.label].face;
                return std::tie(fa, a.label) < std::tie(fb, b.label);
              });
  while (cursor_ < requirements_.size()) {
    size_t end = cursor_;
    const int label = requirements_[cursor_].label;
    while (end < requirements_.size() && requirements_[end].label == label) ++end;
    if (!isRunning_) {
      std::vector<int> faces;
      for (size_t i = cursor_; i < end; ++i) faces.push_back(requirements_[i].face);
      spread_->require(label, faces);
    }
    isRunning_ = true;
    if (!spread_->run(budget)) return false;
    isRunning_ = false;
    cursor_ = end;
  }
  return true;
}

void SiteDistances::listLabels() {
  for (const Requirement& r : requirements_)
    for (int h = 3 * r.face; h < 3 * r.face + 3; ++h) affectedVertices_.add(mesh_.tail(h));
  requirements_.clear();
  std::vector<int> labels;
  for (const int v : affectedVertices_.list()) {
    for (const LabelledDistance& d : lists_[v]) changedLabels_.push_back(d.label);
    lists_.clear(v);
    records_.clear(v);
    if (bounds_[v].label >= 0) labels.push_back(bounds_[v].label);
    mesh_.visitFaces(v, [&](int f) {
      changedFaces_.add(f);
      for (const FaceLabel& l : faceLabels_[f]) labels.push_back(l.label);
    });
  }
  makeSet(labels);
  if (isUnbounded_) labels = started_, makeSet(labels);
  for (const int label : labels) {
    const auto& reached = spread_->reached(label);
    for (int i = 0; i < static_cast<int>(reached.size()); ++i) {
      const int v = reached[i].vertex;
      if (!affectedVertices_.contains(v)) continue;
      bool isWanted = isUnbounded_;
      if (!isWanted && reached[i].isFinal) {
        isWanted = bounds_[v].label == label;
        if (!isWanted) mesh_.visitFaces(v, [&](int f) { isWanted = isWanted || has(f, label); });
      }
      if (!isWanted) continue;
      lists_.add(v, {label, reached[i].distance});
      records_.add(v, i);
    }
  }
  for (const int v : affectedVertices_.list())
    if (lists_[v].size() > 1) equalizeTies(lists_[v]);
  changedLabels_.insert(changedLabels_.end(), labels.begin(), labels.end());
  makeSet(changedLabels_);
}

bool SiteDistances::close() {
  if (isUnbounded_) return false;
  std::vector<Requirement> found;
  for (const int f : changedFaces_.list())
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const auto atTail = lists_[mesh_.tail(h)], atTip = lists_[mesh_.tip(h)];
      if (atTail.size() < 2 || atTip.size() < 2) continue;
      const auto atApex = lists_[mesh_.tail(TriangleMesh::previous(h))];
      for (const LabelledDistance& d : atTail) {
        const auto isIt = [&](const LabelledDistance& other) { return other.label == d.label; };
        if (std::any_of(atApex.begin(), atApex.end(), isIt)) continue;
        const auto tip = std::find_if(atTip.begin(), atTip.end(), isIt);
        if (tip == atTip.end() || has(f, d.label)) continue;
        if (ownsPartOfEdge(d.label, h)) found.push_back({d.label, f});
      }
    }
  for (const Requirement& r : found) {
    if (has(r.face, r.label)) continue;
    if (faceLabels_.empty(r.face))
      faceLabels_.add(r.face, {bounds_[mesh_.tail(3 * r.face)].label, false});
    faceLabels_.add(r.face, {r.label, true});
    requirements_.push_back(r);
  }
  return !requirements_.empty();
}

bool SiteDistances::ownsPartOfEdge(int label, int h) const {
  constexpr double kRounding = 1e-9;
  const auto find = [&](int v, int l) {
    for (const LabelledDistance& d : lists_[v])
      if (d.label == l) return d.distance;
    return kInfinity;
  };
  const int tail = mesh_.tail(h), tip = mesh_.tip(h);
  const double atTail = find(tail, label), atTip = find(tip, label);
  double from = 0, to = 1;
  const auto yieldTo = [&](int other) {
    if (other == label) return true;
    const double otherAtTail = find(tail, other), otherAtTip = find(tip, other);
    if (otherAtTail == kInfinity || otherAtTip == kInfinity) return true;
    const double lagAtTail = (atTail - otherAtTail) * (atTail + otherAtTail);
    const double lagAtTip = (atTip - otherAtTip) * (atTip + otherAtTip);
    const bool isBehindAtTail = lagAtTail > 0 || (lagAtTail == 0 && other < label);
    const bool isBehindAtTip = lagAtTip > 0 || (lagAtTip == 0 && other < label);
    if (isBehindAtTail && isBehindAtTip) return false;
    if (isBehindAtTail == isBehindAtTip) return true;
    const double tie = lagAtTail / (lagAtTail - lagAtTip);
    if (isBehindAtTail)
      from = std::max(from, tie);
    else
      to = std::min(to, tie);
    return from <= to + kRounding;
  };
  for (const int side : {h, mesh_.twin(h)}) {
    if (side < 0) continue;
    const int f = side / 3;
    if (faceLabels_.empty(f) && !yieldTo(bounds_[tail].label)) return false;
    for (const FaceLabel& l : faceLabels_[f])
      if (!l.isByClosure && !yieldTo(l.label)) return false;
  }
  return true;
}

double SiteDistances::progress() const {
  if (stage_ == Stage::kDone) return 1;
  const double labels = static_cast<double>(started_.size() + resumed_.size());
  switch (stage_) {
    case Stage::kBounds:
      return 0;
    case Stage::kSpread:
      return 0.05 + 0.55 * static_cast<double>(cursor_) / labels;
    case Stage::kRequire:
      return 0.65 + 0.3 * static_cast<double>(cursor_) /
                        static_cast<double>(std::max<size_t>(1, requirements_.size()));
    default:
      return 0.6;
  }
}

LabelledDistance SiteDistances::nearest(const SurfacePoint& p) const {
  const Incidence place = incidenceOf(p.bary);
  if (place.corner >= 0) return nearestOf(at(mesh_.tail(3 * p.face + place.corner)));
  LabelledDistance best;
  const auto consider = [&](int label) { lower(best, label, distance(label, p)); };
  if (faceLabels_.empty(p.face)) {
    if (const int label = bounds_[mesh_.tail(3 * p.face)].label; label >= 0) consider(label);
  } else {
    for (const FaceLabel& l : faceLabels_[p.face])
      if (!l.isByClosure) consider(l.label);
  }
  return best;
}

double SiteDistances::distance(int label, const SurfacePoint& p) const {
  const auto valueAt = [&](int corner) {
    for (const LabelledDistance& d : at(mesh_.tail(3 * p.face + corner)))
      if (d.label == label) return d.distance;
    return kInfinity;
  };
  const Incidence place = incidenceOf(p.bary);
  if (place.corner >= 0) return valueAt(place.corner);
  double least = kInfinity;
  const auto sides = squaredSides(mesh_, p.face);
  for (int i = 0; i < 3; ++i) {
    const double atCorner = valueAt(i);
    if (atCorner == kInfinity) {
      if (p.bary[i] > 0) return kInfinity;
      continue;
    }
    least = std::min(least, atCorner + std::sqrt(squaredDistance(
                                           p.bary, Eigen::Vector3d::Unit(i), sides)));
  }
  return std::min(least, spread_->distance(label, p));
}

Eigen::Vector2d SiteDistances::direction(int label, int vertex) const {
  const auto known = at(vertex);
  for (size_t i = 0; i < known.size(); ++i)
    if (known[i].label == label) return spread_->direction(label, records_[vertex][i]);
  return DistanceField::direction(label, vertex);
}

}  // namespace gvd
