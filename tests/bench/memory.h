// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace gvd::bench {

/// Measures the memory allocated since its construction; one at a time.
class MemoryWatch {
 public:
  MemoryWatch();
  /// The peak in bytes, less what was allocated before: the most that `operator new` had handed out
  /// at any time since, or all memory in use now, by whatever allocator, if that is more.
  std::size_t peak() const;

 private:
  std::size_t before_, inUseBefore_;
};

}  // namespace gvd::bench
