// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace gvd::bench {

/// What is allocated, counted from the construction of this object; one at a time.
class MemoryWatch {
 public:
  MemoryWatch();
  /// In bytes, less what was allocated before: the most that `operator new` gave at any time since,
  /// or what is in use now by any means, if that is more.
  std::size_t peak() const;

 private:
  std::size_t before_, inUseBefore_;
};

}  // namespace gvd::bench
