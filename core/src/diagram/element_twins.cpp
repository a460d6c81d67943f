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
      [&] { return fillInSlices(outgoing_, nodeCount, Outgoing(), budget); },
      forEach(count, budget, kQuickRounds, [&](int h) { link(h); }),
      forEach(count, budget, kQuickRounds, [&](int h) { matchSide(h); }));
}

/// Puts a halfedge in the list of those that leave its tail. A side on the mesh boundary gets no
/// twin, even if the mesh was cut there and another side has the same two nodes.
void ElementTwins::link(int h) {
  twin_.push_back(-1);
  before_.push_back(-1);
  if (elements_.boundaryHalfedge(mesh_, h) >= 0) return;
  Outgoing& here = outgoing_[elements_.tail[h]];
  before_[h] = std::exchange(here.last, h);
  ++here.count;
}

/// Finds the twin of a side among the halfedges that leave its tip; if more leave the tip than the
/// tail, it is left to the twin to find the side, because all sides may end at one node.
void ElementTwins::matchSide(int h) {
  if (elements_.boundaryHalfedge(mesh_, h) >= 0) return;
  const int tail = elements_.tail[h], tip = elements_.tail[TriangleMesh::next(h)];
  if (outgoing_[tip].count > outgoing_[tail].count) return;
  int twin = outgoing_[tip].last;
  while (twin >= 0 && elements_.tail[TriangleMesh::next(twin)] != tail) twin = before_[twin];
  if (twin < 0) return;
  twin_[h] = twin;
  twin_[twin] = h;
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
    if (node < static_cast<int>(outgoing_.size())) outgoing_[node] = {};
  before_.clear();
  twin_.clear();
  sequence_ = {};
}

}  // namespace gvd
