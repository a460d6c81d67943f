// SPDX-License-Identifier: MIT
/// \file
/// From places in space to points on the surface: closest point queries.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

class TriangleTree;

/// The point of a surface that is closest to a place in space.
struct ClosestPoint {
  SurfacePoint point;   ///< `face` counts the mesh's faces
  double distance = 0;  ///< along the straight line between the two, in the mesh's units
};

/// Closest point queries on a mesh: for points that were picked or measured in space.
class ClosestPointQuery {
 public:
  /// The mesh must outlive this. A tree of boxes around its faces: O(F log F), 72 bytes per face
  /// and as much again for the boxes.
  explicit ClosestPointQuery(const TriangleMesh& mesh);
  ~ClosestPointQuery();
  ClosestPointQuery(ClosestPointQuery&&) noexcept;
  ClosestPointQuery& operator=(ClosestPointQuery&&) noexcept;

  /// The closest point to a place given in the frame of the mesh's positions. Of points equally
  /// close up to rounding, any one is returned; of faces at exactly the same distance, the lowest.
  /// O(log F) near the surface, up to O(F) where much of the surface is equally far. Throws
  /// `Error(kInvalidPoint)` if a coordinate, or the square of the distance, is not finite.
  ClosestPoint closestTo(const Eigen::Vector3d& place) const;

 private:
  friend std::unique_ptr<SlicedWork<ClosestPointQuery>> startClosestPointQuery(const TriangleMesh&);
  explicit ClosestPointQuery(std::unique_ptr<const TriangleTree> tree);

  std::unique_ptr<const TriangleTree> tree_;
};

/// The same query, made in steps. The mesh must outlive both.
std::unique_ptr<SlicedWork<ClosestPointQuery>> startClosestPointQuery(const TriangleMesh& mesh);

}  // namespace gvd
