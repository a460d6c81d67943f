// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/site_distances.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The faces where the known distances of labels overlap: of each label, those with a corner where
/// it and another label are known. Only there can its bisectors run.
class OverlapFaces {
 public:
  /// All arguments must outlive this.
  OverlapFaces(const TriangleMesh& mesh, const SiteDistances& distances)
      : mesh_(mesh), distances_(distances), faces_(mesh.faceCount()) {}

  /// Follows the last change of the distances, in slices; true when done. `labels` are those that
  /// it has changed.
  bool update(const IndexSet& labels, long& budget);
  /// The faces where any of some labels overlaps others; ascending.
  std::vector<int> of(std::span<const int> labels);

 private:
  void forgetChanged(const IndexSet& labels);
  void note(int face, const IndexSet& labels);

  const TriangleMesh& mesh_;
  const SiteDistances& distances_;
  std::vector<std::vector<int>> ofLabel_;

  IndexSet faces_;  ///< working memory of `of`
  SlicedSequence sequence_;
};

}  // namespace gvd
