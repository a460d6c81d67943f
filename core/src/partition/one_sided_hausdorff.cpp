// SPDX-License-Identifier: MIT
// This work is based on:
// Min Tang, Minkyoung Lee, Young Kim. Interactive Hausdorff Distance Computation for General
// Polygonal Models. 2009
#include "partition/one_sided_hausdorff.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

/// The largest distance of three points from a triangle.
double farthestFrom(const SpaceTriangle& triangle, const SpaceTriangle& points) {
  double most = 0;
  for (const Vector3d& p : points)
    most = std::max(most, nearestOnTriangle(p, triangle).squaredDistance);
  return std::sqrt(most);
}

}  // namespace

OneSidedHausdorff::OneSidedHausdorff(const TriangleTree& from, const TriangleTree& to, double least,
                                     double resolution)
    : from_(from),
      to_(to),
      resolution_(resolution),
      distance_(to.triangles().empty() ? kInfinity : least) {}

bool OneSidedHausdorff::step(long& budget) {
  constexpr long kUnitsPerPart = 8;  // most of it to search the tree
  for (; distance_ < kInfinity; budget -= kUnitsPerPart) {
    const bool areAllEntered = next_ == from_.triangles().size();
    if (areAllEntered && !isAnyToHalve()) return true;
    if (budget <= 0) return false;
    if (areAllEntered)
      halveNext();
    else
      enter(from_.triangles()[next_++]);
  }
  return true;
}

/// Adds a triangle, unless the one that was nearest last shows that no point of it is farther:
/// neighbours mostly follow one another, and are near the same.
void OneSidedHausdorff::enter(const SpaceTriangle& triangle) {
  constexpr double kHalvingsPerSquare = 4, kMostSquares = 4096;
  const auto& [a, b, c] = triangle;
  if ((a + b + c).allFinite() &&
      !mayBeFarther(farthestFrom(to_.triangles()[lastNearest_], triangle)))
    return;
  const double area = (b - a).cross(c - a).norm() / 2;
  halvingsLeft_ += kHalvingsPerSquare * std::min(kMostSquares, area / (resolution_ * resolution_));
  add({cornerAt(a), cornerAt(b), cornerAt(c)});
}

bool OneSidedHausdorff::isAnyToHalve() const {
  return !parts_.empty() && mayBeFarther(parts_.top().bound) && halvingsLeft_ > 0;
}

void OneSidedHausdorff::halveNext() {
  const std::array<Corner, 3> corners = parts_.top().corners;
  parts_.pop();
  --halvingsLeft_;
  const auto& [a, b, c] = corners;
  const int from = longestSide({a.position, b.position, c.position}), to = cornerAfter(from);
  const Corner middle = cornerAt((corners[from].position + corners[to].position) / 2);
  for (const int replaced : {from, to}) {
    std::array<Corner, 3> half = corners;
    half[replaced] = middle;
    add(half);
  }
}

/// Keeps a part that may be farther than the farthest point so far.
void OneSidedHausdorff::add(const std::array<Corner, 3>& corners) {
  if (distance_ == kInfinity) return;
  const auto& [a, b, c] = corners;
  double bound = kInfinity;
  for (const Corner& corner : corners) {
    bound = std::min(
        bound, farthestFrom(to_.triangles()[corner.nearest], {a.position, b.position, c.position}));
    if (!mayBeFarther(bound)) return;
  }
  parts_.push({corners, bound, partCount_++});
}

OneSidedHausdorff::Corner OneSidedHausdorff::cornerAt(const Vector3d& position) {
  const NearestOfTriangles nearest = to_.nearest(position);
  distance_ = std::max(distance_, std::sqrt(nearest.squaredDistance));
  if (nearest.triangle >= 0) lastNearest_ = nearest.triangle;
  return {position, nearest.triangle};
}

/// Whether a bound exceeds the farthest distance so far by more than the tolerance.
bool OneSidedHausdorff::mayBeFarther(double bound) const {
  constexpr double kTolerance = 0.01;
  return bound > (1 + kTolerance) * distance_;
}

}  // namespace gvd
