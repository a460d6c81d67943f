// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Finds the twins of the halfedges of triangles, numbered as in `TriangleMesh`, by the vertices at
/// their ends.
class TwinMatching {
 public:
  /// Makes room, in slices; true when it is there. Before any halfedge is added.
  bool prepare(std::size_t halfedgeCount, long& budget) {
    return fillInSlices(twins_, halfedgeCount, -1, budget) &&
           fillInSlices(nextOpen_, halfedgeCount, -1, budget) &&
           fillInSlices(firstOpen_, std::bit_ceil(halfedgeCount / 2 + 1), -1, budget);
  }

  void set(int h, int twin) { twins_[h] = twin; }
  /// Pairs a halfedge with one that was added before and runs the other way between the same
  /// vertices, if `mayBeTwin(other)` is true for one. `tail(h)` is the vertex that a halfedge
  /// leaves.
  template <class Tail, class MayBeTwin>
  void add(int h, Tail tail, MayBeTwin mayBeTwin) {
    const int from = tail(h), to = tail(TriangleMesh::next(h));
    int& first = firstOpen_[bucketOf(from, to)];
    for (int* open = &first; *open >= 0; open = &nextOpen_[*open]) {
      const int other = *open;
      if (tail(other) != to || tail(TriangleMesh::next(other)) != from || !mayBeTwin(other))
        continue;
      twins_[h] = other;
      twins_[other] = h;
      *open = nextOpen_[other];
      return;
    }
    nextOpen_[h] = std::exchange(first, h);
  }

  void clear() {
    firstOpen_.clear();
    nextOpen_.clear();
    twins_.clear();
  }

  /// -1 for a halfedge without twin.
  int operator[](int h) const { return twins_[h]; }
  std::vector<int> take() { return std::move(twins_); }

 private:
  /// By both ends, because all halfedges may end at one vertex. Near vertices have near buckets,
  /// which stay in the cache.
  std::size_t bucketOf(int a, int b) const {
    constexpr std::size_t kFactor = 31;
    return (std::min(a, b) + kFactor * std::max(a, b)) & (firstOpen_.size() - 1);
  }

  /// Lists of the halfedges without a twin so far, by their ends.
  std::vector<int> firstOpen_;  ///< per bucket
  std::vector<int> nextOpen_;   ///< per halfedge, the next in its list, -1 for none
  std::vector<int> twins_;
};

}  // namespace gvd
