// SPDX-License-Identifier: MIT
#include "mesh/building/mollification.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gvd/surface_point.h"

namespace gvd {
namespace {

double perimeterOf(const std::array<double, 3>& lengths) {
  return lengths[0] + lengths[1] + lengths[2];
}

}  // namespace

IntrinsicTriangle measureTriangle(const std::array<Eigen::Vector3d, 3>& corners) {
  IntrinsicTriangle t;
  std::array<Eigen::Vector3d, 3> sides;
  for (int i = 0; i < 3; ++i) {
    sides[i] = corners[cornerAfter(i)] - corners[i];
    t.lengths[i] = sides[i].norm();
  }
  // Of the two shorter sides, because the rounding of a cross product grows with its factors.
  const auto longestSide = std::max_element(t.lengths.begin(), t.lengths.end());
  const int longest = static_cast<int>(longestSide - t.lengths.begin());
  t.twiceArea = sides[cornerAfter(longest)].cross(sides[cornerBefore(longest)]).norm();

  const double perimeter = perimeterOf(t.lengths);
  for (int i = 0; i < 3; ++i) {
    t.dots[i] = -sides[i].dot(sides[cornerBefore(i)]);
    // (a + b)² - c² = (a + b - c) (a + b + c) = 2 (ab + a·b), and (ab + a·b) (ab - a·b) = |a×b|².
    const double product = t.lengths[i] * t.lengths[cornerBefore(i)];
    const double sum =
        t.dots[i] >= 0 ? product + t.dots[i] : t.twiceArea / (product - t.dots[i]) * t.twiceArea;
    t.excess[i] = perimeter > 0 ? 2 * sum / perimeter : 0;
  }
  return t;
}

IntrinsicTriangle lengthened(const IntrinsicTriangle& triangle, double amount) {
  if (amount == 0) return triangle;
  IntrinsicTriangle t = triangle;
  for (int i = 0; i < 3; ++i) {
    t.lengths[i] += amount;
    t.excess[i] += amount;
    t.dots[i] += amount * (triangle.excess[i] + amount / 2);  // (a² + b² - c²) / 2
  }
  t.twiceArea =
      std::sqrt(perimeterOf(t.lengths) * t.excess[0]) * std::sqrt(t.excess[1] * t.excess[2]) / 2;
  return t;
}

}  // namespace gvd
