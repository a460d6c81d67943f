// SPDX-License-Identifier: MIT
#include "distance/exact/window_spread.h"

#include <algorithm>
#include <cmath>

#include "base/plane.h"
#include "distance/face_owners.h"
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

void WindowSpread::appendEntered(int label, const FaceOwners& owners,
                                 std::vector<int>& faces) const {
  const LabelWindows& known = labels_[label];
  for (const CrossedHalfedge& c : known.crossed) {
    const int f = c.halfedge / 3;
    if (owners.has(f, label)) continue;
    bool ownsPart = false;
    known.visitWindows(c.firstBlock, [&](const Window& w) {
      ownsPart = ownsPart || ownsPartOf(w, label, c.halfedge);
    });
    if (ownsPart) faces.push_back(f);
  }
}

/// Whether a label is nearer than all others somewhere on one of its windows. Along an edge distances are
/// 1-Lipschitz: where another label is ahead by more than the width of an interval, it is so on all
/// of it. Parts that are narrower than a share of the edge may be missed: a diagram with straight
/// bisectors shows nothing of them.
bool WindowSpread::ownsPartOf(const Window& window, int label, int h) const {
  constexpr double kNarrowest = 1e-3, kRounding = 1e-9;
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  const int i = h % 3;
  const double length = face.lengths[i];
  Window w = window;
  trim(w, length, {bounds_[face.vertices[i]].distance,
                   bounds_[face.vertices[cornerAfter(i)]].distance});
  struct Interval {
    double begin, end;
  };
  std::vector<Interval> intervals = {{w.begin, w.end}};
  while (!intervals.empty()) {
    const auto [begin, end] = intervals.back();
    intervals.pop_back();
    if (!(end - begin > kNarrowest * length)) continue;
    const double middle = (begin + end) / 2;
    const double lead = leastOfOthers(label, h, middle) - w.distanceOnEdge(middle);
    if (lead > kRounding * length) return true;
    if (lead + (end - begin) <= kRounding * length) continue;
    intervals.push_back({begin, middle});
    intervals.push_back({middle, end});
  }
  return false;
}

/// The least distance of all labels but one at a place on a halfedge.
double WindowSpread::leastOfOthers(int label, int h, double at) const {
  double least = kInfinity;
  const auto consider = [&](int halfedge, double place) {
    const int f = halfedge / 3, i = halfedge % 3;
    const TriangleMesh::Face& face = mesh_.face(f);
    Eigen::Vector3d bary = Eigen::Vector3d::Zero();
    bary[cornerAfter(i)] = place / face.lengths[i];
    bary[i] = 1 - bary[cornerAfter(i)];
    for (int k = 0; k < 3; ++k) {
      const LabelledDistance& nearest = bounds_[face.vertices[k]];
      if (nearest.label != label)
        least = std::min(least, nearest.distance +
                                    layOut(face, 0, bary - Eigen::Vector3d::Unit(k)).norm());
    }
    for (int side = 0; side < 3; ++side)
      for (int e = firstEntry_[3 * f + side]; e >= 0; e = entries_[e].next) {
        if (entries_[e].label == label) continue;
        const Eigen::Vector2d q = layOut(face, side, bary);
        labels_[entries_[e].label].visitWindows(entries_[e].firstBlock, [&](const Window& w) {
          least = std::min(least, w.distance(q.x(), q.y()));
        });
      }
    for (const FaceSite& site : sites_.inFace(f))
      if (site.label != label) least = std::min(least, layOut(face, 0, bary - site.bary).norm());
  };
  consider(h, at);
  if (const int twin = mesh_.twin(h); twin >= 0) consider(twin, mesh_.length(h) - at);
  return least;
}

double WindowSpread::distance(int label, const SurfacePoint& p,
                              const std::array<double, 3>& atCorners) const {
  double least = kInfinity;
  const TriangleMesh::Face& face = mesh_.face(p.face);
  for (int i = 0; i < 3; ++i) {
    least = std::min(least,
                     atCorners[i] + layOut(face, 0, p.bary - Eigen::Vector3d::Unit(i)).norm());
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
