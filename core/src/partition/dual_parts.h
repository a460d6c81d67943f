// SPDX-License-Identifier: MIT
//
// What the dual, its checks and its repair have in common.
#pragma once

#include <span>
#include <vector>

#include "gvd/dual.h"
#include "gvd/partition.h"
#include "partition/region_complex.h"

namespace gvd {

/// As `dualMesh`, of a partition without what no site reaches.
PolygonMesh buildDual(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                      const Partition& partition, const RegionComplex& complex);

/// A violation, and the vertices of the partition at which it can be seen: of these the one
/// farthest from all sites is a good place for another.
struct Finding {
  Violation violation;
  std::vector<int> vertices;
};

/// As `findViolations`, in the same order.
std::vector<Finding> inspect(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                             const Diagram& diagram, const Partition& partition,
                             const RegionComplex& complex);

}  // namespace gvd
