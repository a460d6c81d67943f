// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "gvd/geodesic.h"

namespace gvd {

/// Which paths DGPC turns into geodesics in the end.
enum class Straightens {
  kBetweenRegions,  ///< those to where regions meet: a diagram depends on no others
  kEverywhere,      ///< inside regions too: distances then hardly jump where sites move
};

/// The two metrics behind `propagate`.
std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Spread spread,
                                           Straightens straightens = Straightens::kBetweenRegions);
std::unique_ptr<Propagation> propagateExact(const TriangleMesh& mesh,
                                            std::span<const SurfacePoint> sites, Spread spread);

}  // namespace gvd
