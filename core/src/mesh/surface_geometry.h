// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "base/prefetch.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

inline double longestEdge(const TriangleMesh& mesh) {
  double longest = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) longest = std::max(longest, mesh.longestEdge(v));
  return longest;
}

/// Prefetches the list of the halfedges that leave a vertex, which tells where the faces around it
/// are.
inline void prefetchFan(const TriangleMesh& mesh, int vertex) {
  prefetch(mesh.fan(vertex).front());
}

/// Prefetches the faces around a vertex, one of several vertices (`prefetchInBatch`).
inline void prefetchFacesAround(const TriangleMesh& mesh, int vertex) {
  mesh.visitFaces(vertex, [&](int f) { prefetchInBatch(mesh.face(f)); });
}

/// Whether a halfedge is one side of a slit: a single edge that is cut, around both ends of which
/// the surface goes on. The two sides have the same ends, and so the same distances there, but a
/// label that owns part of one side may be far from the other.
inline bool isSideOfSlit(const TriangleMesh& mesh, int h) {
  return mesh.twin(h) < 0 && mesh.tip(mesh.outgoing(mesh.tip(h))) == mesh.tail(h);
}

}  // namespace gvd
