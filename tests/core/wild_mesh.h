// SPDX-License-Identifier: MIT
//
// Meshes that no modeller makes on purpose: triangle soups with every kind of degenerate face.
#pragma once

#include "shapes.h"

namespace gvd {

/// Up to `mostTriangles` triangles. Either their corners are any three of few or many vertices, so
/// that edges have any number of faces, or they form a grid, a fan or separate triangles, so that
/// most edges have two or one.
///
/// The vertices are random, on a lattice, on a line, in a few places, apart by no more than
/// rounding, far from the origin, in needles of up to 1e8 : 1, or of sizes from 1e-59 to 1e59; some
/// are not finite. Often no triangle survives the repairs, and `TriangleMesh` throws.
shapes::Shape wildMesh(shapes::Random& random, int mostTriangles);

}  // namespace gvd
