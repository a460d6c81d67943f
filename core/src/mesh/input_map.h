// SPDX-License-Identifier: MIT
//
// Where the input's triangles and vertices are found in a `TriangleMesh`.
#pragma once

#include <span>
#include <vector>

#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"

namespace gvd {

/// For every corner of every input triangle a halfedge that leaves it, all three on one face: the
/// triangle itself, the one it duplicates, or, of a degenerate triangle, any that has its two
/// positions. -1 if there is none. `welded` are the input's triangles and `faces` the mesh's, both
/// by representatives; `kept` is the face of each input triangle or -1. O(n log n) in the number of
/// degenerate triangles.
std::vector<Corners> mapInputCorners(const std::vector<Corners>& welded,
                                     const std::vector<Corners>& faces, std::vector<int> kept);

/// For every input vertex a halfedge that leaves it: on the first triangle that names the vertex
/// and has a face, else anywhere at its position; -1 if there is none. O(n).
std::vector<int> mapInputVertices(std::span<const int> triangles,
                                  const std::vector<int>& representative,
                                  const std::vector<Corners>& halfedgesOfInput);

/// Counts welded and isolated vertices.
void countInputVertices(const std::vector<int>& halfedgeOfVertex,
                        const std::vector<int>& representative, MeshRepairs& repairs);

}  // namespace gvd
