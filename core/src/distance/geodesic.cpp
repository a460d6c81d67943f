// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include "distance/metric.h"
#include "gvd/error.h"

namespace gvd {

Eigen::Vector2d DistanceField::direction(int /*label*/, int /*vertex*/) const {
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::unique_ptr<Propagation> propagate(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites, Metric metric,
                                       Spread spread) {
  if (sites.empty()) throw Error(ErrorCode::kInvalidArgument, "there is no site");
  return metric == Metric::kExact ? propagateExact(mesh, sites, spread)
                                  : propagateDgpc(mesh, sites, spread);
}

}  // namespace gvd
