// SPDX-License-Identifier: MIT
#include "base/sliced_loop.h"

#include <algorithm>

namespace gvd {

std::size_t SlicedLoop::advance(std::size_t count, long& budget, long perUnit) {
  const std::size_t end = endOfSlice(next_, count, budget, perUnit);
  next_ = end < count ? end : 0;
  return end;
}

std::size_t endOfSlice(std::size_t begin, std::size_t count, long& budget, long perUnit) {
  const auto left = static_cast<long>(count - begin);
  // The budget may be negative, because indivisible work may overdraw it.
  const long units = std::clamp(budget, 0L, (left + perUnit - 1) / perUnit);
  budget -= units;
  return units > left / perUnit ? count : begin + units * perUnit;
}

}  // namespace gvd
