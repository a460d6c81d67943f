// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/tolerances.h"
#include "gvd/geodesic.h"

namespace gvd::exact {

/// The vertices or other points at which the distance of a label is required although another label
/// is nearer. The label's windows go on only as far as they can still shorten one of these
/// distances.
class RequiredPlaces {
 public:
  /// `rounding` is the error bound of distances between places in space.
  explicit RequiredPlaces(double rounding) : rounding_(rounding) {}

  void clear() {
    for (auto* values : {&x_, &y_, &z_, &bound_, &nearest_}) values->clear();
  }
  int size() const { return static_cast<int>(bound_.size()); }

  /// `bound` is the least distance of the label known so far, `nearest` the distance of the nearest
  /// label. Returns the index of the place.
  int add(const Eigen::Vector3d& position, double bound, double nearest) {
    x_.push_back(position.x());
    y_.push_back(position.y());
    z_.push_back(position.z());
    nearest_.push_back(nearest);
    bound_.push_back(bound * (1 + kDistanceTolerance));
    return size() - 1;
  }
  /// The largest excess over the nearest label's distance with which a path can still shorten any
  /// required distance.
  double mostExcess() const {
    double most = 0;
    for (int i = 0; i < size(); ++i) most = std::max(most, bound_[i] - nearest_[i]);
    return most;
  }
  /// Paths that tie with the bound can still become the shortest.
  void shorten(int index, double bound) {
    bound_[index] = std::min(bound_[index], bound * (1 + kDistanceTolerance));
  }
  /// Whether paths of at least `length` to points within `radius` of `place` can become the
  /// shortest to a required place. The rest of a path is at least as long as the straight line in
  /// space, and its `excess` over the distance of the nearest label does not fall along the way.
  /// Ignores the places with the indices `without`.
  bool canGain(const Eigen::Vector3d& place, double radius, double length, double excess,
               std::span<const int> without) {
    bounds_.clear();
    for (const int i : without) bounds_.push_back(std::exchange(bound_[i], -kInfinity));
    bool canGain = false;  // without branches, so that several places are looked at at once
    for (int i = 0; i < size(); ++i) {
      const double rest = bound_[i] - length + radius + rounding_;
      const double dx = x_[i] - place.x(), dy = y_[i] - place.y(), dz = z_[i] - place.z();
      canGain |= (rest > 0) & (dx * dx + dy * dy + dz * dz < rest * rest) &
                 (excess < bound_[i] - nearest_[i]);
    }
    for (size_t i = 0; i < without.size(); ++i) bound_[without[i]] = bounds_[i];
    return canGain;
  }

 private:
  const double rounding_;
  std::vector<double> x_, y_, z_, bound_, nearest_;
  std::vector<double> bounds_;  ///< of the places that do not count
};

}  // namespace gvd::exact
