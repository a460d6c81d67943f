// SPDX-License-Identifier: MIT
#include "base/sorting.h"

#include <numeric>

namespace gvd {

std::vector<int> sortedIndices(int count, bool (*isBefore)(const void* context, int a, int b),
                               const void* context) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return isBefore(context, a, b); });
  return order;
}

}  // namespace gvd
