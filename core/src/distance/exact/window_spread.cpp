// SPDX-License-Identifier: MIT
#include "distance/exact/window_spread.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/plane.h"
#include "distance/exact/window_path.h"
#include "distance/known_labels.h"
#include "mesh/surface_geometry.h"

namespace gvd::exact {

namespace {

double leastDistance(std::span<const FirstPiece> pieces) {
  double least = kInfinity;
  for (const FirstPiece& piece : pieces) least = std::min(least, piece.distance);
  return least;
}

}  // namespace

WindowSpread::WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
                           SpreadTo startTo)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      startTo_(startTo),
      sweep_(mesh, bounds),
      search_(mesh, sites),
      index_(mesh.vertexCount()) {}

// --- At vertices -------------------------------------------------------------------------------

LabelState& WindowSpread::begin(int label) {
  if (label >= static_cast<int>(labels_.size())) labels_.resize(label + 1);
  return labels_[label];
}

void WindowSpread::start(int label) {
  sweep_.start(label, sites_[label], startTo_, begin(label));
}

void WindowSpread::resume(int label) { sweep_.resume(label, begin(label)); }

void WindowSpread::require(int label, std::span<const int> faces) {
  sweep_.require(label, begin(label), faces);
}

void WindowSpread::remove(int label) {
  labels_[label] = {};
  found_.remove(label);
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

// --- At other points ---------------------------------------------------------------------------

/// The distances of the nearest labels.
class WindowSpread::NearestLabels final : public VertexDistances {
 public:
  explicit NearestLabels(const NearestBounds& bounds) : bounds_(bounds) {}
  double atLeast(int v) const override { return bounds_[v].distance; }
  double atMost(int v) const override { return bounds_[v].distance; }

 private:
  const NearestBounds& bounds_;
};

/// The distances of one label: where they are not final, it is not nearer than the nearest.
class WindowSpread::OneLabel final : public VertexDistances {
 public:
  OneLabel(const LabelState& label, const ReachedIndex& index, const NearestBounds& bounds,
           bool isFinal)
      : label_(label), index_(index), bounds_(bounds), isFinal_(isFinal) {}
  double atLeast(int v) const override {
    const int i = index_[v];
    return i >= 0 && (isFinal_ || label_.vertices[i].isFinal) ? label_.vertices[i].distance
                                                              : bounds_[v].distance;
  }
  double atMost(int v) const override {
    return index_[v] < 0 ? kInfinity : label_.vertices[index_[v]].distance;
  }

 private:
  const LabelState& label_;
  const ReachedIndex& index_;
  const NearestBounds& bounds_;
  const bool isFinal_;  ///< everywhere
};

std::vector<LabelledDistance> WindowSpread::nearestAt(const SurfacePoint& p,
                                                      const KnownLabels& known) {
  std::vector<LabelledDistance> labels;
  const auto offer = [&](int label, double distance) {
    const auto found = std::find_if(labels.begin(), labels.end(), [&](const LabelledDistance& d) {
      return d.label == label;
    });
    if (found == labels.end())
      labels.push_back({label, distance});
    else
      found->distance = std::min(found->distance, distance);
  };
  for (const FirstPiece& piece : search_.run(p, -1, NearestLabels(bounds_))) {
    if (piece.label >= 0)
      offer(piece.label, piece.length);
    else
      for (const LabelledDistance& d : known[piece.vertex])
        offer(d.label, piece.length + d.distance);
  }
  return labels;
}

std::unique_ptr<SlicedWork<std::vector<double>>> WindowSpread::startDistancesAt(
    std::vector<LabelledPoint> points, const KnownLabels& /*known*/) {
  return std::make_unique<PointDistances>(mesh_, sites_, bounds_, startTo_, found_,
                                          std::move(points));
}

/// The path to a point leads through windows that have crossed their faces, which is searched for;
/// or, where another label is nearer, through one that has stopped, which goes on to the point.
std::vector<SurfacePoint> WindowSpread::path(int label, const SurfacePoint& p) {
  const LabelState& known = labels_[label];
  index_.reset(known.vertices);
  if (vertexAt(mesh_, p) >= 0) return pathToSite(mesh_, sites_[label], known, index_, {}, p);
  const bool isFinal = startTo_ == SpreadTo::kEverywhere;
  const double nearest = leastDistance(search_.run(p, -1, NearestLabels(bounds_)));
  const auto& found = search_.run(p, label, OneLabel(known, index_, bounds_, isFinal));
  if (isFinal || isAtMost(leastDistance(found), nearest))
    return pathToSite(mesh_, sites_[label], known, index_, found, p);
  LabelState state = known;
  const RequiredPoint point = {p, leastDistance(found), nearest};
  sweep_.require(label, state, {&point, 1});
  long unlimited = std::numeric_limits<long>::max();
  sweep_.run(unlimited);
  index_.reset(state.vertices);
  return pathToSite(mesh_, sites_[label], state, index_,
                    search_.run(p, label, OneLabel(state, index_, bounds_, isFinal)), p);
}

}  // namespace gvd::exact
