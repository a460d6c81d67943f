// SPDX-License-Identifier: MIT
//
// Invariants of every partition of every mesh, checked from its triangles and twins alone.
#pragma once

#include <gtest/gtest.h>

#include "gvd/diagram.h"
#include "gvd/partition.h"
#include "gvd/triangle_mesh.h"

namespace gvd::checks {

/// Success if, in a partition that leaves nothing out,
///  - twins run the other way;
///  - welded by the twins, the triangles are a manifold with the mesh's Euler characteristic,
///    boundary loops and components, and one vertex per point;
///  - every vertex is at its surface point in each of its triangles (1e-8 of the bounding
///    diagonal);
///  - the areas of the regions sum to the mesh's (1e-12 of it);
///  - the facts of each region are true of its triangles;
///  - borders are as long from both sides.
::testing::AssertionResult isSound(const TriangleMesh& mesh, const Partition& partition);

/// Success if regions have the areas that the diagram states (1e-9 of the mesh's).
::testing::AssertionResult hasTheAreasOf(const TriangleMesh& mesh, const Diagram& diagram,
                                         const Partition& partition);

/// Success if `hasTheAreasOf` succeeds, and no triangle is turned over. Not for sites closer
/// together than rounding, whose diagrams have cells that are turned over.
::testing::AssertionResult agreesWithDiagram(const TriangleMesh& mesh, const Diagram& diagram,
                                             const Partition& partition);

/// Success if every twin runs the other way, and the twin of a twin is the halfedge itself.
::testing::AssertionResult hasItsTwins(const Partition& partition);

}  // namespace gvd::checks
