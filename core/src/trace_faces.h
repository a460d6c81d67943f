// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gvd/diagram.h"

namespace gvd {

/// A part of a diagram. What it holds of the labels it was traced for, their loops, arcs, Voronoi
/// points and cells, is as in the whole diagram; what it holds of others is not, and areas are
/// those in the faces it was traced in only.
struct PartialDiagram {
  Diagram diagram;
  /// Whether that is certain. It is not where points have become one: then the order of labels
  /// around a Voronoi point follows from the loops of all of them, which must be traced as well.
  bool isSure;
};

/// Traces the loops of the labels for which `isTraced`, one per label, says so, in some faces,
/// given ascending: all those of which one of these labels is known at a corner, and another one.
/// O(F + M log M), with little for each face.
PartialDiagram traceFaces(const TriangleMesh& mesh, const DistanceField& distances,
                          const DiagramOptions& options, std::span<const int> faces,
                          std::span<const char> isTraced);

}  // namespace gvd
