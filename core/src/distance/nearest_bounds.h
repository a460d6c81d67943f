// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/sliced_loop.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// At each vertex, the least distance known so far, an upper bound on that of the nearest site, and
/// its label; -1 while the distance is only the length of a path along edges. Once all labels have
/// spread, the label is the lowest of those that tie with the least distance: the owner
/// (`KnownLabels`).
class NearestBounds {
 public:
  explicit NearestBounds(const TriangleMesh& mesh, double distance = kInfinity)
      : ties_(mesh), vertexCount_(mesh.vertexCount()), first_{-1, distance} {}
  /// Makes room, in slices; true when it is there. Before anything else.
  bool prepare(long& budget) { return fillInSlices(nearest_, vertexCount_, first_, budget); }

  const LabelledDistance& operator[](int vertex) const { return nearest_[vertex]; }
  LabelledDistance& operator[](int vertex) { return nearest_[vertex]; }
  const TieTolerance& ties() const { return ties_; }

  /// Lowers a bound by the distance of a label. A label takes over the bound by a path along edges
  /// even if rounding makes its distance longer than that path.
  void lower(int vertex, int label, double distance) {
    LabelledDistance& bound = nearest_[vertex];
    const bool isFirst = bound.label < 0 && ties_.isAtMost(distance, bound.distance);
    if (isFirst || distance < bound.distance) bound = {label, distance};
  }

 private:
  TieTolerance ties_;
  const int vertexCount_;
  const LabelledDistance first_;
  std::vector<LabelledDistance> nearest_;
};

}  // namespace gvd
