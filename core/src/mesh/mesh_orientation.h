// SPDX-License-Identifier: MIT
//
// Steps 4 to 7 of building a `TriangleMesh`: from triangles that stay to an oriented manifold. All
// in O(n).
#pragma once

#include <vector>

#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/triangle_selection.h"

namespace gvd {

/// The halfedge on the other side of each edge of exactly two triangles, whichever way it runs; -1
/// on all other edges. Counts the edges of three or more.
std::vector<int> matchHalfedges(const std::vector<Corners>& triangles, int vertexCount,
                                MeshRepairs& repairs);

/// What each triangle's component is, and which triangles were turned over.
struct OrientedComponents {
  std::vector<int> component;  ///< of each triangle, numbered in order of the first triangle
  std::vector<char> flipped;   ///< of each triangle, whether it was turned over
  int components = 0;
};

/// Orients each component as most of its triangles are (on a draw, as its first one), cuts the
/// edges where that is not possible, and turns triangles over: (a, b, c) becomes (a, c, b). From
/// then on twins run in opposite directions. If orientations are kept, all edges are cut where they
/// do not agree, and that is all.
OrientedComponents orientTriangles(std::vector<Corners>& triangles, std::vector<int>& twin,
                                   Orientation orientation, MeshRepairs& repairs);

/// Drops the components of fewer than `least` triangles, and counts them. Throws
/// `Error(kInvalidMesh)` if none is left.
void dropSmallComponents(int least, Selection& selection, std::vector<int>& twin,
                         OrientedComponents& oriented, MeshRepairs& repairs);

/// The vertices of an oriented manifold. Vertices keep the order of their representatives; the
/// copies for further fans come last.
struct Fans {
  std::vector<int> tail;            ///< of each halfedge, the vertex that it leaves
  std::vector<int> representative;  ///< of each vertex
  /// Of each vertex, a halfedge that leaves it; at the boundary the first one clockwise.
  std::vector<int> outgoing;
};

/// Splits every vertex whose triangles form several fans, one vertex per fan.
Fans splitFans(const std::vector<Corners>& triangles, const std::vector<int>& twin,
               int inputVertexCount, MeshRepairs& repairs);

}  // namespace gvd
