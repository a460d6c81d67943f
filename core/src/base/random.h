// SPDX-License-Identifier: MIT
//
// Random draws. Distributions differ between implementations of the standard library; generators do
// not.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace gvd {

/// Uniform in [0, 1), a multiple of 2^-53.
inline double drawUniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// The sums of values 0 … i.
inline std::vector<double> cumulative(std::span<const double> values) {
  std::vector<double> sums(values.size());
  std::partial_sum(values.begin(), values.end(), sums.begin());
  return sums;
}

/// An index with a probability in proportion to its value, from the cumulative sums of values that
/// are not negative and not all zero.
inline int drawIndex(std::mt19937_64& random, const std::vector<double>& sums) {
  // u < 1 makes u · total < total, even rounded, unless the total is subnormal.
  const double total = sums.back(), place = drawUniform(random) * total;
  const auto index = place < total ? std::upper_bound(sums.begin(), sums.end(), place)
                                   : std::lower_bound(sums.begin(), sums.end(), total);
  return static_cast<int>(index - sums.begin());
}

/// Uniform in a triangle, by folding the unit square onto the triangle below its diagonal.
/// Multiples of 2^-53 are exact here, and the coordinates sum to 1 exactly.
inline Eigen::Vector3d drawBarycentric(std::mt19937_64& random) {
  double u = drawUniform(random), v = drawUniform(random);
  if (v > 1 - u) {
    u = 1 - u;
    v = 1 - v;
  }
  return {1 - u - v, u, v};
}

}  // namespace gvd
