// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle_tree.h"

namespace gvd {

/// The one-sided Hausdorff distance: the largest distance of a point of some triangles from others,
/// by branch and bound. The parts of each triangle are halved, at their longest sides, as long as
/// they may have a point that is farther by a hundredth than the farthest one found so far. The
/// distance from one triangle is convex, so no point of a part is farther from it than a corner is:
/// of the triangles nearest to the corners, the best one gives the bound.
class OneSidedHausdorff {
 public:
  /// Trees that are built, and must outlive this. The search is for distances above `least`. Where
  /// both surfaces are the same, it would never end: a triangle is halved no more than about 16
  /// times for each square of side `resolution` that its area is worth, up to 4096 squares.
  OneSidedHausdorff(const TriangleTree& from, const TriangleTree& to, double least,
                    double resolution);
  bool step(long& budget);
  /// The distance of the farthest point found, or `least`; infinite if there is no triangle to
  /// measure from, or a position is not finite.
  double distance() const { return distance_; }

 private:
  struct Corner {
    Eigen::Vector3d position;
    int nearest;  ///< of the other triangles
  };
  struct Part {
    std::array<Corner, 3> corners;
    double bound;  ///< no point is farther
  };

  void enter(const SpaceTriangle& triangle);
  void halve(const Part& part);
  void add(const std::array<Corner, 3>& corners);
  Corner cornerAt(const Eigen::Vector3d& position);
  bool mayBeFarther(double bound) const;

  const TriangleTree& from_;
  const TriangleTree& to_;
  const double resolution_;
  double distance_;
  std::size_t next_ = 0;     ///< triangle
  std::vector<Part> parts_;  ///< of the last triangle
  std::size_t nextPart_ = 0;
  long halvingsLeft_ = 0;  ///< of that triangle
  int lastNearest_ = 0;    ///< of the other triangles, to the last corner
};

}  // namespace gvd
