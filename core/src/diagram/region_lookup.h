// SPDX-License-Identifier: MIT
#pragma once

#include "gvd/diagram.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The label of the region that a point of a face lies in, as regions are drawn: by the cells of
/// mixed faces. `Diagram::kUnreachable` if it lies in none; on an outline, of any of those there.
/// O(log cells + corners of the cells of the face).
int labelAt(const TriangleMesh& mesh, const Diagram& diagram, const SurfacePoint& p);

}  // namespace gvd
