// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "gvd/sliced_work.h"

namespace gvd::checks {

/// Runs work in steps of changing size, the least with a budget of zero, which counts as one;
/// progress must rise from 0 to 1 without falling.
template <class Result>
Result inSteps(std::unique_ptr<SlicedWork<Result>> work) {
  double before = work->progress();
  EXPECT_EQ(before, 0);
  for (long budget = 0; !work->step(budget); budget = (budget + 1) % 5) {
    const double share = work->progress();
    EXPECT_GE(share, before);
    EXPECT_LE(share, 1);
    before = share;
  }
  EXPECT_EQ(work->progress(), 1);
  return work->take();
}

/// Lets parts make the room that they make in slices.
template <class... Parts>
void makeRoom(Parts&... parts) {
  long budget = std::numeric_limits<long>::max();
  (parts.prepare(budget), ...);
}

}  // namespace gvd::checks
