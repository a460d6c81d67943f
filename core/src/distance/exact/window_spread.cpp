// SPDX-License-Identifier: MIT
#include "distance/exact/window_spread.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/plane.h"
namespace gvd::exact {

WindowSpread::WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                           SpreadTo startTo)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      startTo_(startTo),
      sweep_(mesh, bounds),
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

void WindowSpread::require(int label, std::span<RequiredPoint> points) {
  LabelWindows& windows = labels_[label];
  const size_t crossedBefore = windows.crossed.size();
  sweep_.require(label, windows, points);
  long unlimited = std::numeric_limits<long>::max();
  sweep_.run(unlimited);
  addEntries(label, crossedBefore);
  for (size_t i = 0; i < points.size(); ++i)
    points[i].distance = sweep_.distanceAtPoint(static_cast<int>(i));
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

void WindowSpread::appendLabelsInside(int face, std::vector<int>& labels) const {
  for (int h = 3 * face; h < 3 * face + 3; ++h)
    for (int e = firstEntry_[h]; e >= 0; e = entries_[e].next) labels.push_back(entries_[e].label);
  for (const FaceSite& site : sites_.inFace(face)) labels.push_back(site.label);
}

double WindowSpread::distance(int label, const SurfacePoint& p,
                              const std::array<double, 3>& atCorners) const {
  double least = kInfinity;
  const TriangleMesh::Face& face = mesh_.face(p.face);
  for (int i = 0; i < 3; ++i) {
    least =
        std::min(least, atCorners[i] + layOut(face, 0, p.bary - Eigen::Vector3d::Unit(i)).norm());
    for (int e = firstEntry_[3 * p.face + i]; e >= 0; e = entries_[e].next) {
      if (entries_[e].label != label) continue;
      const Eigen::Vector2d q = layOut(face, i, p.bary);
      labels_[label].visitWindows(entries_[e].firstBlock, [&](const Window& w) {
        least = std::min(least, w.distance(q.x(), q.y()));
      });
    }
  }
  for (const FaceSite& site : sites_.inFace(p.face))
    if (site.label == label) least = std::min(least, layOut(face, 0, p.bary - site.bary).norm());
  return least;
}

Eigen::Vector2d WindowSpread::direction(int label, int index) const {
  const LastPiece& piece = labels_[label].pieces[index];
  if (piece.arrival < 0) return {1, 0};
  if (piece.sourceDistance > 0) return unitVector(piece.direction);
  const TriangleMesh::Face& face = mesh_.face(piece.arrival / 3);
  const int i = piece.arrival % 3;
  const Eigen::Vector2d toApex = apexOf(face, i) - Eigen::Vector2d(piece.crossing, 0);
  return turnedBy(toApex.normalized(), unitVector(piece.direction));
}

}  // namespace gvd::exact
