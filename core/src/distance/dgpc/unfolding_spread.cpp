// SPDX-License-Identifier: MIT
#include "distance/dgpc/unfolding_spread.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sliced_loop.h"
#include "distance/dgpc/unfolding_path.h"
#include "distance/labelled_distances.h"
#include "distance/path_points.h"
#include "distance/reached_index.h"
#include "mesh/face_metric.h"

namespace gvd::dgpc {
namespace {

/// How much longer than its distance a path may be, as a share: more than most errors of distances
/// (a few per cent where paths bend), and less than a detour that can be seen.
constexpr double kMostDetour = 0.1;

}  // namespace

UnfoldingSpread::UnfoldingSpread(const TriangleMesh& mesh, const SiteSet& sites,
                                 NearestBounds& bounds)
    : mesh_(mesh), sites_(sites), bounds_(bounds), sweep_(mesh), index_(mesh.vertexCount()) {}

void UnfoldingSpread::start(int label) {
  if (label >= static_cast<int>(labels_.size())) labels_.resize(label + 1);
  running_ = label;
  sweep_.start(sites_[label]);
}

/// Does nothing: other labels never stop a label of this metric.
void UnfoldingSpread::resume(int /*label*/) {}

bool UnfoldingSpread::step(long& budget) {
  while (running_ >= 0) {
    if (!sweep_.step(budget)) return false;
    if (sweep_.reach())
      takeRequired();
    else
      store();
  }
  return true;
}

/// Indexes the vertices of a label, unless they are indexed already.
void UnfoldingSpread::index(int label) {
  if (indexed_ == label) return;
  indexed_ = -1;  // if memory runs out
  indexVertices(labels_[label].vertices, index_);
  indexed_ = label;
}

void UnfoldingSpread::store() {
  const int label = std::exchange(running_, -1);
  LabelState& state = labels_[label];
  state.vertices.reserve(sweep_.reached().size());
  state.directions.reserve(sweep_.reached().size());
  for (const int v : sweep_.reached()) {
    state.vertices.push_back({v, false, sweep_.distance(v)});
    state.directions.push_back(sweep_.direction(v));
    bounds_.lower(v, label, sweep_.distance(v));
  }
  state.sweptCount = static_cast<int>(state.vertices.size());
}

void UnfoldingSpread::remove(std::span<const int> labels) {
  indexed_ = -1;
  for (const int label : labels) labels_[label] = {};
}

// --- Required distances ------------------------------------------------------------------------

long UnfoldingSpread::require(int label, std::span<const int> faces) {
  LabelState& state = labels_[label];
  const size_t unindexed = indexed_ == label ? 0 : state.vertices.size();
  index(label);
  bool isAllKnown = true;
  for (const int f : faces)
    for (const int v : mesh_.face(f).vertices) {
      if (index_[v] < 0) requireVertex(state, v);
      ReachedVertex& required = state.vertices[index_[v]];
      required.isFinal = true;
      isAllKnown &= required.distance < kInfinity;
    }
  if (!isAllKnown) {
    running_ = label;
    sweep_.start(sites_[label], mesh_.shortEdgeLength());
  }
  return static_cast<long>(unindexed + faces.size());
}

/// Adds a vertex that the sweep has not reached, and unfolds its distance from the neighbours as in
/// the sweep. Uses only neighbours that the sweep has reached, so that the result does not depend
/// on what else is required.
void UnfoldingSpread::requireVertex(LabelState& state, int vertex) {
  ReachedVertex required = {vertex, true, kInfinity};
  Eigen::Vector2d direction(1, 0);
  const auto sweptDistance = [&](int v) {
    const int i = index_[v];
    return i >= 0 && i < state.sweptCount ? state.vertices[i].distance : kInfinity;
  };
  const auto offer = [&](double distance, int from) {
    if (!(distance < required.distance)) return;
    required.distance = distance;
    direction = state.directions[index_[from]];
  };
  for (const int h : mesh_.fan(vertex)) {
    const TriangleMesh::Face& face = mesh_.face(TriangleMesh::faceOf(h));
    const int k = h % 3, i = cornerAfter(k), j = cornerBefore(k);
    const int tail = face.vertices[i], tip = face.vertices[j];
    const double atTail = sweptDistance(tail), atTip = sweptDistance(tip);
    if (const auto unfolding = unfold(face, i, atTail, atTip, required.distance))
      offer(unfolding->toApex.norm(), atTail < atTip ? tail : tip);
    offer(atTail + face.lengths[k], tail);
    offer(atTip + face.lengths[j], tip);
  }
  state.vertices.push_back(required);
  state.directions.push_back(direction);
  index_.add(vertex, static_cast<int>(state.vertices.size()) - 1);
}

/// Required vertices may have no swept neighbour where edges are much longer than distances. Their
/// distances come from sweeps that reach twice as far each time, whatever the bounds are. A vertex
/// gets its distance from the first that reaches beyond it, so that the result does not depend on
/// what else is required. Takes the distances from such a sweep, and begins the next one if some
/// are still missing.
void UnfoldingSpread::takeRequired() {
  const double reach = *sweep_.reach();
  LabelState& state = labels_[running_];
  bool isMissing = false;
  for (size_t i = state.sweptCount; i < state.vertices.size(); ++i) {
    ReachedVertex& r = state.vertices[i];
    if (r.distance < kInfinity) continue;
    if (sweep_.distance(r.vertex) > reach) {
      isMissing = true;
      continue;
    }
    r.distance = sweep_.distance(r.vertex);
    state.directions[i] = sweep_.direction(r.vertex);
  }
  if (isMissing)
    sweep_.start(sites_[running_], 2 * reach);
  else
    running_ = -1;
}

// --- Queries -----------------------------------------------------------------------------------

std::vector<LabelledDistance> UnfoldingSpread::nearestAt(const SurfacePoint& p,
                                                         const DistanceField& known, long& budget) {
  constexpr long kLabelsPerUnit = 8;
  const auto& [a, b, c] = mesh_.face(p.face).vertices;
  std::vector<LabelledDistance> distances;
  visitLabels(known.at(a), known.at(b), known.at(c), [&](int label, const auto& /*at*/) {
    distances.push_back(
        {label, distanceAt(label, p, [&](int v) { return distanceIn(known.at(v), label); })});
  });
  budget -= static_cast<long>(distances.size()) / kLabelsPerUnit;
  return distances;
}

/// Distances at points, interpolated from the corners of their faces.
class UnfoldingSpread::PointDistances final : public SlicedWork<std::vector<double>> {
 public:
  PointDistances(const UnfoldingSpread& spread, const DistanceField& known,
                 std::vector<LabelledPoint> points)
      : spread_(spread), known_(known), points_(std::move(points)) {}

  bool advance(long budget) override {
    constexpr long kPointsPerUnit = 8;
    return loop_.run(points_.size(), budget, kPointsPerUnit, [&](int i) {
      const LabelledPoint& at = points_[i];
      distances_.push_back(spread_.distanceAt(
          at.label, at.point, [&](int v) { return distanceIn(known_.at(v), at.label); }));
    });
  }
  double share() const override { return static_cast<double>(distances_.size()) / points_.size(); }
  std::vector<double> result() override { return std::move(distances_); }

 private:
  const UnfoldingSpread& spread_;
  const DistanceField& known_;
  const std::vector<LabelledPoint> points_;
  std::vector<double> distances_;
  SlicedLoop loop_;
};

std::unique_ptr<SlicedWork<std::vector<double>>> UnfoldingSpread::startDistancesAt(
    std::vector<LabelledPoint> points, const DistanceField& known) {
  return std::make_unique<PointDistances>(*this, known, std::move(points));
}

/// In the plane, the squared distance of a point is the linear interpolant of the corners' squared
/// distances minus a quadratic term that depends on the point alone. Infinity if the label is not
/// known at a corner of the face, or of the side that the point is on.
template <class AtVertex>
double UnfoldingSpread::distanceAt(int label, const SurfacePoint& p, AtVertex atVertex) const {
  const auto sides = squaredSides(mesh_, p.face);
  double inFace = kInfinity;
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) {
    if (site.face == p.face) inFace = std::sqrt(squaredDistance(p.bary, site.bary, sides));
  });
  if (inFace < kInfinity) return inFace;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    if (p.bary[i] > 0) {
      const double atCorner = atVertex(mesh_.tail(3 * p.face + i));
      if (atCorner == kInfinity) return kInfinity;
      squared += p.bary[i] * atCorner * atCorner;
    }
  }
  return std::sqrt(std::max(squared - interpolationExcess(p.bary, sides), 0.0));
}

/// The shortest path by the exact metric, if the one by unfolding is longer than the distance by
/// more than `kMostDetour` or is none: where paths bend on long faces, virtual sources contradict
/// each other.
std::vector<SurfacePoint> UnfoldingSpread::path(int label, const SurfacePoint& p) {
  const LabelState& state = labels_[label];
  index(label);
  const auto atVertex = [&](int v) { return distanceIn(state.vertices, index_, v); };
  const double most = (1 + kMostDetour) * distanceAt(label, p, atVertex);
  return pathOrShortest(mesh_, pathByUnfolding(mesh_, sites_[label], atVertex, p), most, p,
                        sites_[label]);
}

Eigen::Vector2d UnfoldingSpread::direction(int label, int index) const {
  return labels_[label].directions[index];
}

}  // namespace gvd::dgpc
