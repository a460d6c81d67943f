// SPDX-License-Identifier: MIT
//
// Meshes as no modeller makes them on purpose: triangle soups with every kind of degenerate face.
#pragma once

#include "shapes.h"

namespace gvd {

/// Up to `mostTriangles` triangles, any three corners of few or many vertices, so that edges have
/// any number of faces; or of a grid, a fan or separate triangles, so that most have two or one.
///
/// The vertices are random, or of a lattice, on a line, in a few places, next to each other by
/// rounding, far from the origin, in needles of up to 1e8 : 1, of sizes from 1e-59 to 1e59; some
/// are not finite. Often no triangle is left of it, and `TriangleMesh` throws.
shapes::Shape wildMesh(shapes::Random& random, int mostTriangles);

}  // namespace gvd
