// SPDX-License-Identifier: MIT
//
// Tolerances within which distances, points and shapes count as equal. A tolerance that only one
// computation uses is defined there: the margin of mollification.h, the error bounds of
// predicates.cpp, the tolerances of windows in distance/exact.
#pragma once

namespace gvd {

/// The relative rounding error that distances may carry. One unfolding rounds by a few 2^-53,
/// amplified by at most the ratio of distance to edge length; over the hundred or so unfoldings of
/// a path, the error stayed below 2^-44 on all meshes measured. 2^-41 leaves a margin of eight and
/// is still too small to see: where two different distances d count as equal, the bisector of the
/// sites s and s' moves by less than 2^-41 · d² / |s - s'|.
inline constexpr double kDistanceTolerance = 0x1p-41;

/// Points of a diagram are one point if their error bounds overlap; this caps the bounds, in
/// barycentric coordinates, where nearly parallel bisectors would make them large. A tenth of the
/// width of the thinnest faces, as a share of their length (`kMollificationMargin`), so that a
/// region as long as such a face is wide is not lost.
inline constexpr double kMaxPointError = 1e-12;

/// The error allowed in barycentric coordinates given by callers: some were written with single
/// precision, 2^-24 = 6e-8, and summed.
inline constexpr double kBarycentricTolerance = 1e-6;

/// A line that passes a vertex closer than this, as a share of an edge or in radians, meets the
/// vertex: some thousand times the rounding of a coordinate.
inline constexpr double kVertexSnap = 1e-12;

}  // namespace gvd
