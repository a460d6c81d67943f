// SPDX-License-Identifier: MIT
#include "base/sorting.h"

#include "base/index_set.h"

namespace gvd {

std::vector<int> sortedIndices(int count, bool (*isBefore)(const void* context, int a, int b),
                               const void* context) {
  std::vector<int> order = indicesBelow(count);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return isBefore(context, a, b); });
  return order;
}

}  // namespace gvd
