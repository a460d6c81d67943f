// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace gvd {

/// A hash of a number and of what was hashed before it; the same for -0 and 0. Multiplicative
/// (Knuth, The Art of Computer Programming 3, section 6.4), its factor 2^64 over the golden ratio.
inline std::uint64_t hashOf(double x, std::uint64_t before) {
  const double unsignedZero = x + 0.0;
  // Not std::bit_cast, which libc++ lacks before version 14.
  const std::uint64_t hash =
      (before ^ Eigen::numext::bit_cast<std::uint64_t>(unsignedZero)) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

/// A hash of three numbers, from 0 to below `count`.
template <class Numbers>
int hashBelow(int count, const Numbers& numbers) {
  std::uint64_t hash = 0;
  for (const double x : numbers) hash = hashOf(x, hash);
  return static_cast<int>((hash & 0xFFFFFFFF) * static_cast<std::uint64_t>(count) >> 32);
}

}  // namespace gvd
