// SPDX-License-Identifier: MIT
#include "distance/exact/label_state.h"

#include <algorithm>

namespace gvd::exact {
namespace {

bool sleepsLonger(const WaitingWindow& a, const WaitingWindow& b) {
  return a.sleepsUntil > b.sleepsUntil;
}

}  // namespace

void Waiting::wake(double travel) {
  while (asleep > 0 && !(windows.front().sleepsUntil > travel)) {
    std::pop_heap(windows.data(), windows.data() + asleep, sleepsLonger);
    --asleep;
  }
}

void Waiting::sleep(double travel) {
  const auto isLong = [&](const WaitingWindow& w) { return w.sleepsUntil > travel; };
  const auto end = std::partition(awake().begin(), awake().end(), isLong);
  while (awake().begin() < end) {
    ++asleep;
    std::push_heap(windows.data(), windows.data() + asleep, sleepsLonger);
  }
}

}  // namespace gvd::exact
