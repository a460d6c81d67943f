// SPDX-License-Identifier: MIT
//
// The shortest path between two points.
#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "distance/exact/label_state.h"
#include "distance/exact/window_path.h"
#include "distance/exact/window_sweep.h"
#include "distance/nearest_bounds.h"
#include "gvd/geodesic.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using exact::LabelState;
using exact::SpreadTo;
using exact::WindowSweep;

constexpr int kLabel = 0;

/// Windows spread from one end until none can reach the other end by a shorter path.
class PathSearch final : public SlicedWork<std::vector<SurfacePoint>> {
 public:
  PathSearch(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to)
      : mesh_(mesh),
        from_(from),
        to_(to),
        straight_((mesh.position(from) - mesh.position(to)).norm()),
        nearest_(mesh, 0),
        sweep_(mesh, nearest_) {
    sweep_.start(kLabel, to, SpreadTo::kRequired, state_);
    // As long as nothing is required, all windows wait at the faces around the site.
    long unlimited = std::numeric_limits<long>::max();
    sweep_.run(unlimited);
    const exact::RequiredPoint point = {from, kInfinity, 0};
    if (vertexAt(mesh, from) >= 0)
      sweep_.require(kLabel, state_, {&from.face, 1});
    else
      sweep_.require(kLabel, state_, {&point, 1});
  }

  bool step(long budget) override { return isDone_ = sweep_.run(budget); }

  /// The wavefront's distance as a share of the straight line in space.
  double progress() const override {
    if (isDone_) return 1;
    return straight_ > 0 ? std::min(sweep_.front() / straight_, 0.9) : 0;
  }

  std::vector<SurfacePoint> take() override {
    exact::ReachedIndex index(mesh_.vertexCount());
    index.reset(state_.vertices);
    return exact::pathToSite(mesh_, to_, state_, index, from_);
  }

 private:
  const TriangleMesh& mesh_;
  const SurfacePoint from_, to_;
  const double straight_;  ///< the distance of the two ends in space
  NearestBounds nearest_;  ///< zero: there are no other labels to compare with
  WindowSweep sweep_;
  LabelState state_;
  bool isDone_ = false;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startShortestPath(const TriangleMesh& mesh,
                                                                         const SurfacePoint& from,
                                                                         const SurfacePoint& to) {
  requireOnMesh(mesh, from, "the start of the path: ");
  requireOnMesh(mesh, to, "the end of the path: ");
  return std::make_unique<PathSearch>(mesh, from, to);
}

std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& from,
                                       const SurfacePoint& to) {
  return finished(startShortestPath(mesh, from, to));
}

}  // namespace gvd
