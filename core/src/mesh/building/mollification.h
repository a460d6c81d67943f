// SPDX-License-Identifier: MIT
//
// Intrinsic mollification: N. Sharp, K. Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020,
// section 4.5. All edges are lengthened by one amount, the least that leaves no triangle flat.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace gvd {

/// The least excess of two sides of a triangle over the third, as a share of the mean edge length,
/// or of the triangle's longest side if that is longer: the rounding of a side of 100,000 mean
/// edges is larger than this share of one mean edge.
///
/// The paper, for Laplacians, takes 1e-5 of the mean. Why 1e-11 here:
///  - Rounding changes an excess by up to 3.3e-16 (3 · 2^-53) of the longest side, so at the margin
///    an excess still has four correct digits.
///  - The margin exceeds `kDistanceTolerance` (4.5e-13) of a distance of twenty mean edges: up to
///    there, the two ways past a flat triangle are not taken for a tie.
///  - No edge is shorter than half the margin, so distances of 10,000 mean edges still tell its two
///    ends apart.
///  - A flat triangle of side c becomes one of height c · sqrt(margin / 2) = 2e-6 c. Distances
///    across it are off by as much. 1e-5 would make it 2e-3 c.
///  - A triangle of longest side c with two angles of a degrees has the excess a² · 1.5e-4 c, which
///    is at the margin for 3e-4 degrees. Triangles of scans are thicker, and so are those of almost
///    all random test meshes whose distances are compared with other programs at 1e-9. A margin of
///    1e-10 would mollify one in a hundred of these meshes.
inline constexpr double kMollificationMargin = 1e-11;

/// The measures of a triangle, wherever it lies. Side i runs from corner i to the next.
struct IntrinsicTriangle {
  std::array<double, 3> lengths;  ///< of side i
  std::array<double, 3> dots;     ///< at corner i: of the two sides that leave it
  std::array<double, 3> excess;   ///< at corner i: how much longer its two sides are than the third
  double twiceArea;

  double longestSide() const { return *std::max_element(lengths.begin(), lengths.end()); }
  double leastExcess() const { return *std::min_element(excess.begin(), excess.end()); }
};

/// Measures the triangle of three points in space. Lengths have the same bits whichever way a side
/// runs. Excess and area have full relative precision, given the differences of coordinates:
/// computed from the rounded lengths, they would cancel in needles and caps. If points coincide,
/// they are zero, not NaN. Products of four lengths must neither overflow nor underflow.
IntrinsicTriangle measureTriangle(const std::array<Eigen::Vector3d, 3>& corners);

/// The least excess required of a triangle with this longest side.
inline double leastExcessWanted(double longestSide, double meanEdgeLength) {
  return kMollificationMargin * std::max(longestSide, meanEdgeLength);
}

/// The triangle with all sides lengthened by `amount`; the same bits if that is zero. The area is
/// by Heron's formula in Kahan's form, which subtracts no almost equal numbers.
IntrinsicTriangle lengthened(const IntrinsicTriangle& triangle, double amount);

}  // namespace gvd
