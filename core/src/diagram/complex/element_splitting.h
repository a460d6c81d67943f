// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "diagram/complex/elements.h"
#include "diagram/complex/near_labels.h"
#include "diagram/complex/node_labels.h"
#include "diagram/complex/required_labels.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Splits mixed elements at the middles of their sides until no side is longer than a limit, with
/// distances at the new nodes. Also splits neighbours until every side between elements of
/// different size has a single owner.
class ElementSplitting {
 public:
  ElementSplitting(const TriangleMesh& mesh, const TieTolerance& ties,
                   const DistanceField& distances, double longestSide, Elements& elements,
                   NodeLabels& nodes)
      : mesh_(mesh),
        ties_(ties),
        longestSide_(longestSide),
        elements_(elements),
        nodes_(nodes),
        required_(distances, ties, nodes) {}
  bool step(long& budget);
  /// The number of elements, and of those that the current batch is about to become.
  double expectedCount() const {
    constexpr double kAdded = 3;  // by an element whose sides are all split
    return elements_.count() + kAdded * static_cast<double>(batch_.size()) * required_.progress();
  }

 private:
  bool splitBatch(long& budget);
  bool findBatch(SlicedLoop& loop, long& budget);
  bool mustSplit(int element) const;
  bool isSideSplit(int element, int side, double length) const;
  bool isUniform(const ElementSide& side, int owner) const;
  void addMiddles(int element);
  int middleOf(int element, int i);
  void split(int element, const std::array<int, 3>& middle);
  int node(int element, int corner) const { return elements_.nodes(element)[corner]; }
  ElementSide sideOf(int element, int i) const { return elements_.side(mesh_, 3 * element + i); }

  const TriangleMesh& mesh_;
  const TieTolerance& ties_;
  const double longestSide_;
  Elements& elements_;
  NodeLabels& nodes_;

  SlicedSequence round_, split_;
  bool isFirstRound_ = true;
  /// The nodes of the elements split last, and of those larger ones that their sides are part of.
  IndexSet nearSplit_{0};
  std::vector<int> batch_;                   ///< elements to be split next
  std::vector<std::array<int, 3>> middles_;  ///< of the sides of each; -1: the side stays whole
  std::vector<NearLabel> near_;              ///< of the current element
  RequiredLabels required_;
};

}  // namespace gvd
