// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/index_map.h"
#include "base/index_set.h"
#include "diagram/complex/complex_building.h"
#include "diagram/graph/bisector_graph.h"
#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A diagram, or a part of one. The loops, arcs, Voronoi points and cells of the traced labels are
/// those of the whole diagram; those of other labels may not be. Areas and `faceLabel` cover the
/// traced faces only, `faceLabel` with one entry for each of them.
struct TracedDiagram {
  Diagram diagram;
  /// The faces with merged points, with repetitions. The order of labels around a merged point
  /// follows from the loops of all of them, so a part is reliable there only if all of them are
  /// traced.
  std::vector<int> mergedFaces;
  /// The faces of a refined diagram for which the tracer had to add labels (`LabelCompletion`).
  /// There the regions that meet do not follow from the distances at the corners, so a part with
  /// such faces is not traced: its `diagram` is empty.
  std::vector<int> completedFaces;
};

/// Like `startDiagram`.
std::unique_ptr<SlicedWork<TracedDiagram>> startTracing(const TriangleMesh& mesh,
                                                        const DistanceField& distances,
                                                        int siteCount,
                                                        const DiagramOptions& options);

/// Traces parts of a diagram, one after the other, in time proportional to each part.
class PartialTracer {
 public:
  /// The distances may change between traces. They and the mesh must outlive this.
  PartialTracer(const TriangleMesh& mesh, const DistanceField& distances,
                const DiagramOptions& options);

  /// Begins to trace the loops of some labels below `labelCount`. `faces`, ascending, must be all
  /// faces with a corner where one of these labels and another label are known. Invalidates the
  /// previous trace; the labels must outlive this one. O(M log M), M faces.
  std::unique_ptr<SlicedWork<TracedDiagram>> start(std::span<const int> faces,
                                                   const IndexSet& labels, int labelCount);
  /// The index of a face among those of the last trace, -1 if it is not one of them.
  int faceIndex(int face) const { return building_.complex().faceIndex(face); }

 private:
  const DistanceField& distances_;
  ComplexBuilding building_;
  IndexMap pointOfNode_;
};

}  // namespace gvd
