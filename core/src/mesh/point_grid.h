// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <span>
#include <vector>

namespace gvd {

/// Points in a grid of cubes, to find those near a place.
class PointGrid {
 public:
  /// `positions` must outlive this.
  PointGrid(std::span<const double> positions, double radius)
      : positions_(positions), radius_(radius) {}

  void add(int v);
  /// The lowest index of a point within the radius, -1 if there is none.
  int firstNear(const Eigen::Vector3d& p) const;

 private:
  using Cube = std::array<double, 3>;
  Cube cubeOf(const Eigen::Vector3d& p) const;
  Eigen::Vector3d position(int v) const;

  const std::span<const double> positions_;
  const double radius_;
  std::map<Cube, std::vector<int>> cubes_;
};

}  // namespace gvd
