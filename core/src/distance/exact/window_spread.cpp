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
      firstCrossing_(mesh.faceCount(), -1) {}

// --- At vertices -------------------------------------------------------------------------------

void WindowSpread::begin(int label) {
  if (label >= static_cast<int>(labels_.size())) labels_.resize(label + 1);
  label_ = label;
}

void WindowSpread::start(int label) {
  begin(label);
  sweep_.start(label, sites_[label], startTo_, labels_[label].state);
}

void WindowSpread::resume(int label) {
  begin(label);
  labels_[label].recording.reset();
  sweep_.resume(label, labels_[label].state);
}

void WindowSpread::require(int label, std::span<const int> faces) {
  begin(label);
  sweep_.require(label, labels_[label].state, faces);
}

bool WindowSpread::run(long& budget) {
  if (!sweep_.run(budget)) return false;
  noteCrossedFaces();
  return true;
}

void WindowSpread::noteCrossedFaces() {
  std::vector<int>& crossed = labels_[label_].crossedFaces;
  crossed.reserve(crossed.size() + sweep_.crossedFaces().size());
  for (const int f : sweep_.crossedFaces()) {
    if (firstCrossing_[f] >= 0 && crossings_[firstCrossing_[f]].label == label_) continue;
    crossed.push_back(f);
    const Crossing crossing = {label_, firstCrossing_[f]};
    if (freeCrossings_.empty()) {
      firstCrossing_[f] = static_cast<int>(crossings_.size());
      crossings_.push_back(crossing);
    } else {
      firstCrossing_[f] = freeCrossings_.back();
      freeCrossings_.pop_back();
      crossings_[firstCrossing_[f]] = crossing;
    }
  }
}

void WindowSpread::remove(int label) {
  for (const int f : labels_[label].crossedFaces)
    for (int* link = &firstCrossing_[f]; *link >= 0;) {
      if (crossings_[*link].label == label) {
        freeCrossings_.push_back(*link);
        *link = crossings_[*link].next;
      } else {
        link = &crossings_[*link].next;
      }
    }
  labels_[label] = {};
}

// --- At other points ---------------------------------------------------------------------------

WindowSpread::Recording& WindowSpread::recordingOf(int label) {
  std::unique_ptr<Recording>& recording = labels_[label].recording;
  if (!recording) {
    recording = std::make_unique<Recording>();
    sweep_.start(label, sites_[label], startTo_, recording->state, recording->windows);
    finish(*recording);
  }
  return *recording;
}

void WindowSpread::finish(Recording& recording) {
  long unlimited = std::numeric_limits<long>::max();
  sweep_.run(unlimited);
  recording.windows.sort();
}

void WindowSpread::require(int label, std::span<RequiredPoint> points) {
  Recording& recording = recordingOf(label);
  sweep_.require(label, recording.state, points, &recording.windows);
  finish(recording);
  for (size_t i = 0; i < points.size(); ++i)
    points[i].distance = sweep_.distanceAtPoint(static_cast<int>(i));
}

void WindowSpread::appendLabelsInside(int face, std::vector<int>& labels) const {
  for (int c = firstCrossing_[face]; c >= 0; c = crossings_[c].next)
    labels.push_back(crossings_[c].label);
  for (const FaceSite& site : sites_.inFace(face)) labels.push_back(site.label);
}

double WindowSpread::distance(int label, const SurfacePoint& p,
                              const std::array<double, 3>& atCorners) {
  const Recording& recording = recordingOf(label);
  double least = kInfinity;
  const TriangleMesh::Face& face = mesh_.face(p.face);
  for (int i = 0; i < 3; ++i) {
    least =
        std::min(least, atCorners[i] + layOut(face, 0, p.bary - Eigen::Vector3d::Unit(i)).norm());
    const Eigen::Vector2d q = layOut(face, i, p.bary);
    recording.windows.visit(3 * p.face + i, [&](const Window& w) {
      least = std::min(least, w.distance(q.x(), q.y()));
    });
  }
  for (const FaceSite& site : sites_.inFace(p.face))
    if (site.label == label) least = std::min(least, layOut(face, 0, p.bary - site.bary).norm());
  return least;
}

Eigen::Vector2d WindowSpread::direction(int label, int index) const {
  const LastPiece& piece = labels_[label].state.pieces[index];
  if (piece.arrival < 0) return {1, 0};
  if (piece.sourceDistance > 0) return unitVector(piece.direction);
  const TriangleMesh::Face& face = mesh_.face(piece.arrival / 3);
  const int i = piece.arrival % 3;
  const Eigen::Vector2d toApex = apexOf(face, i) - Eigen::Vector2d(piece.crossing, 0);
  return turnedBy(toApex.normalized(), unitVector(piece.direction));
}

}  // namespace gvd::exact
