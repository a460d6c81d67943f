// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/prefetch.h"
#include "base/sliced_loop.h"
#include "distance/exact/window.h"

namespace gvd::exact {

/// The windows that wait at each halfedge to cross its face. Blocks of memory, of sizes that are
/// powers of two, are used again and again: a label needs as much memory as its wavefront, and
/// finds it in the cache. The windows of a halfedge lie in one block, so that loops over them have
/// no branches but their own.
class WindowLists {
 public:
  /// A halfedge's windows and the block that they lie in.
  struct List {
    Window* first = nullptr;
    int count = 0;
    int capacity = 0;

    std::span<const Window> windows() const { return {first, static_cast<size_t>(count)}; }
  };

  /// Lengthens this to `count` lists, in slices; true when there are as many.
  bool addLists(size_t count, long& budget) { return fillInSlices(lists_, count, List(), budget); }

  bool isEmpty(int halfedge) const { return lists_[halfedge].count == 0; }
  std::span<const Window> operator[](int halfedge) const { return lists_[halfedge].windows(); }
  void prefetch(int halfedge) const { prefetchInBatch(lists_[halfedge]); }

  /// Adds windows to those of a halfedge, behind them.
  void add(int halfedge, std::span<const Window> windows) {
    List& list = lists_[halfedge];
    const size_t count = list.count + windows.size();
    if (count > static_cast<size_t>(list.capacity)) grow(list, count);
    std::copy(windows.begin(), windows.end(), list.first + list.count);
    list.count = static_cast<int>(count);
  }

  /// Takes the list of a halfedge, to be given back by `free`. Windows may be added to other lists
  /// meanwhile.
  List take(int halfedge) { return std::exchange(lists_[halfedge], {}); }
  void free(const List& list) {
    if (list.capacity > 0) free_[sizeClass(list.capacity)].push_back(list.first);
  }

 private:
  /// With many sites, most halfedges have at most this many windows.
  static constexpr size_t kLeastCapacity = 4;
  static constexpr size_t kPageSize = 512;
  static constexpr size_t kSizeClasses = 32;

  static int sizeClass(size_t capacity) { return std::countr_zero(capacity); }

  void grow(List& list, size_t needed) {
    const size_t capacity = std::bit_ceil(std::max(needed, kLeastCapacity));
    Window* const block = newBlock(capacity);
    std::copy_n(list.first, list.count, block);
    free(list);
    list = {block, list.count, static_cast<int>(capacity)};
  }

  Window* newBlock(size_t capacity) {
    std::vector<Window*>& free = free_[sizeClass(capacity)];
    if (!free.empty()) {
      Window* const block = free.back();
      free.pop_back();
      return block;
    }
    if (page_.size() < capacity) {
      const size_t size = std::max(capacity, kPageSize);
      // Not make_unique_for_overwrite: the library of Emscripten 3.1 has none.
      pages_.push_back(std::unique_ptr<Window[]>(new Window[size]));
      page_ = {pages_.back().get(), size};
    }
    Window* const block = page_.data();
    page_ = page_.subspan(capacity);
    return block;
  }

  std::vector<List> lists_;                              ///< per halfedge
  std::array<std::vector<Window*>, kSizeClasses> free_;  ///< blocks, by the logarithm of their size
  std::vector<std::unique_ptr<Window[]>> pages_;
  std::span<Window> page_;  ///< what is left of the last page
};

}  // namespace gvd::exact
