// SPDX-License-Identifier: MIT
//
// Fetches memory before it is needed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace gvd {

/// Calls `visit` with an address in each cache line of an object.
template <class Object, class Visit>
void visitCacheLines(const Object& object, Visit visit) {
  constexpr std::size_t kCacheLine = 64;
  const char* const bytes = reinterpret_cast<const char*>(&object);
  // For a pointer, the pointer's own memory. NOLINTNEXTLINE(bugprone-sizeof-expression)
  for (std::size_t i = 0; i < sizeof(Object); i += kCacheLine) visit(bytes + i);
}

/// Asks for an object's memory without waiting for it. Does nothing where there is no such
/// instruction, as in WebAssembly.
template <class Object>
void prefetch([[maybe_unused]] const Object& object) {
#if defined(__GNUC__) && !defined(__wasm__)
  visitCacheLines(object, [](const char* line) {
    __builtin_prefetch(line);
    // Without this, GCC treats a function that only prefetches as free of effects and drops its
    // calls.
    asm volatile("");
  });
#endif
}

// The memory that an item needs in its turn is prefetched some turns before. Without such an
// instruction, that of several items is loaded before the first of them has its turn: a processor
// waits for a load in the end, but for several loads at the same time.
#if defined(__wasm__)
inline constexpr std::size_t kPrefetchBatch = 16;  ///< items whose memory is fetched at once
inline constexpr std::size_t kPrefetchAhead = 0;   ///< turns before that of the first of them
#else
inline constexpr std::size_t kPrefetchBatch = 1, kPrefetchAhead = 2;
#endif

/// The items of a list whose memory is to be fetched before item `i` has its turn: a batch, or
/// none.
template <class Item>
std::span<const Item> itemsToPrefetch(std::span<const Item> items, std::size_t i) {
  const std::size_t begin = i + kPrefetchAhead;
  if (i % kPrefetchBatch != 0 || begin >= items.size()) return {};
  return items.subspan(begin, std::min(kPrefetchBatch, items.size() - begin));
}

/// Prefetches an object that an item of a batch needs, or loads it.
template <class Object>
void prefetchInBatch(const Object& object) {
#if defined(__wasm__)
  visitCacheLines(object, [](const char* line) {
    static_cast<void>(*static_cast<const volatile char*>(line));
  });
#else
  prefetch(object);
#endif
}

}  // namespace gvd
