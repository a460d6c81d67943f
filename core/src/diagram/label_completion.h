// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "diagram/face_complex.h"

namespace gvd {

/// Adds labels to a refined complex where an element's third node lacks one that owns part of the
/// side across. At its vertices a distance field promises that none is lacking (`DistanceField`),
/// but not at the nodes in between, at which those labels are known that are known at both ends of
/// a side. A label added may now own part of another side, hence elements where some were added are
/// looked at again until none is. An element of one owner lacks none: where that one is least at
/// all nodes, it is everywhere.
class LabelCompletion {
 public:
  explicit LabelCompletion(FaceComplex& complex) : complex_(complex) {}
  /// True when no element lacks a label any more.
  bool step(long& budget);
  /// The faces for which labels were added, some several times.
  std::vector<int> takeFaces() { return std::move(faces_); }

 private:
  using Labels = std::span<const LabelledDistance>;

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
