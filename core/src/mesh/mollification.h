// SPDX-License-Identifier: MIT
//
// Intrinsic mollification: N. Sharp, K. Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020,
// section 4.5. Edges are lengthened by the same least amount, until every triangle is one.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace gvd {

/// The least excess of two sides of a triangle over the third, as a share of the mean edge length,
/// or of the triangle's longest side where that is longer: the rounding of a side of 100,000 mean
/// edges is no less than the share of one.
///
/// Why 1e-11, where the paper, for Laplacians, takes 1e-5 of the mean:
///  - Rounding moves an excess by up to 3.3e-16 (3 · 2^-53) of the longest side, so at the margin
///    it still has four true digits.
///  - It is more than `kDistanceTolerance`, 4.5e-13, of a distance of twenty mean edges: there, the
///    two ways past a flat triangle are no tie.
///  - No edge is shorter than half the margin, so distances of 10,000 mean edges still tell its two
///    ends apart.
///  - A flat triangle of side c becomes one of height c · sqrt(margin / 2) = 2e-6 c. Distances
///    across it are off by as much. 1e-5 would make it 2e-3 c.
///  - The excess of a triangle with two angles of a degrees is a² · 1.5e-4 c, which reaches the
///    margin at 3e-4 degrees: thinner than triangles of scans, and than almost all that the tests
///    draw at random to compare distances at 1e-9 with those of other programs. At 1e-10, one in a
///    hundred of those meshes would be mollified.
inline constexpr double kMollificationMargin = 1e-11;

/// A triangle by what does not depend on where it lies. Side i runs from corner i to the next.
struct IntrinsicTriangle {
  std::array<double, 3> lengths;  ///< of side i
  std::array<double, 3> dots;     ///< at corner i: of the two sides that leave it
  std::array<double, 3> excess;   ///< at corner i: how much longer its two sides are than the third
  double twiceArea;

  double leastExcess() const { return *std::min_element(excess.begin(), excess.end()); }
};

/// Of three points in space. Lengths have the same bits whichever way a side runs. Excess and area
/// have full relative precision, given the differences of coordinates: they do not come from the
/// rounded lengths, in which those of needles and caps would cancel. Zero, not NaN, for points that
/// coincide. Products of four lengths must neither overflow nor underflow.
IntrinsicTriangle measureTriangle(const std::array<Eigen::Vector3d, 3>& corners);

/// The least excess that a triangle with this longest side must have.
inline double leastExcessWanted(double longestSide, double meanEdgeLength) {
  return kMollificationMargin * std::max(longestSide, meanEdgeLength);
}

/// The triangle whose sides are longer by `amount`; the same bits if that is zero. Area and angles
/// follow from the lengths, by Heron's formula for the area, in Kahan's manner: without a
/// difference of almost equal numbers.
IntrinsicTriangle lengthened(const IntrinsicTriangle& triangle, double amount);

}  // namespace gvd
