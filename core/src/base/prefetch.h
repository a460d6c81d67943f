// SPDX-License-Identifier: MIT
//
// Fetches memory before it is needed.
#pragma once

#include <cstddef>

namespace gvd {

/// Asks for an object's memory without waiting for it. Does nothing where there is no such
/// instruction, as in WebAssembly: a load in its place would be waited for in the end.
template <class Object>
void prefetch([[maybe_unused]] const Object& object) {
  constexpr std::size_t kCacheLine = 64;
  [[maybe_unused]] const char* const bytes = reinterpret_cast<const char*>(&object);
  // For a pointer, the pointer's own memory. NOLINTNEXTLINE(bugprone-sizeof-expression)
  for (std::size_t i = 0; i < sizeof(Object); i += kCacheLine) {
#if defined(__GNUC__) && !defined(__wasm__)
    __builtin_prefetch(bytes + i);
    // Without this, GCC treats a function that only prefetches as free of effects and drops its
    // calls.
    asm volatile("");
#endif
  }
}

}  // namespace gvd
