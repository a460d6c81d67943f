// SPDX-License-Identifier: MIT
// This work is based on:
// Min Tang, Minkyoung Lee, Young Kim. Interactive Hausdorff Distance Computation for General
// Polygonal Models. 2009
#include "partition/hausdorff.h"

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

/// The longest side of a triangle, from corner i to the next.
int longestSide(const SpaceTriangle& t) {
  int longest = 0;
  double most = 0;
  for (int i = 0; i < 3; ++i)
    if (const double length = (t[cornerAfter(i)] - t[i]).squaredNorm(); length > most) {
      most = length;
      longest = i;
    }
  return longest;
}

}  // namespace

OneSidedHausdorff::OneSidedHausdorff(const TriangleTree& from, const TriangleTree& to, double least,
                                     double resolution)
    : from_(from),
      to_(to),
      resolution_(resolution),
      distance_(to.triangles().empty() ? kInfinity : least) {}

bool OneSidedHausdorff::step(long& budget) {
  for (; distance_ < kInfinity; --budget) {
    const bool isTriangleDone = nextPart_ == parts_.size();
    if (isTriangleDone && next_ == from_.triangles().size()) return true;
    if (budget <= 0) return false;
    if (isTriangleDone) {
      enter(from_.triangles()[next_++]);
    } else {
      const Part part = parts_[nextPart_++];
      if (mayBeFarther(part.bound) && halvingsLeft_-- > 0) halve(part);
    }
  }
  return true;
}

/// Begins with a triangle, unless one that is near the triangle before shows that no point of it is
/// farther.
void OneSidedHausdorff::enter(const SpaceTriangle& triangle) {
  constexpr double kHalvingsPerSquare = 16, kMostSquares = 4096;
  parts_.clear();
  nextPart_ = 0;
  const auto& [a, b, c] = triangle;
  if ((a + b + c).allFinite() &&
      !mayBeFarther(farthestFrom(to_.triangles()[lastNearest_], triangle)))
    return;
  const double area = (b - a).cross(c - a).norm() / 2;
  const double squares = std::min(kMostSquares, area / (resolution_ * resolution_));
  halvingsLeft_ = static_cast<long>(kHalvingsPerSquare * squares) + 1;
  add({cornerAt(a), cornerAt(b), cornerAt(c)});
}

void OneSidedHausdorff::halve(const Part& part) {
  const auto& [a, b, c] = part.corners;
  const int from = longestSide({a.position, b.position, c.position}), to = cornerAfter(from);
  const Corner middle = cornerAt((part.corners[from].position + part.corners[to].position) / 2);
  for (const int replaced : {from, to}) {
    std::array<Corner, 3> half = part.corners;
    half[replaced] = middle;
    add(half);
  }
}

/// Keeps a part that may be farther than the farthest point so far.
void OneSidedHausdorff::add(const std::array<Corner, 3>& corners) {
  if (distance_ == kInfinity) return;
  const auto& [a, b, c] = corners;
  double bound = kInfinity;
  for (const Corner& corner : corners)
    bound = std::min(
        bound, farthestFrom(to_.triangles()[corner.nearest], {a.position, b.position, c.position}));
  if (mayBeFarther(bound)) parts_.push_back({corners, bound});
}

OneSidedHausdorff::Corner OneSidedHausdorff::cornerAt(const Vector3d& position) {
  const TriangleTree::Nearest nearest = to_.nearest(position);
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
