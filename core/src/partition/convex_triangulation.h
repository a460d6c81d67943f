// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <vector>

namespace gvd {

/// The Delaunay triangulation of a convex polygon: of all its triangulations, the one whose least
/// angle is largest. Straight angles are allowed. Chords may be ruled out; they are taken only
/// where there is no other choice.
class ConvexTriangulation {
 public:
  using IsRuledOut = std::function<bool(int from, int to)>;

  /// `corners` counterclockwise, at least three. The result, n - 2 triangles of indices into them,
  /// is valid until the next call. O(n²).
  std::span<const std::array<int, 3>> compute(std::span<const Eigen::Vector2d> corners,
                                              const IsRuledOut& isRuledOut = {});

 private:
  int apex(int from, int to, const IsRuledOut& isRuledOut) const;

  std::span<const Eigen::Vector2d> corners_;
  std::vector<std::array<int, 2>> open_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace gvd
