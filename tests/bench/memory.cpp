// SPDX-License-Identifier: MIT
//
// Replaces the global allocation functions by ones that count. Every block is preceded by its size.
#include "memory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

std::size_t allocated = 0, most = 0;  // one thread allocates

/// The size is kept in the last bytes of a header that is as large as the block's alignment.
std::size_t headerOf(std::size_t alignment) {
  return std::max(alignment, alignof(std::max_align_t));
}

void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t header = headerOf(alignment);
  const std::size_t total = (size + 2 * header - 1) / header * header;
  auto* const block = static_cast<std::byte*>(std::aligned_alloc(header, total));
  if (!block) throw std::bad_alloc();
  void* const result = block + header;
  static_cast<std::size_t*>(result)[-1] = size;
  allocated += size;
  most = std::max(most, allocated);
  return result;
}

void release(void* memory, std::size_t alignment) {
  if (!memory) return;
  allocated -= static_cast<std::size_t*>(memory)[-1];
  std::free(static_cast<std::byte*>(memory) - headerOf(alignment));
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory, 1); }
void operator delete(void* memory, std::size_t) noexcept { release(memory, 1); }
void operator delete(void* memory, std::align_val_t alignment) noexcept {
  release(memory, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  release(memory, static_cast<std::size_t>(alignment));
}

namespace gvd::bench {
namespace {

/// What is allocated now by any means: arrays that grow by `realloc` do not pass here.
std::size_t inUse() {
#if defined(__GLIBC__)
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  return allocated;
#endif
}

}  // namespace

MemoryWatch::MemoryWatch() : before_(allocated), inUseBefore_(inUse()) { most = allocated; }
std::size_t MemoryWatch::peak() const {
  return std::max(most - before_, inUse() - std::min(inUse(), inUseBefore_));
}

}  // namespace gvd::bench
