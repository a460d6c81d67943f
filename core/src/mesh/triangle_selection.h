// SPDX-License-Identifier: MIT
//
// Steps 1 to 3 of building a `TriangleMesh`, in slices: which of the input's triangles stay.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/grouping.h"
#include "mesh/point_grid.h"

namespace gvd {

/// For every input vertex its *representative*: the first vertex at the same position; -1 where a
/// coordinate is not finite. O(n), but O(n log n) for places that many vertices share.
///
/// With a tolerance, `weld` times the diagonal of the bounding box of all triangles, each vertex in
/// turn has the first representative that is no farther away, or is one itself. Of them, a ball has
/// a bounded number, so this is O(n log n).
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
  Grouping places_;  ///< the vertices of a place are in one group, by its hash
  Eigen::Vector3d least_, most_;
  std::optional<PointGrid> staying_;  ///< where there is a tolerance
};

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
/// counts them. Throws `Error(kInvalidMesh)` if none is left. O(n), but O(n log n) for duplicates.
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
