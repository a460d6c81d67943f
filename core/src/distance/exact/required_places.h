// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/tolerances.h"

namespace gvd::exact {

/// The vertices or other points at which the distance of a label is required although another label
/// is nearer. The label's windows go on only as far as they can still shorten one of these
/// distances.
class RequiredPlaces {
 public:
  void clear() {
    for (auto* values : {&x_, &y_, &z_, &bound_, &nearest_}) values->clear();
  }
  int size() const { return static_cast<int>(bound_.size()); }

  /// `bound` is the label's distance as far as it is known, `nearest` the least of all labels'.
  /// Returns the index of the place.
  int add(const Eigen::Vector3d& position, double bound, double nearest) {
    x_.push_back(position.x());
    y_.push_back(position.y());
    z_.push_back(position.z());
    nearest_.push_back(nearest);
    bound_.push_back(bound * (1 - kDistanceTolerance));
    return size() - 1;
  }
  /// By how much a path that can gain anything is longer than the nearest label's, at most.
  double mostExcess() const {
    double most = 0;
    for (int i = 0; i < size(); ++i) most = std::max(most, bound_[i] - nearest_[i]);
    return most;
  }
  void shorten(int index, double bound) { bound_[index] = bound * (1 - kDistanceTolerance); }
  /// Lets a place not count until its bound is set again; returns its bound.
  double exclude(int index) { return std::exchange(bound_[index], 0); }
  void setBound(int index, double bound) { bound_[index] = bound; }

  /// Whether paths with a length of at least `length` up to points at most `radius` from `place`
  /// can become the shortest to a required place. Neither can a path be shorter than the straight
  /// line in space, nor can it lose its `excess` on the way: the amount by which it is longer than
  /// that of the nearest label.
  /// `without` are the indices of vertices that do not count, -1 for none.
  bool canGain(const Eigen::Vector3d& place, double radius, double length, double excess,
               const std::array<int, 3>& without) const {
    for (int i = 0; i < size(); ++i) {
      const double rest = bound_[i] - length + radius;
      const double dx = x_[i] - place.x(), dy = y_[i] - place.y(), dz = z_[i] - place.z();
      if (rest > 0 && dx * dx + dy * dy + dz * dz < rest * rest &&
          excess < bound_[i] - nearest_[i] && i != without[0] && i != without[1] && i != without[2])
        return true;
    }
    return false;
  }

 private:
  std::vector<double> x_, y_, z_, bound_, nearest_;
};

}  // namespace gvd::exact
