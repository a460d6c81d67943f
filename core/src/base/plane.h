// SPDX-License-Identifier: MIT
//
// Rotations of vectors in the plane. A rotation is a unit vector, by which vectors are multiplied
// like complex numbers; a vector of another length scales, too.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace gvd {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline Eigen::Vector2d turnedBy(const Eigen::Vector2d& v, const Eigen::Vector2d& rotation) {
  return {v.x() * rotation.x() - v.y() * rotation.y(), v.x() * rotation.y() + v.y() * rotation.x()};
}

/// Also: `v` in a frame whose x axis is the unit vector `rotation`.
inline Eigen::Vector2d turnedBackBy(const Eigen::Vector2d& v, const Eigen::Vector2d& rotation) {
  return {v.dot(rotation), cross(rotation, v)};
}

inline Eigen::Vector2d unitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace gvd
