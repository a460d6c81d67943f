// SPDX-License-Identifier: MIT
#include "mesh/building/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/given_triangles.h"

namespace gvd {
namespace {

/// The next larger integer that a double can represent; beyond 2^53, some are skipped.
double after(double x) {
  return std::max(x + 1, std::nextafter(x, std::numeric_limits<double>::infinity()));
}

}  // namespace

void PointGrid::add(int v) {
  int& last = last_[bucketOf(cubeOf(positionOf(positions_, v)))];
  entries_.push_back({v, last});
  last = static_cast<int>(entries_.size()) - 1;
}

std::vector<int> PointGrid::near(const Eigen::Vector3d& p) const {
  // Rounding is monotone, so no point within the radius is in a cube beyond these.
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius_);
  const Cube low = cubeOf(p - reach), high = cubeOf(p + reach);
  std::vector<int> near;
  for (double x = low[0]; x <= high[0]; x = after(x))
    for (double y = low[1]; y <= high[1]; y = after(y))
      for (double z = low[2]; z <= high[2]; z = after(z))
        for (int i = last_[bucketOf({x, y, z})]; i >= 0; i = entries_[i].before) {
          const int v = entries_[i].point;
          if ((positionOf(positions_, v) - p).norm() <= radius_) near.push_back(v);
        }
  return near;
}

/// The cube of a point. Cubes are four radii wide: a ball meets eight at most. Coordinates are
/// clamped to finite numbers if the quotient overflows, because infinity has no next cube.
PointGrid::Cube PointGrid::cubeOf(const Eigen::Vector3d& p) const {
  constexpr double kMost = std::numeric_limits<double>::max();
  Cube cube;
  for (int i = 0; i < 3; ++i) cube[i] = std::clamp(std::floor(p[i] / (4 * radius_)), -kMost, kMost);
  return cube;
}

}  // namespace gvd
