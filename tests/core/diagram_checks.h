// SPDX-License-Identifier: MIT
//
// What holds for every diagram of every mesh, checked independently of how it was traced.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::checks {

/// The field and the diagram of some sites.
struct Traced {
  std::unique_ptr<DistanceField> field;
  Diagram diagram;
};
Traced trace(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
             Metric metric = Metric::kExact, int detail = 0, Spread spread = Spread::kAsNeeded);

/// Success if
///  - the areas of the regions sum to the area of the components with sites (1e-12 relative);
///  - every segment is used exactly twice by loops: forwards by its lower label, backwards by its
///    higher one, and every other step of a loop runs along the mesh boundary;
///  - the cells and region triangles, where detail is 0, form a closed complex: each of their sides
///    is used once in each direction, except along the mesh boundary, and V - E + F is the mesh's;
///  - every point is on the surface, and if a segment ends there, in a face of one of these; every
///  arc is a chain of its segments, every Voronoi point has
///    three or more labels.
::testing::AssertionResult isConsistent(const TriangleMesh& mesh, const Diagram& diagram,
                                        int detail = 0);

/// Success if `nearest` gives at every vertex the least distance known there, and with the exact
/// metric distances are never less than the straight line in space, and zero at every site. Inside
/// faces `nearest` knows more than the diagram, of which the bisectors are straight there.
::testing::AssertionResult agreesWithField(const TriangleMesh& mesh, const Traced& traced,
                                           std::span<const SurfacePoint> sites, Metric metric);

/// Success if brute force (`everywhere`) finds no more than `traced` knows: in the middle of every
/// part the nearest site is as far away, and known at all three corners. For the exact metric. DGPC
/// stops a label where another one is ahead at both ends of an edge, and where one of them comes
/// around an obstacle, may so lose a part that it would own.
::testing::AssertionResult spreadsFarEnough(const TriangleMesh& mesh, const Traced& traced,
                                            const Traced& everywhere);

/// Success if two diagrams of one mesh are the same: label l of a is label `labelInB[l]` of b; the
/// same region triangles, numbers of loops, segments and Voronoi points with their labels; region
/// areas to `tolerance` times the mesh area.
::testing::AssertionResult areSame(const TriangleMesh& mesh, const Diagram& a, const Diagram& b,
                                   std::span<const int> labelInB, double tolerance);

std::vector<int> identity(int count);

}  // namespace gvd::checks
