// SPDX-License-Identifier: MIT
/// \file
/// Results that are made step by step, so that a caller keeps responding and can give up.
#pragma once

#include <limits>
#include <memory>

namespace gvd {

/// Something that takes a while. Dropping it before it is done gives it up.
template <class Result>
class SlicedWork {
 public:
  virtual ~SlicedWork() = default;
  /// Works on it for `budget` units of about a microsecond; true when everything is done. What
  /// cannot be divided (a single face with all the sites in it, say, or a list that is sorted)
  /// makes a step longer. Where it throws, it is not to be called again.
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
