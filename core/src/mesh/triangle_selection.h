// SPDX-License-Identifier: MIT
//
// Steps 1 to 3 of building a `TriangleMesh`, in slices: which triangles of the input are kept.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/point_grid.h"

namespace gvd {

/// Finds the *representative* of every input vertex: the first vertex at the same position; -1 if a
/// coordinate is not finite. O(n), except O(k log k) for a position that k vertices share.
///
/// With a tolerance (`weld` times the diagonal of the bounding box of all triangles), each vertex
/// in turn gets the first representative within the tolerance, or becomes one itself.
/// Representatives are farther apart than the tolerance, so a ball contains only a few: O(n log n).
class VertexWelding {
 public:
  /// All must outlive this.
  VertexWelding(std::span<const double> positions, std::span<const int> triangles, double weld);
  bool step(long& budget);
  std::vector<int> take() { return std::move(representative_); }

 private:
  Eigen::Vector3d position(int v) const;
  int placeGroup(int v) const;
  void weldGroup(std::span<int> vertices);
  void addToBox(int v);
  void openGrid();
  void weldToNear(int v);

  const std::span<const double> positions_;
  const std::span<const int> triangles_;
  const double weld_;

  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::vector<int> representative_;
  Grouping places_;  ///< vertices, grouped by a hash of their positions
  Eigen::Vector3d least_, most_;
  std::optional<PointGrid> keptVertices_;  ///< the representatives, if there is a tolerance
};

/// Whether no corner of a welded triangle is -1.
bool isFinite(const Corners& corners);
/// Whether two corners of a welded triangle are the same.
bool isDegenerate(const Corners& corners);

/// The kept triangles, in the input's order, and the kept triangle of each input triangle.
struct Selection {
  std::vector<int> input;        ///< of each kept triangle, the input triangle
  std::vector<Corners> corners;  ///< of each kept triangle, the representatives
  std::vector<int> kept;         ///< of each input triangle, the kept one with its corners, or -1
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
  SlicedLoop loop_;
  Grouping byLowestCorner_;
  std::size_t originals_ = 0;
  Selection out_;
};

}  // namespace gvd
