// SPDX-License-Identifier: MIT
//
// Tolerances within which distances, points and shapes count as equal. A tolerance that only one
// computation uses is defined there: the margin of mollification.h, the error bounds of
// predicates.cpp, the tolerances of windows in distance/exact.
#pragma once

#include <span>

#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The relative rounding error that distances may carry. One unfolding rounds by a few 2^-53,
/// amplified by at most the ratio of distance to edge length; over the hundred or so unfoldings of
/// a path, the error stayed below 2^-44 on all meshes measured. 2^-41 leaves a margin of eight and
/// is still too small to see: where two different distances d count as equal, the bisector of the
/// sites s and s' moves by less than 2^-41 · d² / |s - s'|.
inline constexpr double kDistanceTolerance = 0x1p-41;

/// Which distances on a mesh are equal up to rounding: all decisions on ties are made here. The
/// absolute part of the tolerance is for faces much larger than the distances in them: unfolding
/// across one of them rounds by a few 2^-53 of its size, across a hundred of them by 2^-46 of the
/// longest edge.
class TieTolerance {
 public:
  explicit TieTolerance(const TriangleMesh& mesh);
  /// Whether a distance is at most another one, up to rounding.
  bool isAtMost(double distance, double other) const {
    return distance <= other * (1 + kDistanceTolerance) + absolute_;
  }
  /// Whether two distances are equal up to rounding, but not exactly.
  bool tieUnequally(double a, double b) const { return a != b && isAtMost(a, b) && isAtMost(b, a); }

 private:
  double absolute_;
};

/// Points of a diagram are one point if their error bounds overlap; this caps the bounds, in
/// barycentric coordinates, where nearly parallel bisectors would make them large. A tenth of the
/// width of the thinnest faces, as a share of their length (`kMollificationMargin`), so that a
/// region as long as such a face is wide is not lost.
inline constexpr double kMaxPointError = 1e-12;

/// Barycentric coordinates below this are set to zero in points given by callers: 512 times the
/// rounding 2^-53, and less than `kMaxPointError`.
inline constexpr double kCoordinateRounding = 0x1p-44;

/// The error allowed in barycentric coordinates given by callers: some were written with single
/// precision, 2^-24 = 6e-8, and summed.
inline constexpr double kBarycentricTolerance = 1e-6;

/// How far rounding may move the place on an edge where two squared distances are equal, as a share
/// of the edge. The place is a quotient of their differences, which are exact where they are small,
/// so it rounds by a few 2^-53.
inline constexpr double kEdgeShareRounding = 1e-14;

/// How far rounding may move an unfolded point beyond an end or the line of a halfedge, as a share
/// of lengths.
inline constexpr double kUnfoldingRounding = 1e-12;

/// A line that passes a vertex closer than this, as a share of an edge or in radians, meets the
/// vertex: some thousand times the rounding of a coordinate.
inline constexpr double kVertexSnap = 1e-12;

/// The mean distortion of a region's logarithmic map (`WorstRegion::kMostDistorted`) that rounding
/// of distances and of their differences can cause.
inline constexpr double kFlatDistortion = 1e-12;

/// A mean squared curvature comes from the rounding of angles if its product with the square of the
/// mesh's size is below this.
inline constexpr double kFlatCurvature = 1e-9;

/// Sets distances at one place that are equal up to rounding to the least of them. All distances
/// that a diagram is traced from pass through here, so that later comparisons can be exact.
void equalizeTies(std::span<LabelledDistance> here, const TieTolerance& ties);

}  // namespace gvd
