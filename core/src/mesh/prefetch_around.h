// SPDX-License-Identifier: MIT
#pragma once

#include "base/prefetch.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Prefetches the list of the halfedges that leave a vertex, which tells where the faces around it
/// are.
inline void prefetchFan(const TriangleMesh& mesh, int vertex) {
  prefetch(mesh.fan(vertex).front());
}

/// Prefetches the faces around a vertex, one of several vertices (`prefetchInBatch`).
inline void prefetchFacesAround(const TriangleMesh& mesh, int vertex) {
  mesh.visitFaces(vertex, [&](int f) { prefetchInBatch(mesh.face(f)); });
}

}  // namespace gvd
