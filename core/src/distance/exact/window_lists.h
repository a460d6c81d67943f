// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "base/prefetch.h"
#include "distance/exact/window.h"

namespace gvd::exact {

/// The windows that wait at each halfedge to cross its face. They are kept in chunks that are used
/// again and again: a label needs as much memory as its wavefront, and finds it in the cache.
class WindowLists {
 public:
  /// With many sites, most halfedges have at most this many windows.
  static constexpr int kChunkSize = 4;
  struct Chunk {
    std::array<Window, kChunkSize> windows;
    int count;
    Chunk* next;  ///< in the same list, or in that of free chunks
  };

  explicit WindowLists(int halfedgeCount) : first_(halfedgeCount, nullptr) {}

  bool isEmpty(int halfedge) const { return !first_[halfedge]; }
  void prefetch(int halfedge) const { gvd::prefetch(first_[halfedge]); }

  void add(int halfedge, const Window& w) {
    Chunk*& first = first_[halfedge];
    if (!first || first->count == kChunkSize) first = newChunk(first);
    first->windows[first->count++] = w;
  }

  /// The list of a halfedge, for `visit`.
  const Chunk* list(int halfedge) const { return first_[halfedge]; }
  /// Takes the list of a halfedge, to be given back by `free`.
  Chunk* take(int halfedge) { return std::exchange(first_[halfedge], nullptr); }
  /// Calls `visit` with every window of a list. Windows may be added to other lists meanwhile.
  template <class Visit>
  static void visit(const Chunk* list, Visit visit) {
    for (; list; list = list->next)
      for (int i = 0; i < list->count; ++i) visit(list->windows[i]);
  }
  void free(Chunk* list) {
    while (list) {
      Chunk* const next = std::exchange(list->next, free_);
      free_ = std::exchange(list, next);
    }
  }

 private:
  static constexpr int kPageSize = 128;

  Chunk* newChunk(Chunk* next) {
    if (!free_) addPage();
    Chunk* const chunk = std::exchange(free_, free_->next);
    chunk->count = 0;
    chunk->next = next;
    return chunk;
  }
  void addPage() {
    // Not make_unique_for_overwrite: the library of Emscripten 3.1 has none.
    pages_.emplace_back(new Chunk[kPageSize]);
    Chunk* const page = pages_.back().get();
    for (int i = 0; i < kPageSize; ++i) page[i].next = i + 1 < kPageSize ? page + i + 1 : nullptr;
    free_ = page;
  }

  std::vector<Chunk*> first_;  ///< per halfedge
  std::vector<std::unique_ptr<Chunk[]>> pages_;
  Chunk* free_ = nullptr;
};

}  // namespace gvd::exact
