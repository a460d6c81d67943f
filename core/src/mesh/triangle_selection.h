// SPDX-License-Identifier: MIT
//
// Steps 1 to 3 of building a `TriangleMesh`: which of the input's triangles stay.
#pragma once

#include <span>
#include <vector>

#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if an option is not in its range.
void requireValid(const MeshOptions& options);

/// Throws `Error(kInvalidMesh)` unless both arrays are made of triples and every index names a
/// vertex.
void requireIndexedTriangles(std::span<const double> positions, std::span<const int> triangles);

/// For every input vertex its *representative*: the first vertex at the same position; -1 where a
/// coordinate is not finite. O(n log n).
std::vector<int> findRepresentatives(std::span<const double> positions);

/// Those of a tolerance, `weld` times the diagonal of the bounding box of all `triangles`: each
/// vertex in turn has the first representative that is no farther away, or is one itself. Of them,
/// a ball has a bounded number, so this is O(n log n) as well.
std::vector<int> findRepresentatives(std::span<const double> positions,
                                     std::span<const int> triangles, double weld);

/// The input's triangles with representatives for corners, -1 where a corner is not finite.
std::vector<Corners> weldCorners(std::span<const int> triangles,
                                 const std::vector<int>& representative);

/// Whether no corner of a welded triangle is -1.
bool isFinite(const Corners& corners);
/// Whether two corners of a welded triangle are the same.
bool isDegenerate(const Corners& corners);

/// The triangles that stay, in the input's order, and where each input triangle went.
struct Selection {
  std::vector<int> input;        ///< of each kept triangle, the input triangle
  std::vector<Corners> corners;  ///< of each kept triangle, the representatives
  std::vector<int> kept;         ///< of each input triangle, the kept one with its corners, or -1
};

/// Drops welded triangles that are not finite, degenerate, or duplicates of earlier ones, and
/// counts them. Throws `Error(kInvalidMesh)` if none is left. O(n).
Selection selectTriangles(const std::vector<Corners>& welded, int vertexCount,
                          MeshRepairs& repairs);

}  // namespace gvd
