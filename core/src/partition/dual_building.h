// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/dual.h"
#include "partition/region_complex.h"

namespace gvd {

/// Builds a dual from the regions of its diagram, in slices.
class DualBuilding {
 public:
  /// All must outlive this.
  DualBuilding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
               const RegionComplex& complex);
  bool step(long& budget);
  PolygonMesh take() { return std::move(out_); }

 private:
  void addSite(int label);
  void addRun(int border);
  void addPolygon(int vertex);

  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> sites_;
  const RegionComplex& complex_;
  SlicedSequence sequence_;
  std::vector<int> vertexOfLabel_, vertexOfRun_;
  PolygonMesh out_;
};

}  // namespace gvd
