// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/hashing.h"

namespace gvd {

/// Points in a grid of cubes, to find those near a place.
class PointGrid {
 public:
  /// For about `count` points; `positions` must outlive this.
  PointGrid(std::span<const double> positions, double radius, std::size_t count)
      : positions_(positions), radius_(radius), last_(count, -1) {
    entries_.reserve(count);
  }

  void add(int v);
  /// The points within the radius, in no particular order.
  std::vector<int> near(const Eigen::Vector3d& p) const;

 private:
  using Cube = std::array<double, 3>;
  Cube cubeOf(const Eigen::Vector3d& p) const;
  int bucketOf(const Cube& cube) const { return hashBelow(static_cast<int>(last_.size()), cube); }

  const std::span<const double> positions_;
  const double radius_;

  /// A point, and the entry before it in its bucket.
  struct Entry {
    int point, before;
  };
  std::vector<int> last_;  ///< entry of each bucket of cubes; -1 in an empty one
  std::vector<Entry> entries_;
};

}  // namespace gvd
