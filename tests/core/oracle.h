// SPDX-License-Identifier: MIT
//
// Exact polyhedral distances by CGAL: an independent reference for the metrics.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Distances on one mesh, which must outlive this.
class Oracle {
 public:
  explicit Oracle(const TriangleMesh& mesh);
  ~Oracle();

  /// The distances of one site at some points; infinity if no path leads there.
  ///
  /// Takes one site only: with several in one tree, CGAL's distances may be too long.
  std::vector<double> distances(const SurfacePoint& site,
                                std::span<const SurfacePoint> points) const;

 private:
  struct Surface;
  const TriangleMesh& mesh_;
  std::unique_ptr<Surface> surface_;
};

}  // namespace gvd
