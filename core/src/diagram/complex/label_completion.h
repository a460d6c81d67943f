// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "diagram/complex/face_complex.h"

namespace gvd {

/// Adds missing labels to a refined complex: a label that owns part of a side of an element has to
/// be known at all three nodes. `DistanceField` guarantees this at vertices of the mesh, but a
/// midpoint only has labels known at both ends of its side (`ElementSplitting`). An added label may
/// own part of another side, so elements with added labels are checked again until nothing is
/// added. An element with one owner lacks no label: a function that is least at all nodes is least
/// everywhere.
class LabelCompletion {
 public:
  explicit LabelCompletion(FaceComplex& complex) : complex_(complex) {}
  /// True when no label is missing any more.
  bool step(long& budget);
  /// Whether any labels were added.
  bool hasAddedLabels() const { return !faces_.empty(); }
  /// The faces for which labels were added, with repetitions.
  std::vector<int> takeFaces() { return std::move(faces_); }

 private:
  void complete(int element);
  bool hasAddedLabels(int element) const;
  bool mayLackLabels(int element) const;
  bool completeAcross(int element, int side);
  double unfold(int element, int side, double atTail, double atTip) const;
  double squaredLength(int element, int from, int to) const;

  FaceComplex& complex_;
  SlicedLoop loop_;
  bool isFirstRound_ = true, hasChanged_ = false;
  std::vector<int> faces_;
};

}  // namespace gvd
