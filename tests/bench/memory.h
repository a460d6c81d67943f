// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace gvd::bench {

/// What is allocated by `operator new`, counted from the construction of this object; one at a
/// time.
class MemoryWatch {
 public:
  MemoryWatch();
  /// The most that was allocated at any time since, less what was allocated before; in bytes.
  std::size_t peak() const;

 private:
  std::size_t before_;
};

}  // namespace gvd::bench
