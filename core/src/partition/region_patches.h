// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gvd/partition.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Fills in `regions` and `unreachable` of a partition whose triangles and twins are known, and the
/// areas of its triangles.
void measurePatches(const TriangleMesh& mesh, int siteCount, std::span<const double> areas,
                    Partition& partition);

/// The next halfedge along the outline of a region, from one that has another region beyond it, or
/// nothing: around its tip, within the region.
int nextOnOutline(const Partition& partition, int h);

/// Whether a halfedge is on the outline of its region.
inline bool isOnOutline(const Partition& partition, int h) {
  const int twin = partition.twins[h];
  return twin < 0 || partition.triangleLabel[twin / 3] != partition.triangleLabel[h / 3];
}

}  // namespace gvd
