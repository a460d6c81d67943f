// SPDX-License-Identifier: MIT
//
// The place of each vertex in the list of those that a label has reached.
#pragma once

#include <span>

#include "base/index_map.h"
#include "distance/label_spread.h"

namespace gvd {

/// Numbers the vertices of a list by their places in it, and no others.
inline void indexVertices(std::span<const ReachedVertex> reached, IndexMap& index) {
  index.clear();
  for (int i = 0; i < static_cast<int>(reached.size()); ++i) index.add(reached[i].vertex, i);
}

/// The distance of a vertex in a list with this index; infinity if it is not there.
inline double distanceIn(std::span<const ReachedVertex> reached, const IndexMap& index,
                         int vertex) {
  const int i = index[vertex];
  return i < 0 ? kInfinity : reached[i].distance;
}

}  // namespace gvd
