// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace gvd {

/// An array that grows at its end. Unlike `std::vector` it grows by `realloc`, which moves large
/// arrays without copying them, and can be written to beyond its end.
template <class Item>
class GrowingArray {
  static_assert(std::is_trivially_copyable_v<Item>);

 public:
  GrowingArray() = default;
  GrowingArray(GrowingArray&& other) noexcept { swap(other); }
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    GrowingArray(std::move(other)).swap(*this);
    return *this;
  }

  size_t size() const { return size_; }
  Item& operator[](size_t i) { return items_.get()[i]; }
  const Item& operator[](size_t i) const { return items_.get()[i]; }
  std::span<Item> subspan(size_t first, size_t count) { return {items_.get() + first, count}; }
  std::span<const Item> subspan(size_t first, size_t count) const {
    return {items_.get() + first, count};
  }

  /// Room for `count` more items, where they may be written before `append` adds them. Good until
  /// the next call.
  Item* room(size_t count) {
    if (size_ + count > capacity_) allocate(std::max(size_ + count, capacity_ + capacity_ / 2));
    return items_.get() + size_;
  }
  void append(size_t count) { size_ += count; }
  void add(const Item& item) {
    const Item copy = item;
    *room(1) = copy;
    ++size_;
  }
  void truncate(size_t size) { size_ = size; }
  /// Gives back room but for an eighth.
  void shrink() {
    if (const size_t wanted = size_ + size_ / 8; wanted < capacity_) allocate(wanted);
  }

 private:
  void swap(GrowingArray& other) noexcept {
    items_.swap(other.items_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  struct Free {
    void operator()(Item* items) const { std::free(items); }
  };

  void allocate(size_t capacity) {
    if (capacity == 0) {
      items_.reset();
    } else {
      void* const grown = std::realloc(static_cast<void*>(items_.get()), capacity * sizeof(Item));
      if (!grown) throw std::bad_alloc();
      static_cast<void>(items_.release());
      items_.reset(static_cast<Item*>(grown));
    }
    capacity_ = capacity;
  }

  std::unique_ptr<Item, Free> items_;
  size_t size_ = 0, capacity_ = 0;
};

}  // namespace gvd
