// SPDX-License-Identifier: MIT
#include "gvd/sliced_work.h"

#include <algorithm>

#include "gvd/error.h"

// Not inlined: the many calls would make the WebAssembly module 0.6 KB larger.
namespace gvd {

[[gnu::noinline]] bool SlicedSteps::step(long budget) {
  if (state_ != State::kUnderWay) return true;
  if (advance(std::max(budget, 1L))) state_ = State::kDone;
  progress_ = state_ == State::kDone ? 1 : std::clamp(share(), progress_, 1.0);
  return state_ == State::kDone;
}

[[gnu::noinline]] void SlicedSteps::beginTake() {
  if (state_ != State::kDone)
    throw Error(ErrorCode::kInvalidArgument, "a result is taken before the work is done, or twice");
  state_ = State::kTaken;
}

}  // namespace gvd
