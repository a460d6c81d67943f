// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace gvd {

/// Triangles in space, in a tree of boxes.
class TriangleTree {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;

  /// O(n log² n).
  explicit TriangleTree(std::vector<Triangle> triangles);

  /// The distance of a point from the nearest triangle; infinite if there is none.
  double distance(const Eigen::Vector3d& p) const;

 private:
  /// Of the triangles `first` … `last - 1`. Its halves, if it has, are the next node and `second`.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int second;  ///< -1 in a leaf
  };

  int build(int first, int last);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace gvd
