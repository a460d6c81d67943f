// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "diagram/bisector_tracing.h"
#include "diagram/face_complex.h"
#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A diagram, or a part of one. What it holds of the labels it was traced for, their loops, arcs,
/// Voronoi points and cells, is as in the whole diagram; what it holds of others is not. Areas are
/// those in the faces it was traced in only, and `faceLabel` has one label for each of these.
struct TracedDiagram {
  Diagram diagram;
  /// The faces where points have become one, some several times. There a part is not certain: the
  /// order of labels around such a point follows from the loops of all of them, which must be
  /// traced as well.
  std::vector<int> mergedFaces;
  /// The faces of a refined diagram for which the tracer had to add labels to those known at their
  /// nodes. There the distances at the corners do not tell which regions meet, and no part is
  /// certain.
  std::vector<int> completedFaces;
};

/// What `startDiagram` does.
std::unique_ptr<SlicedWork<TracedDiagram>> startWhole(const TriangleMesh& mesh,
                                                      const DistanceField& distances, int siteCount,
                                                      const DiagramOptions& options);

/// Traces parts of a diagram, one after the other, each in time for what it traces only.
class PartialTracer {
 public:
  /// The distances may change between traces. They and the mesh must outlive this.
  PartialTracer(const TriangleMesh& mesh, const DistanceField& distances,
                const DiagramOptions& options);

  /// Begins to trace the loops of the labels for which `isTraced`, one per label, says so, in some
  /// faces, given ascending: all those of which one of these labels is known at a corner, and
  /// another one. Only the last trace can go on. O(M log M), M faces.
  std::unique_ptr<SlicedWork<TracedDiagram>> start(std::span<const int> faces,
                                                   std::vector<char> isTraced);
  /// Which of the faces of the last trace a face is, -1 if it is none.
  int faceIndex(int face) const { return complex_.faceIndex(face); }

 private:
  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  DiagramOptions options_;
  FaceComplex complex_;
  NodePoints nodePoints_;
};

}  // namespace gvd
