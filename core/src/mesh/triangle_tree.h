// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <limits>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/nearest_on_triangle.h"

namespace gvd {

/// A bounding box tree of triangles in space.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<SpaceTriangle> triangles);
  /// The faces of a mesh, which must outlive this.
  explicit TriangleTree(const TriangleMesh& mesh);
  /// Builds the tree, in slices; true when the tree can be used. O(n log n).
  bool step(long& budget);
  /// The share of the building that is done, 0 … 1.
  double progress() const { return sequence_.progress(); }

  /// All triangles, in the order given.
  const std::vector<SpaceTriangle>& triangles() const { return triangles_; }

  /// The nearest of the triangles that `isSought` is true for, or of all if it is empty. Of
  /// triangles at exactly the same distance, the first. None if no distance is less than `below`,
  /// or no squared distance is a finite number.
  NearestOfTriangles nearest(const Eigen::Vector3d& p,
                             double below = std::numeric_limits<double>::infinity(),
                             const std::function<bool(int)>& isSought = {}) const;

 private:
  /// Contains the triangles `first` … `last - 1` of `order_`. Its children, if it has any, are the
  /// next node and `second`.
  struct Node {
    Eigen::AlignedBox3d box;
    int first, last;
    int second;  ///< -1 in a leaf
  };

  /// A node to be made; `parent` is -1 unless it is a second child.
  struct Task {
    int first, last;
    int parent;
  };

  bool makeNext(long& budget);
  void findPivot(int first, int count);

  const TriangleMesh* mesh_ = nullptr;  ///< null for a list of triangles
  SlicedSequence sequence_;
  std::vector<SpaceTriangle> triangles_;
  std::vector<int> order_;  ///< triangles; those of a node are consecutive
  std::vector<Node> nodes_;
  std::vector<Task> tasks_;  ///< the last one is next

  // Of the next node.
  SlicedSequence making_;
  Eigen::AlignedBox3d box_, centres_;  ///< of its triangles, of their centres
  Eigen::Index axis_ = 0;              ///< along which it is divided
  double pivot_ = 0;                   ///< what is less goes to the first child
  int middle_ = 0;                     ///< where triangles of the second child begin
};

}  // namespace gvd
