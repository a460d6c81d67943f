// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/lanes.h"
#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd::exact {

/// The vertices or other points at which the distance of a label is required although another label
/// is nearer. The label's windows go on only as far as they can still shorten one of these
/// distances.
///
/// Every waiting window is compared with every place, so the numbers are kept in single precision,
/// four in a register: in bounding diagonals, and rounded so that a window never stops too early.
class RequiredDistances {
 public:
  /// The index of no place.
  static constexpr int kNone = 0;

  explicit RequiredDistances(double boundingDiagonal) : scale_(1 / boundingDiagonal) { clear(); }

  void clear() {
    blocks_.assign(1, Block{});
    distances_.assign(1, {});
    mostExcess_ = 0;
  }

  /// How many quick rounds `canGain` takes.
  std::size_t cost() const { return 1 + blocks_.size() / kLanes; }

  /// `distance` is the least of the label known so far, `nearest` that of the nearest label.
  /// Returns the index of the place, the next one after `kNone`.
  int add(const Eigen::Vector3d& position, double distance, double nearest) {
    const int index = static_cast<int>(distances_.size()), lane = index % kLanes;
    if (lane == 0) blocks_.emplace_back();
    Block& block = blocks_.back();
    block.x[lane] = static_cast<float>(scale_ * position.x());
    block.y[lane] = static_cast<float>(scale_ * position.y());
    block.z[lane] = static_cast<float>(scale_ * position.z());
    distances_.push_back({distance, nearest});
    limit(index);
    return index;
  }
  /// The least distance of the label known so far.
  double distance(int index) const { return distances_[index].own; }
  void lower(int index, double distance) {
    if (!(distance < distances_[index].own)) return;
    distances_[index].own = distance;
    limit(index);
  }
  /// The largest excess over the nearest label's distance with which a path can still shorten any
  /// required distance, when `findMostExcess` was last called.
  double mostExcess() const { return mostExcess_; }
  void findMostExcess() {
    float most = 0;
    for (const Block& block : blocks_)
      for (int lane = 0; lane < kLanes; ++lane) most = std::max(most, block.excess[lane]);
    mostExcess_ = most / scale_;
  }
  /// Whether paths of at least `length` to points within `radius` of `place` can become the
  /// shortest to a required place. The rest of a path is at least as long as the straight line in
  /// space, and its `excess` over the distance of the nearest label does not fall along the way.
  /// Ignores the places whose indices `visitIgnored` passes to the function given to it.
  template <class VisitIgnored>
  bool canGain(const Eigen::Vector3d& place, double radius, double length, double excess,
               VisitIgnored visitIgnored) const {
    const Eigen::Vector3f p = (scale_ * place).cast<float>();
    const float reach = roundedUp(scale_ * (radius - length)) + kPlaceRounding;
    const float least = -roundedUp(-scale_ * excess);
    const auto gainsIn = [&](const Block& block) {  // -1 where there is a gain
      const FloatLanes rest = block.bound + reach;
      const FloatLanes dx = block.x - p.x(), dy = block.y - p.y(), dz = block.z - p.z();
      return (rest > 0) & (dx * dx + dy * dy + dz * dz < rest * rest) & (block.excess > least);
    };
    auto gains = gainsIn(blocks_[0]);
    for (size_t i = 1; i < blocks_.size(); ++i) gains += gainsIn(blocks_[i]);
    int count = -(gains[0] + gains[1] + gains[2] + gains[3]);
    if (count == 0) return false;
    visitIgnored([&](int i) { count += gainsIn(blocks_[i / kLanes])[i % kLanes]; });
    return count > 0;
  }

 private:
  /// The relative rounding error of a few operations in single precision, each 2^-24.
  static constexpr double kRounding = 0x1p-21;
  /// That of the distance between two places, in bounding diagonals.
  static constexpr float kPlaceRounding = 0x1p-20F;

  /// Paths that tie with the distance can still become the shortest.
  void limit(int index) {
    const auto [own, nearest] = distances_[index];
    const double most = own * (1 + kDistanceTolerance);
    Block& block = blocks_[index / kLanes];
    block.bound[index % kLanes] = roundedUp(scale_ * most);
    block.excess[index % kLanes] = roundedUp(scale_ * (most - nearest));
  }

  /// A value in single precision, not smaller.
  static float roundedUp(double value) {
    return static_cast<float>(value + kRounding * std::abs(value));
  }

  /// Four places. `bound` and `excess` are what paths must stay below.
  static constexpr int kLanes = 4;
  struct Block {
    FloatLanes x = {}, y = {}, z = {};
    FloatLanes bound = FloatLanes{} - std::numeric_limits<float>::infinity();
    FloatLanes excess = bound;
  };

  /// Of the label, and of the nearest one.
  struct Distances {
    double own = 0, nearest = 0;
  };

  const double scale_;
  // Both by index; the first place is that of `kNone`.
  std::vector<Block> blocks_;
  std::vector<Distances> distances_;
  double mostExcess_ = 0;
};

}  // namespace gvd::exact
