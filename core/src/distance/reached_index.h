// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "distance/label_spread.h"

namespace gvd {

/// The index of each vertex in the list of those that a label has reached.
class ReachedIndex {
 public:
  explicit ReachedIndex(int vertexCount) : indices_(vertexCount, -1) {}

  /// Indexes another list instead.
  void reset(std::span<const ReachedVertex> reached) {
    for (const int v : vertices_) indices_[v] = -1;
    vertices_.clear();
    for (const ReachedVertex& r : reached) append(r.vertex);
  }
  /// To be called when a vertex is appended to the list.
  void append(int vertex) {
    vertices_.push_back(vertex);
    indices_[vertex] = static_cast<int>(vertices_.size()) - 1;
  }
  /// -1 if the label has not reached the vertex.
  int operator[](int vertex) const { return indices_[vertex]; }
  /// The distance of a vertex in the list, which is the indexed one; infinity if it is not there.
  double distanceIn(std::span<const ReachedVertex> reached, int vertex) const {
    return indices_[vertex] < 0 ? kInfinity : reached[indices_[vertex]].distance;
  }

 private:
  std::vector<int> indices_;
  std::vector<int> vertices_;  ///< the vertices of the current list
};

}  // namespace gvd
