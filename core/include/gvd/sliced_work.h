// SPDX-License-Identifier: MIT
/// \file
/// Results that are computed step by step, so that a caller stays responsive and can give up.
#pragma once

#include <limits>
#include <memory>

namespace gvd {

/// The steps of a long computation, whatever its result. Destroying the object before the end
/// cancels the computation.
class SlicedSteps {
 public:
  virtual ~SlicedSteps() = default;
  /// Works for `budget` units of about a microsecond, at least one; true when everything is done.
  /// Further calls do nothing then. Indivisible work (a single face with all the sites in it, say,
  /// or sorting a list) makes a step longer. Do not call again after an exception.
  bool step(long budget);
  /// The share of the work done, an estimate in [0, 1] that never falls: 0 before the first step, 1
  /// when everything is done.
  double progress() const { return progress_; }

 protected:
  /// `step`, as long as the work is not done.
  virtual bool advance(long budget) = 0;
  /// `progress` after a step that was not the last; it may fall.
  virtual double share() const = 0;
  /// Throws `Error(kInvalidArgument)` unless the work is done, and this is the first call.
  void beginTake();

 private:
  enum class State : unsigned char { kUnderWay, kDone, kTaken };
  State state_ = State::kUnderWay;
  double progress_ = 0;
};

/// A long computation and its result.
template <class Result>
class SlicedWork : public SlicedSteps {
 public:
  /// The result, once, after `step` has returned true; `Error(kInvalidArgument)` otherwise.
  Result take() {
    beginTake();
    return result();
  }

 protected:
  /// `take`, called once.
  virtual Result result() = 0;
};

/// The result without steps.
template <class Result>
Result finished(std::unique_ptr<SlicedWork<Result>> work) {
  while (!work->step(std::numeric_limits<long>::max())) {
  }
  return work->take();
}

}  // namespace gvd
