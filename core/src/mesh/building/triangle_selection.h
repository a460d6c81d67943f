// SPDX-License-Identifier: MIT
//
// Steps 1 and 3 of building a `TriangleMesh`, in slices: which triangles of the input are kept.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"

namespace gvd {

/// Whether no corner of a welded triangle is -1.
bool isFinite(const Corners& corners);
/// Whether two corners of a welded triangle are the same.
bool isDegenerate(const Corners& corners);

/// The kept triangles, in the input's order, and the kept triangle of each input triangle.
struct Selection {
  std::vector<int> input;  ///< of each kept triangle, the input triangle
  Faces faces;             ///< of each kept triangle: its corners' representatives, without twins
  std::vector<int> kept;   ///< of each input triangle, the kept one with its corners, or -1
};

/// Drops welded triangles that are not finite, degenerate, or duplicates of earlier ones, and
/// counts them. Throws `Error(kInvalidMesh)` if none is left. O(n), except O(k log k) for k
/// triangles with one lowest corner.
class TriangleSelection {
 public:
  TriangleSelection(const WeldedTriangles& welded, int vertexCount, MeshRepairs& repairs)
      : welded_(welded), vertexCount_(vertexCount), repairs_(repairs) {}
  bool step(long& budget);
  Selection take() { return std::move(out_); }

 private:
  void count(int t);
  void findOriginals(std::span<int> triangles);
  void keep(int t);
  void requireAny() const;

  const WeldedTriangles welded_;
  const int vertexCount_;
  MeshRepairs& repairs_;

  SlicedSequence sequence_;
  Grouping byLowestCorner_;
  std::size_t originals_ = 0;
  Selection out_;
};

}  // namespace gvd
