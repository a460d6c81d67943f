// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Triangles in space, in a tree of boxes.
class TriangleTree {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;

  explicit TriangleTree(std::vector<Triangle> triangles);
  /// Of the faces of a mesh, which must outlive this.
  explicit TriangleTree(const TriangleMesh& mesh);
  /// Builds it, in slices; true when it can be used. Dividing a node is not divided. O(n log n).
  bool step(long& budget);
  /// The share of that which is done, 0 … 1.
  double progress() const { return sequence_.progress(); }

  /// The nearest triangle, -1 if there is none, and its point nearest to another one.
  struct Nearest {
    int triangle = -1;
    Eigen::Vector3d bary = Eigen::Vector3d::Zero();
    double squaredDistance = std::numeric_limits<double>::infinity();
  };
  /// Of triangles at the very same distance, the first.
  Nearest nearest(const Eigen::Vector3d& p) const;

  /// The distance of a point from the nearest triangle; infinite if there is none.
  double distance(const Eigen::Vector3d& p) const;

 private:
  /// Of the triangles from `first` to `last - 1` in `order_`. Its halves, if it has, are the next
  /// node and `second`.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int second;  ///< -1 in a leaf
  };

  /// A node to be made; if it is a second half, of which node.
  struct Task {
    int first, last;
    int parent;
  };

  bool takeFaces(long& budget);
  void makeNext(long& budget);

  const TriangleMesh* mesh_ = nullptr;  ///< if it is of one
  SlicedSequence sequence_;
  SlicedLoop loop_;
  std::vector<Triangle> triangles_;
  std::vector<int> order_;  ///< the triangles, those of a node together
  std::vector<Node> nodes_;
  std::vector<Task> tasks_;  ///< the next one last
};

}  // namespace gvd
