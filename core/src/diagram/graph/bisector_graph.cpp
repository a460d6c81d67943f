// SPDX-License-Identifier: MIT
//
// Merges points of the bisector graph that rounding cannot tell apart.
#include "diagram/graph/bisector_graph.h"

#include <utility>

namespace gvd {
namespace {

bool isOnSide(const SurfacePoint& p) { return p.bary.minCoeff() == 0; }

}  // namespace

bool BisectorGraph::unite(int a, int b) {
  a = merging.root(a);
  b = merging.root(b);
  if (a == b || (isNode(a) && isNode(b))) return false;
  if (isNode(b) || (!isNode(a) && b < a)) std::swap(a, b);
  mergedFaces.insert(mergedFaces.end(), {places[a].face, places[b].face});
  if (!isOnSide(places[a]) && isOnSide(places[b])) places[a] = places[b];
  merging.unite(a, b);
  return true;
}

}  // namespace gvd
