// SPDX-License-Identifier: MIT
#pragma once

#include "gvd/triangle_mesh.h"

namespace gvd {

/// Whether a mesh may have double edges, which have the same two ends: only where it was cut.
inline bool mayHaveDoubleEdges(const TriangleMesh& mesh) {
  return mesh.repairs().nonManifoldEdges > 0 || mesh.repairs().orientationCuts > 0;
}

/// Whether a halfedge is one side of a slit: a single edge that is cut, around both ends of which
/// the surface goes on. The two sides have the same ends, and so the same distances there, but a
/// label that owns part of one side may be far from the other.
inline bool isSideOfSlit(const TriangleMesh& mesh, int h) {
  return mesh.twin(h) < 0 && mesh.tip(mesh.outgoing(mesh.tip(h))) == mesh.tail(h);
}

}  // namespace gvd
