// SPDX-License-Identifier: MIT
//
// Memory asked for before it is needed.
#pragma once

#include <cstddef>

namespace gvd {

/// Asks for an object's memory without waiting for it. A hint: does nothing where there is no such.
template <class Object>
void prefetch([[maybe_unused]] const Object& object) {
  constexpr std::size_t kCacheLine = 64;
  [[maybe_unused]] const char* const bytes = reinterpret_cast<const char*>(&object);
  // Also of a pointer: its own memory. NOLINTNEXTLINE(bugprone-sizeof-expression)
  for (std::size_t i = 0; i < sizeof(Object); i += kCacheLine) {
#if defined(__wasm__)
    // There is no instruction for it, but processors do not wait for what nobody uses.
    static_cast<void>(*static_cast<const volatile char*>(bytes + i));
#elif defined(__GNUC__)
    __builtin_prefetch(bytes + i);
    // GCC takes what only prefetches for a function without effect, and leaves out calls of it.
    asm volatile("");
#endif
  }
}

}  // namespace gvd
