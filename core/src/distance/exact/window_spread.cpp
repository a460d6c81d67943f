// SPDX-License-Identifier: MIT
#include "distance/exact/window_spread.h"

#include <algorithm>
#include <cmath>

#include "base/plane.h"
namespace gvd::exact {

WindowSpread::WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                           SpreadTo startTo)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      startTo_(startTo),
      faces_(layOutFaces(mesh)),
      sweep_(mesh, faces_, bounds),
      firstEntry_(mesh.halfedgeCount(), -1) {}

void WindowSpread::start(int label) {
  if (label >= static_cast<int>(labels_.size())) labels_.resize(label + 1);
  label_ = label;
  crossedBefore_ = 0;
  sweep_.start(label, sites_[label], startTo_, labels_[label]);
}

void WindowSpread::resume(int label) {
  label_ = label;
  crossedBefore_ = labels_[label].crossed.size();
  sweep_.resume(label, labels_[label]);
}

void WindowSpread::require(int label, std::span<const int> faces) {
  label_ = label;
  crossedBefore_ = labels_[label].crossed.size();
  sweep_.require(label, labels_[label], faces);
}

bool WindowSpread::run(long& budget) {
  if (!sweep_.run(budget)) return false;
  addEntries(label_, crossedBefore_);
  return true;
}

void WindowSpread::addEntries(int label, size_t firstCrossed) {
  const LabelWindows& windows = labels_[label];
  for (const CrossedHalfedge& c : std::span(windows.crossed).subspan(firstCrossed)) {
    int& first = firstEntry_[c.halfedge];
    const Entry entry = {label, c.firstBlock, first};
    if (freeEntries_.empty()) {
      first = static_cast<int>(entries_.size());
      entries_.push_back(entry);
    } else {
      first = freeEntries_.back();
      freeEntries_.pop_back();
      entries_[first] = entry;
    }
  }
}

void WindowSpread::remove(int label) {
  for (const CrossedHalfedge& c : labels_[label].crossed)
    for (int* link = &firstEntry_[c.halfedge]; *link >= 0;) {
      if (entries_[*link].label == label) {
        freeEntries_.push_back(*link);
        *link = entries_[*link].next;
      } else {
        link = &entries_[*link].next;
      }
    }
  labels_[label] = {};
}

void WindowSpread::appendPartlyOwned(int label, const std::function<bool(int face)>& isCandidate,
                                     std::vector<int>& faces) const {
  const LabelWindows& known = labels_[label];
  for (const CrossedHalfedge& c : known.crossed) {
    const int f = c.halfedge / 3, i = c.halfedge % 3;
    const FaceLayout& face = faces_[f];
    if (!isCandidate(f)) continue;
    const EdgeDistances nearest = {bounds_[face.vertex[i]].distance,
                                   bounds_[face.vertex[FaceLayout::after(i)]].distance};
    bool ownsPart = false;
    known.visitWindows(c.firstBlock, [&](Window w) {
      if (ownsPart) return;
      trim(w, face.length[i], nearest);
      ownsPart = w.begin < w.end;
    });
    if (ownsPart) faces.push_back(f);
  }
}

double WindowSpread::distance(int label, const SurfacePoint& p) const {
  double least = kInfinity;
  const FaceLayout& face = faces_[p.face];
  for (int i = 0; i < 3; ++i)
    for (int e = firstEntry_[3 * p.face + i]; e >= 0; e = entries_[e].next) {
      if (entries_[e].label != label) continue;
      const Eigen::Vector2d q = face.at(i, p.bary);
      labels_[label].visitWindows(entries_[e].firstBlock, [&](const Window& w) {
        least = std::min(least, w.distance(q.x(), q.y()));
      });
    }
  for (const FaceSite& site : sites_.inFace(p.face))
    if (site.label == label) least = std::min(least, face.at(0, p.bary - site.bary).norm());
  return least;
}

Eigen::Vector2d WindowSpread::direction(int label, int index) const {
  const LastPiece& piece = labels_[label].pieces[index];
  if (piece.arrival < 0) return {1, 0};
  if (piece.sourceDistance > 0) return unitVector(piece.direction);
  const FaceLayout& face = faces_[piece.arrival / 3];
  const int i = piece.arrival % 3;
  const Eigen::Vector2d toApex(face.apexX(i) - piece.crossing, face.apexY(i));
  return turnedBy(toApex.normalized(), unitVector(piece.direction));
}

}  // namespace gvd::exact
