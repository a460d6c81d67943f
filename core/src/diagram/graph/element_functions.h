// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "diagram/complex/face_complex.h"
#include "diagram/graph/face_envelope.h"

namespace gvd {

/// The squared distances of labels on an element, as linear functions.
class ElementFunctions {
 public:
  explicit ElementFunctions(const FaceComplex& complex);
  /// The functions of the labels known at all three nodes of an element, ascending by label; valid
  /// until the next call. Of more than three, those farther everywhere than the owner of some node
  /// are left out; of an element with one owner, all but the owner's.
  std::span<const LabelFunction> of(int element);

 private:
  std::span<LabelFunction> withoutDominated(std::span<LabelFunction> functions,
                                            const int* nodes) const;

  const FaceComplex& complex_;
  /// Scales distances to about 1, because determinants multiply six of them. A power of two, so
  /// that scaling does not round.
  const double unit_;
  std::vector<LabelFunction> functions_;  ///< of the element first; never shortened
};

}  // namespace gvd
