// SPDX-License-Identifier: MIT
#include "diagram/element_twins.h"

#include <utility>

namespace gvd {

bool ElementTwins::match(int nodeCount, long& budget) {
  const size_t count = elements_.tail.size();
  return sequence_.run(
      [&] {
        before_.reserve(count);
        twin_.reserve(count);
      },
      [&] { return fillInSlices(lastOut_, nodeCount, -1, budget); },
      forEach(count, budget, kQuickRounds, [&](int h) { link(h); }),
      forEach(count, budget, kQuickRounds, [&](int h) { matchSide(h); }));
}

/// Puts a halfedge in the list of those that leave its tail. A side on the mesh boundary gets no
/// twin, even if the mesh was cut there and another side has the same two nodes.
void ElementTwins::link(int h) {
  const bool isOnBoundary = elements_.boundaryHalfedge(mesh_, h) >= 0;
  before_.push_back(isOnBoundary ? -1 : std::exchange(lastOut_[elements_.tail[h]], h));
}

void ElementTwins::matchSide(int h) {
  int twin = -1;
  if (elements_.boundaryHalfedge(mesh_, h) < 0) {
    twin = lastOut_[elements_.tail[TriangleMesh::next(h)]];
    while (twin >= 0 && elements_.tail[TriangleMesh::next(twin)] != elements_.tail[h])
      twin = before_[twin];
  }
  twin_.push_back(twin);
}

void ElementTwins::matchFaces(std::span<const int> elementOfFace) {
  twin_.resize(elements_.tail.size());
  for (int h = 0; h < static_cast<int>(twin_.size()); ++h) {
    const int twin = mesh_.twin(3 * elements_.face[h / 3] + h % 3);
    const int element = twin < 0 ? -1 : elementOfFace[TriangleMesh::faceOf(twin)];
    twin_[h] = element < 0 ? -1 : 3 * element + twin % 3;
  }
}

void ElementTwins::clear() {
  for (const int node : elements_.tail)
    if (node < static_cast<int>(lastOut_.size())) lastOut_[node] = -1;
  before_.clear();
  twin_.clear();
  sequence_ = {};
}

}  // namespace gvd
