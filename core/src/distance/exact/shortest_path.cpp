// SPDX-License-Identifier: MIT
//
// The shortest path between two points.
#include <algorithm>
#include <memory>
#include <vector>

#include "base/index_map.h"
#include "base/sliced_loop.h"
#include "distance/edge_bounds.h"
#include "distance/exact/label_state.h"
#include "distance/exact/window_path.h"
#include "distance/exact/window_sweep.h"
#include "distance/nearest_bounds.h"
#include "distance/path_points.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "mesh/given_points.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

using exact::LabelState;
using exact::WindowSweep;

constexpr int kLabel = 0;

/// By how much, relatively, a straight path may be longer than one along edges: in needles, lengths
/// round by a ten-thousandth.
constexpr double kSlack = 1e-3;

/// Windows spread from one end until none can reach the other end by a shorter path. The length of
/// a path along edges bounds that of the shortest one from the beginning, so that windows spread
/// through little more than an ellipse around the two ends.
class PathSearch final : public SlicedWork<std::vector<SurfacePoint>> {
 public:
  PathSearch(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to)
      : mesh_(mesh),
        from_(from),
        to_(to),
        straight_((mesh.position(from) - mesh.position(to)).norm()),
        end_(mesh),
        edgeBounds_(mesh, end_),
        nearest_(mesh, 0),
        sweep_(mesh, end_, nearest_) {}

  bool advance(long budget) override {
    const bool isConnected = mesh_.component(from_.face) == mesh_.component(to_.face);
    return !isConnected || sequence_.run(
                               [&] {
                                 return end_.prepare(budget) && edgeBounds_.prepare(budget) &&
                                        nearest_.prepare(budget) && sweep_.prepare(budget);
                               },
                               [&] {
                                 end_.insert(kLabel, to_);
                                 edgeBounds_.insert(kLabel);
                               },
                               [&] { return boundByEdges(budget); },
                               [&] { startSearch(mostByEdges() * (1 + kSlack)); },
                               [&] { return sweep_.step(budget); });
  }

  /// The wavefront's distance as a share of the straight line in space.
  double share() const override {
    return straight_ > 0 ? std::min(sweep_.front() / straight_, 0.9) : 0;
  }

  std::vector<SurfacePoint> result() override {
    IndexMap index(mesh_.vertexCount());
    return exact::pathToSite(mesh_, to_, state_, from_, index);
  }

 private:
  /// Finds the lengths of paths along edges, as far as they may be shortest at the other end.
  bool boundByEdges(long& budget) {
    constexpr long kVertices = 64;
    while (budget > 0) {
      long rest = std::min(budget, kVertices);
      budget -= rest;
      if (edgeBounds_.step(rest) || edgeBounds_.front() > mostByEdges()) return true;
    }
    return false;
  }

  /// The length of the shortest path over a corner of the face, and then along edges.
  double mostByEdges() const {
    const int vertex = vertexAt(mesh_, from_);
    if (vertex >= 0) return edgeBounds_[vertex];
    return distanceOverCorners(mesh_, from_, [&](int v) { return edgeBounds_[v]; });
  }

  /// Searches for paths of at most this length.
  void startSearch(double most) {
    sweep_.startWaiting(kLabel, state_);
    long budget = kUnlimited;
    sweep_.step(budget);
    const exact::RequiredPoint point = {from_, most, 0};
    if (const int vertex = vertexAt(mesh_, from_); vertex >= 0)
      sweep_.require(kLabel, state_, {&from_.face, 1}, most + mesh_.longestEdge(vertex));
    else
      sweep_.require(kLabel, state_, {&point, 1});
  }

  const TriangleMesh& mesh_;
  const SurfacePoint from_, to_;
  const double straight_;  ///< the distance of the two ends in space
  SiteSet end_;            ///< `to_` alone
  EdgeBounds edgeBounds_;
  NearestBounds nearest_;  ///< zero: there are no other labels to compare with
  WindowSweep sweep_;
  LabelState state_;

  SlicedSequence sequence_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startShortestPath(const TriangleMesh& mesh,
                                                                         const SurfacePoint& from,
                                                                         const SurfacePoint& to) {
  return std::make_unique<PathSearch>(mesh, onMesh(mesh, from, "the start of the path: "),
                                      onMesh(mesh, to, "the end of the path: "));
}

std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& from,
                                       const SurfacePoint& to) {
  return finished(startShortestPath(mesh, from, to));
}

}  // namespace gvd
