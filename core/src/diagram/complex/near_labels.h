// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "distance/ties.h"
#include "gvd/geodesic.h"

namespace gvd {

/// A label that may be nearest somewhere in an element.
struct NearLabel {
  int label;
  std::array<bool, 3> isKnown;  ///< at the corners of the element
};

/// Lists the near labels of an element in `near`, ascending, given the labels known at its corners
/// and the lengths of its sides. Many labels may be known at the corners of a long face, few are
/// near any of its parts. A label is left out if, by the triangle inequality, some label known at
/// all corners is nearer everywhere. DGPC's distances violate the inequality here and there, so the
/// labels that are nearest at a corner always stay.
void findNearLabels(const std::array<std::span<const LabelledDistance>, 3>& known,
                    const std::array<double, 3>& lengths, const TieTolerance& ties,
                    std::vector<NearLabel>& near);

}  // namespace gvd
