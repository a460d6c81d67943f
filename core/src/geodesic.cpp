// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include "gvd/error.h"
#include "metric.h"

namespace gvd {

#ifndef GVD_HAS_EXACT
std::unique_ptr<Propagation> propagateExact(const TriangleMesh&, std::span<const SurfacePoint>) {
  throw Error(ErrorCode::kInvalidArgument, "the exact metric is not built in");
}
#endif

std::unique_ptr<Propagation> propagate(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites, Metric metric) {
  if (sites.empty()) throw Error(ErrorCode::kInvalidArgument, "there is no site");
  return metric == Metric::kExact ? propagateExact(mesh, sites) : propagateDgpc(mesh, sites);
}

}  // namespace gvd
