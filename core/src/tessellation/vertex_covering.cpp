// SPDX-License-Identifier: MIT
#include "tessellation/vertex_covering.h"

#include <array>

#include "base/tolerances.h"
#include "gvd/geodesic.h"
#include "mesh/incidence.h"

namespace gvd {

VertexCovering::VertexCovering(const TriangleMesh& mesh, double radius, std::size_t most,
                               std::vector<SurfacePoint>& points)
    : mesh_(mesh),
      radius_(radius),
      most_(most),
      points_(points),
      distances_(mesh, Metric::kExact, points) {}

bool VertexCovering::step(long& budget) {
  while (round_.runRound([&] { return distances_.step(budget); },
                         [&] {
                           farthest_ = -1;
                           distance_ = radius_ * (1 + kDistanceTolerance);
                         },
                         forEach(mesh_.vertexCount(), budget, 8, [&](int v) { offer(v); }))) {
    if (farthest_ < 0 || points_.size() >= most_) return true;
    const SurfacePoint point = pointAtVertex(mesh_, farthest_);
    const std::array added = {SiteChange{static_cast<int>(points_.size()), point}};
    points_.push_back(point);
    distances_.change(added);
  }
  return false;
}

void VertexCovering::offer(int vertex) {
  const double distance = nearestOf(distances_.at(vertex)).distance;
  if (!(distance > distance_)) return;
  distance_ = distance;
  farthest_ = vertex;
}

}  // namespace gvd
