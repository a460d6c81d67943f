// SPDX-License-Identifier: MIT
#pragma once

#include "base/rejection.h"
#include "gvd/diagram.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if a diagram given by a caller cannot be one of the mesh,
/// because it has another number of faces.
inline void requireFaces(const TriangleMesh& mesh, const Diagram& diagram) {
  if (static_cast<int>(diagram.faceLabel.size()) != mesh.faceCount())
    rejectArgument("the diagram is that of another mesh");
}

}  // namespace gvd
