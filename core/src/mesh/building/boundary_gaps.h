// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/point_grid.h"

namespace gvd {

/// Looks for boundary vertices that nearly coincide, or lie within boundary edges, without being
/// joined: `MeshTopology::hasOpenSeams` and `hasTJunctions`. Of long boundaries, vertices are
/// compared with a sample: O(n).
class BoundaryGaps {
 public:
  /// `boundary` lists the vertices along the loops. Sets facts of `topology`. All must outlive
  /// this.
  BoundaryGaps(const TriangleMesh& mesh, std::span<const double> positions,
               std::span<const int> boundary, MeshTopology& topology);
  bool step(long& budget);

 private:
  template <class Visit>
  void visitSample(std::size_t most, Visit visit) const;
  void sample();
  void lookForSeam(int vertex);
  long lookForTJunction(int vertex);

  const TriangleMesh& mesh_;
  const std::span<const double> positions_;
  const std::span<const int> boundary_;
  const double width_;  ///< of the gaps
  MeshTopology& topology_;

  SlicedSequence sequence_;
  std::optional<PointGrid> samples_;
  std::vector<int> comparedWithEdges_;  ///< vertices
};

}  // namespace gvd
