// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "gvd/geodesic.h"

namespace gvd::bench {

struct NamedMetric {
  std::string_view name;
  Metric metric;
};
inline constexpr std::array<NamedMetric, 2> kMetrics = {
    {{"dgpc", Metric::kDgpc}, {"exact", Metric::kExact}}};

/// Computes the distances of all sites at one go.
inline std::unique_ptr<DistanceField> distances(const TriangleMesh& mesh,
                                                std::span<const SurfacePoint> sites,
                                                Metric metric) {
  return finished(propagate(mesh, sites, metric));
}

}  // namespace gvd::bench
