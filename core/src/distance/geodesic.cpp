// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include <algorithm>
#include <utility>

#include "base/sliced_loop.h"
#include "distance/path_points.h"
#include "distance/site_distances.h"
#include "gvd/error.h"
#include "mesh/given_points.h"

namespace gvd {

std::unique_ptr<Propagation> propagate(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites, Metric metric) {
  const auto isAbsent = [](const SurfacePoint& site) { return site.face == -1; };
  if (std::all_of(sites.begin(), sites.end(), isAbsent))
    throw Error(ErrorCode::kInvalidArgument, "there is no site");
  return workOn(std::make_unique<SiteDistances>(mesh, metric, sites),
                [](auto distances) -> std::unique_ptr<DistanceField> { return distances; });
}

double lengthOf(const TriangleMesh& mesh, std::span<const SurfacePoint> path) {
  double length = 0;
  SurfacePoint last;
  for (size_t i = 0; i < path.size(); ++i) {
    const SurfacePoint p = onMesh(mesh, path[i], "point", i);
    if (i > 0) length += lengthBetween(mesh, last, p);
    last = p;
  }
  return length;
}

}  // namespace gvd
