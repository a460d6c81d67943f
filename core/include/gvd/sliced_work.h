// SPDX-License-Identifier: MIT
/// \file
/// Results that are computed step by step, so that a caller stays responsive and can give up.
#pragma once

#include <limits>
#include <memory>

namespace gvd {

/// A long computation. Destroying the object before the end cancels the computation.
template <class Result>
class SlicedWork {
 public:
  virtual ~SlicedWork() = default;
  /// Works for `budget` units of about a microsecond, one or more; true when everything is done.
  /// Further calls do nothing then. Indivisible work (a single face with all the sites in it, say,
  /// or sorting a list) makes a step longer. Do not call again after an exception.
  virtual bool step(long budget) = 0;
  /// The share of the work done, an estimate in [0, 1] that never falls.
  virtual double progress() const = 0;
  /// The result; call once, after `step` returned true.
  virtual Result take() = 0;
};

/// The result without steps.
template <class Result>
Result finished(std::unique_ptr<SlicedWork<Result>> work) {
  while (!work->step(std::numeric_limits<long>::max())) {
  }
  return work->take();
}

}  // namespace gvd
