// SPDX-License-Identifier: MIT
#pragma once

#include "gvd/diagram.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if a diagram given by a caller cannot be one of the mesh,
/// because it has another number of faces.
void requireFaces(const TriangleMesh& mesh, const Diagram& diagram);

}  // namespace gvd
