// SPDX-License-Identifier: MIT
//
// What counts as equal: of distances, of points, of shapes. The one table, but for what belongs to
// one computation: the margin of mollification.h, the error bounds of predicates.cpp, and what
// windows may differ by, in distance/exact.
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

/// Points of a diagram are one point if their error bounds overlap; this caps the bounds, in
/// barycentric coordinates, where nearly parallel bisectors would make them large. A tenth of what
/// the thinnest faces are wide, as a share of their length (`kMollificationMargin`), so that no
/// region gets lost that is as long as wide there.
inline constexpr double kMaxPointError = 1e-12;

/// Barycentric coordinates of sites below this are zero: 512 times what one rounds by, 2^-53, and
/// less than `kMaxPointError`.
inline constexpr double kCoordinateRounding = 0x1p-44;

/// How far barycentric coordinates may be off that come from elsewhere: some have been written with
/// single precision, 2^-24 = 6e-8, and summed.
inline constexpr double kBarycentricTolerance = 1e-6;

/// How far rounding may move the place on an edge where two squared distances are equal, as a share
/// of the edge. That is a quotient of their differences, which are exact where they are small: it
/// rounds by a few 2^-53.
inline constexpr double kEdgeShareRounding = 1e-14;

/// How far rounding may move what is unfolded, beyond a halfedge or its line, as a share of
/// lengths.
inline constexpr double kUnfoldingRounding = 1e-12;

/// What passes a vertex closer than this, as a share of an edge or in radians, meets it: some
/// thousand times what a coordinate rounds by.
inline constexpr double kVertexSnap = 1e-12;

/// A mean distortion below this is rounding: of distances, and of the difference that it comes
/// from.
inline constexpr double kFlatDistortion = 1e-12;

/// So is a mean squared curvature below this, times the square of the mesh's size: angles round.
inline constexpr double kFlatCurvature = 1e-9;

/// Makes those distances at one place equal that are equal up to rounding, to the least of them.
/// Every list that a diagram is traced from has passed here, so that later comparisons can be
/// exact. Whether any distance has changed.
bool equalizeTies(std::span<LabelledDistance> here);

}  // namespace gvd
