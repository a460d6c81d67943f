// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>
#include <optional>
#include <utility>

namespace gvd::bench {

/// The CPU time that this thread has used, in seconds: other processes do not count.
inline double threadSeconds() {
  std::timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Result>
struct Timed {
  double seconds;  ///< of the fastest run
  Result result;   ///< of the last one
};

/// Runs `work` some times, freeing what it returned in between, off the clock.
template <class Work>
auto timed(int runs, Work work) {
  std::optional<decltype(work())> result;
  double best = 0;
  for (int i = 0; i < runs; ++i) {
    result.reset();
    const double start = threadSeconds();
    result.emplace(work());
    const double seconds = threadSeconds() - start;
    if (i == 0 || seconds < best) best = seconds;
  }
  return Timed<decltype(work())>{best, std::move(*result)};
}

}  // namespace gvd::bench
