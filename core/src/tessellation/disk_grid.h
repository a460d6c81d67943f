// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "base/small_lists.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Geodesic disks by place, to find those that may contain a point. A face in the plane, with its
/// longest side along the x axis, has a grid of rectangles on its bounding box; each rectangle has
/// the disks that reach it. Faces about as wide as a disk, or less, have one rectangle.
class DiskGrid {
 public:
  /// The distances of a disk's centre from the corners of a face. The squared distance of a point
  /// of the face, as unfolding has it, is |(x, y)|² plus a linear function of x and y.
  using Distances = Eigen::Vector3d;

  /// Rectangles are about `width` wide, or wider, so that there are about 2^18 at most besides one
  /// per face.
  DiskGrid(const TriangleMesh& mesh, double width);

  /// Makes room for the disks; true when there is.
  bool prepare(long& budget);
  /// Adds the disk to the rectangles of a face that it may reach.
  void add(int face, const Distances& distances, double radius);
  /// The disks in the rectangle of a point, all disks that contain the point among them.
  std::span<const int> near(const SurfacePoint& p) const;
  /// The distances of the centre of one of these disks.
  const Distances& operator[](int disk) const { return distances_[disk]; }

 private:
  struct Grid {
    int side;  ///< the longest one
    double length;
    Eigen::Vector2d apex;  ///< in the coordinates of the side
    int columns, rows;
  };
  Grid gridOf(const TriangleMesh::Face& face) const;

  const TriangleMesh& mesh_;
  const double width_;
  SlicedSequence sequence_;
  std::vector<int> first_ = {0};     ///< rectangle of each face; at the end, how many there are
  SmallLists<int> disks_;            ///< per rectangle
  std::deque<Distances> distances_;  ///< of a disk in a face; not moved when there are more
};

}  // namespace gvd
