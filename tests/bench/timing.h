// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>
#include <utility>

namespace gvd::bench {

/// The CPU time that this thread has used, in seconds, so other processes do not count.
inline double threadSeconds() {
  std::timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Result>
struct Timed {
  double seconds;
  Result result;
};

/// Runs `work` once.
template <class Work>
auto timed(Work work) {
  const double start = threadSeconds();
  auto result = work();
  return Timed<decltype(work())>{threadSeconds() - start, std::move(result)};
}

}  // namespace gvd::bench
