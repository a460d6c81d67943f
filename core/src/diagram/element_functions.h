// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "diagram/face_complex.h"
#include "diagram/face_envelope.h"

namespace gvd {

/// The squared distances of labels on one element after the other, as linear functions.
class ElementFunctions {
 public:
  explicit ElementFunctions(const FaceComplex& complex);
  /// Those of the labels known at all three nodes of an element, but not of labels that are behind
  /// one owner of a node everywhere; of a label that owns all of the element, its own alone.
  /// Ascending by label; good until the next call.
  std::span<const LabelFunction> of(int element);

 private:
  void dropHidden(const int* nodes);

  const FaceComplex& complex_;
  /// What distances are multiplied by: a power of two, so that nothing is rounded, by which they
  /// are about 1. Determinants have products of six distances.
  const double unit_;
  std::vector<LabelFunction> functions_;
};

}  // namespace gvd
