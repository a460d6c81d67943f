// SPDX-License-Identifier: MIT
#include "distance/exact/window_spread.h"

#include <algorithm>
#include <utility>

#include "base/plane.h"
#include "base/sliced_loop.h"
#include "distance/exact/window_path.h"
#include "distance/path_points.h"
#include "distance/reached_index.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd::exact {
namespace {

/// How much longer than its distance a path may be by rounding, as a share: less than can be seen,
/// and more than all vertices of a path add, each by `kSameLength` (window_path.cpp) at most.
constexpr double kPathRounding = 1e-9;

}  // namespace

WindowSpread::WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      sweep_(mesh, sites, bounds),
      index_(mesh.vertexCount()) {}

// --- At vertices -------------------------------------------------------------------------------

LabelState& WindowSpread::stateOf(int label) {
  if (label >= static_cast<int>(labels_.size())) labels_.resize(label + 1);
  return labels_[label];
}

void WindowSpread::start(int label) { sweep_.start(label, stateOf(label)); }

void WindowSpread::resume(int label) { sweep_.resume(label, stateOf(label)); }

long WindowSpread::require(int label, std::span<const int> faces) {
  return sweep_.require(label, stateOf(label), faces);
}

void WindowSpread::markFinal(int label, int index) {
  labels_[label].vertices[index].isFinal = true;
  sweep_.forget();
}

void WindowSpread::remove(std::span<const int> labels) {
  for (const int label : labels) {
    labels_[label] = {};
    found_.remove(label);
  }
}

Eigen::Vector2d WindowSpread::direction(int label, int index) const {
  const LastPiece& piece = labels_[label].pieces[index];
  if (piece.isAtSite()) return {1, 0};
  if (!piece.isFromSite()) return unitVector(piece.direction);
  const TriangleMesh::Face& face = mesh_.face(piece.arrival / 3);
  const int i = piece.arrival % 3;
  const Eigen::Vector2d toApex(-piece.fromFoot, apexOf(face, i).y());
  return turnedBy(toApex.normalized(), unitVector(piece.direction));
}

// --- At other points ---------------------------------------------------------------------------

/// The distances of the nearest labels.
class WindowSpread::NearestLabels final : public SearchBounds {
 public:
  explicit NearestLabels(const NearestBounds& bounds) : bounds_(bounds) {}
  double atLeast(int v) const override { return bounds_[v].distance; }
  double atMost(int v) const override { return bounds_[v].distance; }
  bool isSought(int /*label*/) const override { return true; }

 private:
  const NearestBounds& bounds_;
};

/// Bounds for one label. Where its distance is not final, the nearest distance is the lower bound.
class WindowSpread::OneLabel final : public SearchBounds {
 public:
  OneLabel(int label, const LabelState& state, const IndexMap& index, const NearestBounds& bounds)
      : label_(label), state_(state), index_(index), bounds_(bounds) {}
  double atLeast(int v) const override {
    const int i = index_[v];
    return i >= 0 && state_.vertices[i].isFinal ? state_.vertices[i].distance : bounds_[v].distance;
  }
  double atMost(int v) const override { return distanceIn(state_.vertices, index_, v); }
  bool isSought(int label) const override { return label == label_; }

 private:
  const int label_;
  const LabelState& state_;
  const IndexMap& index_;
  const NearestBounds& bounds_;
};

std::vector<LabelledDistance> WindowSpread::nearestAt(const SurfacePoint& p,
                                                      const DistanceField& known, long& budget) {
  std::vector<LabelledDistance> labels;
  const LabelState fromPoint = sweep_.search(p, NearestLabels(bounds_), budget);
  for (const LabelledDistance& site : sweep_.searched().found()) labels.push_back(site);
  for (const ReachedVertex& r : fromPoint.vertices)
    if (bounds_.ties().isAtMost(r.distance + bounds_[r.vertex].distance,
                                sweep_.searched().shortest()))
      for (const LabelledDistance& d : known.at(r.vertex))
        labels.push_back({d.label, r.distance + d.distance});
  return labels;
}

std::unique_ptr<SlicedWork<std::vector<double>>> WindowSpread::startDistancesAt(
    std::vector<LabelledPoint> points, const DistanceField& /*known*/) {
  return std::make_unique<PointDistances>(mesh_, sites_, bounds_, found_, spare_,
                                          std::move(points));
}

/// A new search for the path if that followed back is too long: where faces are as thin as
/// rounding, a line may pass a vertex on the wrong side, and then misses its source.
std::vector<SurfacePoint> WindowSpread::path(int label, const SurfacePoint& p) {
  FoundPath found = followedBack(label, p);
  return pathOrShortest(mesh_, std::move(found.points), (1 + kPathRounding) * found.distance, p,
                        sites_[label]);
}

/// Windows that have crossed their faces are not kept, so a search from the point finds paths
/// through them (`pathBack`). Where another label is nearer, the path may lead through a waiting
/// window instead, which then spreads on to the point.
WindowSpread::FoundPath WindowSpread::followedBack(int label, const SurfacePoint& p) {
  const LabelState& state = labels_[label];
  if (const int vertex = vertexAt(mesh_, p); vertex >= 0)
    return {pathToSite(mesh_, sites_[label], state, p, index_),
            distanceIn(state.vertices, index_, vertex)};
  long budget = kUnlimited;
  sweep_.search(p, NearestLabels(bounds_), budget);
  const double nearest = sweep_.searched().shortest();
  std::vector<SurfacePoint> path = pathBack(p, label, state);
  const double least = sweep_.searched().shortest();
  if (bounds_.ties().isAtMost(least, nearest)) return {std::move(path), least};
  LabelState further = state;
  const RequiredPoint point = {p, least, nearest};
  sweep_.require(label, further, {&point, 1});
  budget = kUnlimited;
  sweep_.step(budget);
  const double distance = sweep_.distanceAtPoint(0);
  if (bounds_.ties().isAtMost(least, distance)) return {std::move(path), least};
  return {pathToSite(mesh_, sites_[label], further, p, index_), distance};
}

/// The shortest path from a point through windows by which a label has crossed faces: straight to
/// the site or to a vertex, found by a search that starts at the point, and on from there.
std::vector<SurfacePoint> WindowSpread::pathBack(const SurfacePoint& p, int label,
                                                 const LabelState& state) {
  indexVertices(state.vertices, index_);
  const OneLabel ofLabel(label, state, index_, bounds_);
  long budget = kUnlimited;
  const LabelState fromPoint = sweep_.search(p, ofLabel, budget);
  int vertex = -1;
  double least = kInfinity;
  for (const LabelledDistance& site : sweep_.searched().found())
    least = std::min(least, site.distance);
  for (const ReachedVertex& r : fromPoint.vertices)
    if (r.distance + ofLabel.atMost(r.vertex) < least) {
      least = r.distance + ofLabel.atMost(r.vertex);
      vertex = r.vertex;
    }
  const bool endsAtSite = vertex < 0 || ofLabel.atMost(vertex) == 0;
  const SurfacePoint end = endsAtSite ? sites_[label] : pointAtVertex(mesh_, vertex);
  std::vector<SurfacePoint> path = pathToSite(mesh_, p, fromPoint, end, index_);
  std::reverse(path.begin(), path.end());
  if (endsAtSite || path.empty()) return path;
  const auto rest = pathToSite(mesh_, sites_[label], state, end, index_);
  if (rest.empty()) return {};
  path.pop_back();
  path.insert(path.end(), rest.begin(), rest.end());
  return path;
}

}  // namespace gvd::exact
