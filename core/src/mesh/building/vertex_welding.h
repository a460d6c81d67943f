// SPDX-License-Identifier: MIT
//
// Step 2 of building a `TriangleMesh`, in slices: which vertices of the input are one.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "mesh/building/point_grid.h"

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
  VertexWelding(std::span<const double> positions, std::span<const int> triangles, double weld)
      : positions_(positions), triangles_(triangles), weld_(weld) {}
  bool step(long& budget);
  std::vector<int> take() { return std::move(representative_); }
  /// A length; 0 for bit-equal positions only. To be called when all steps are done.
  double tolerance() const { return tolerance_; }

 private:
  int placeGroup(int v) const;
  void weldGroup(std::span<int> vertices);
  void openGrid();
  void weldToNear(int v);

  const std::span<const double> positions_;
  const std::span<const int> triangles_;
  const double weld_;

  SlicedSequence sequence_;
  std::vector<int> representative_;
  Grouping places_;          ///< vertices, grouped by a hash of their positions
  Eigen::AlignedBox3d box_;  ///< of all triangles
  double tolerance_ = 0;
  std::optional<PointGrid> keptVertices_;  ///< the representatives, if there is a tolerance
};

}  // namespace gvd
