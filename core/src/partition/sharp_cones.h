// SPDX-License-Identifier: MIT
//
// A sharp cone is an inner vertex whose angles sum to less than π. Around it, two regions may meet
// along a closed curve however near their sites are: sites added on such curves come ever nearer to
// the vertex, and never end them. But bisectors of sites that are equally far from the vertex run
// straight to it, so a region around it meets three such sites in three arcs.
#pragma once

#include <span>
#include <vector>

#include "gvd/dual.h"
#include "gvd/partition.h"

namespace gvd {

/// The sites that end a closed curve between two regions if one of them is a disk with a sharp
/// cone: the other's site, turned about the cone. Empty for other violations.
std::vector<SurfacePoint> sitesAroundCone(const TriangleMesh& mesh,
                                          std::span<const SurfacePoint> sites,
                                          const Partition& partition, const Violation& violation);

}  // namespace gvd
