// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "gvd/geodesic.h"

namespace gvd {

/// The two metrics behind `propagate`.
std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Spread spread);
std::unique_ptr<Propagation> propagateExact(const TriangleMesh& mesh,
                                            std::span<const SurfacePoint> sites, Spread spread);

}  // namespace gvd
