// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>

#include "mesh/nearest_on_triangle.h"
#include "mesh/triangle_tree.h"

namespace gvd {

/// The one-sided Hausdorff distance: the largest distance of a point of some triangles from others,
/// by branch and bound. Triangles and their parts are halved, at their longest sides, as long as
/// one may have a point that is farther by a hundredth than the farthest one found so far, the one
/// with the largest bound first. The distance from one triangle is convex, so no point of a
/// part is farther from it than a corner is: of the triangles nearest to the corners, the best one
/// gives the bound.
class OneSidedHausdorff {
 public:
  /// Trees that are built, and must outlive this. The search is for distances above `least`. Where
  /// both surfaces are the same, it would never end: there are no more than 4096 halvings, and four
  /// for each square of side `resolution` that the triangles' area is worth, up to 4096 squares of
  /// one triangle.
  OneSidedHausdorff(const TriangleTree& from, const TriangleTree& to, double least,
                    double resolution);

  bool step(long& budget);

  /// The distance of the farthest point found, or `least`; infinite if there is no triangle to
  /// measure from, or a position is not finite.
  double distance() const { return distance_; }

 private:
  /// A few milliseconds' worth: small meshes are searched to the end.
  static constexpr double kLeastHalvings = 4096;

  struct Corner {
    Eigen::Vector3d position;
    int nearest;  ///< of the other triangles
  };
  struct Part {
    std::array<Corner, 3> corners;
    double bound;  ///< no point is farther
    /// In the order in which parts were made; of equal bounds, the first comes first.
    std::int64_t number;

    bool operator<(const Part& other) const {
      return std::pair(bound, other.number) < std::pair(other.bound, number);
    }
  };

  void enter(const SpaceTriangle& triangle);
  bool isAnyToHalve() const;
  void halveNext();
  void add(const std::array<Corner, 3>& corners);
  Corner cornerAt(const Eigen::Vector3d& position);
  bool mayBeFarther(double bound) const;

  const TriangleTree& from_;
  const TriangleTree& to_;
  const double resolution_;
  double distance_;
  std::size_t next_ = 0;             ///< triangle
  std::priority_queue<Part> parts_;  ///< by bound
  std::int64_t partCount_ = 0;
  double halvingsLeft_ = kLeastHalvings;
  int lastNearest_ = 0;  ///< of the other triangles, to the last corner
};

}  // namespace gvd
