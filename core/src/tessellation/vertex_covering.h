// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "base/sliced_loop.h"
#include "distance/site_distances.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Adds vertices to a list of points until no vertex of the mesh is farther than a radius from all
/// of them by exact distances, always the farthest; of equals, the lowest. Few are missing where
/// the points cover the vertices by approximate distances already. Takes as long as exact distances
/// of all points, and O(V) for each vertex that is added.
class VertexCovering {
 public:
  /// The list grows to no more than `most` points. Both must outlive this.
  VertexCovering(const TriangleMesh& mesh, double radius, std::size_t most,
                 std::vector<SurfacePoint>& points);
  bool step(long& budget);
  /// The share done of the distances of all points; begins again with each point that is added.
  double progress() const { return distances_.progress(); }

 private:
  void offer(int vertex);

  const TriangleMesh& mesh_;
  const double radius_;
  const std::size_t most_;
  std::vector<SurfacePoint>& points_;

  SlicedSequence round_;
  SiteDistances distances_;
  int farthest_ = -1;  ///< vertex
  double distance_ = 0;
};

}  // namespace gvd
