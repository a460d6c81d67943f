// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gvd/diagram.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The regions of a diagram at points, as they are drawn: by the cells of mixed faces.
class RegionLookup {
 public:
  /// O(F + cells). Mesh and diagram must outlive it.
  RegionLookup(const TriangleMesh& mesh, const Diagram& diagram);

  /// The label of the region that a point of a face lies in, `Diagram::kUnreachable` if none does;
  /// on an outline, of any of those there. O(corners of the cells of the face).
  int labelAt(const SurfacePoint& p) const;

 private:
  double depthInCell(const SurfacePoint& p, int cell) const;

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  std::vector<int> firstCell_;  ///< per face
};

}  // namespace gvd
