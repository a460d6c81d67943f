// SPDX-License-Identifier: MIT
//
// What counts as equal: of distances, and of points of a diagram.
#pragma once

#include <span>

#include "gvd/geodesic.h"

namespace gvd {

/// The relative rounding error that distances may carry, and so the one answer to "is this a tie?".
/// One unfolding rounds by a few 2^-53, amplified by at most the ratio of distance to edge length;
/// over the some hundred unfoldings of a path that stays below 2^-44 on all meshes measured. 2^-41
/// leaves a margin of eight and is still too small to see: a bisector moves by less than
/// 2^-41 · d² / |s - s'| where two distances are taken for equal that are not.
inline constexpr double kDistanceTolerance = 0x1p-41;

/// Points of a diagram are one point if their error bounds overlap; this caps the bounds, as a
/// share of the longest edge at hand, where nearly parallel bisectors would make them large.
inline constexpr double kMaxPointError = 1e-9;

/// Makes those distances at one place equal that are equal up to rounding, to the least of them.
/// Every list that a diagram is traced from has passed here, so that later comparisons can be
/// exact.
void equalizeTies(std::span<LabelledDistance> here);

}  // namespace gvd
