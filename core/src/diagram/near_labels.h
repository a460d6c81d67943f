// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "distance/ties.h"
#include "gvd/geodesic.h"

namespace gvd {

/// Finds the labels that may be nearest somewhere in an element. Many labels may be known at the
/// corners of a long face, few are near any of its parts.
class NearLabels {
 public:
  struct Label {
    int label;
    std::array<bool, 3> isKnown;  ///< at the corners of the element
  };

  explicit NearLabels(const TieTolerance& ties) : ties_(ties) {}
  /// The labels of an element, ascending, given those known at its corners and the lengths of its
  /// sides; valid until the next call. Left out is what some label that is known at all corners is
  /// nearer than everywhere, by the triangle inequality. DGPC's distances break it here and there:
  /// what is nearest at a corner stays in any case.
  std::span<const Label> of(const std::array<std::span<const LabelledDistance>, 3>& known,
                            const std::array<double, 3>& lengths);

 private:
  const TieTolerance& ties_;
  std::vector<Label> near_;
};

}  // namespace gvd
