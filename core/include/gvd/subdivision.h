// SPDX-License-Identifier: MIT
/// \file
/// Triangles with shorter sides, for models whose triangles are about as long as regions.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "gvd/sliced_work.h"

namespace gvd {

struct SubdivisionOptions {
  /// No side of a part is longer than this share of the bounding box's diagonal, that of all finite
  /// vertices which triangles have; above 0, at most 1.
  double maxEdge = 1;
  int maxTriangles = 1 << 24;  ///< more are refused; positive
};

/// Triangles cut into smaller ones.
struct SubdividedTriangles {
  std::vector<double> positions;  ///< x, y, z per vertex: those given, then the midpoints
  /// Three vertices each. The parts of a triangle take its place, and keep its orientation.
  std::vector<int> triangles;
  std::vector<int> parents;  ///< per triangle, ascending: the given triangle that it is part of
  /// Per midpoint, the two vertices that it lies between: given ones, or earlier midpoints.
  std::vector<std::array<int, 2>> ends;
};

/// Halves the sides longer than a limit, and the halves, until none is. The surface stays the same,
/// but on it distances, bisectors and integrals become more accurate: bisectors are straight within
/// a triangle, and a diagram knows a region by the corners that it owns, so one that lies between
/// the corners of long triangles, as on mechanical parts, is missed without subdivision.
///
/// A triangle with one long side becomes two, with two three, with three four. A side is halved in
/// all of its triangles, at a vertex that they share if they share its ends, and at the same place
/// if their ends are at the same places, so no cracks appear. (Where ends are only near each other,
/// for `MeshOptions::weld` to join, rounding may decide differently on the two sides. That leaves
/// T-junctions, which `weld` joins, too.) Triangles without long sides stay as they are, as do
/// those with a corner that is not finite. No side is halved that is shorter than 2^-48 of the
/// largest coordinate.
///
/// `positions` and `triangles` as for `TriangleMesh`. Throws as it does if an index is out of range
/// or an array's size is no multiple of three; `Error(kInvalidArgument)` if an option is not in its
/// range or there would be more than `maxTriangles`, before any memory is taken for them. O(n) in
/// the triangles that result.
SubdividedTriangles subdivide(std::vector<double> positions, std::vector<int> triangles,
                              const SubdivisionOptions& options);
/// The same in steps.
std::unique_ptr<SlicedWork<SubdividedTriangles>> startSubdivision(
    std::vector<double> positions, std::vector<int> triangles, const SubdivisionOptions& options);

}  // namespace gvd
