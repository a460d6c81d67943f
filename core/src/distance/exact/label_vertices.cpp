// SPDX-License-Identifier: MIT
#include "distance/exact/label_vertices.h"

#include "base/sliced_loop.h"
#include "distance/exact/fan_behind.h"

namespace gvd::exact {

bool LabelVertices::prepare(long& budget) {
  constexpr long kVerticesPerUnit = 16;
  const std::size_t count = mesh_.vertexCount();
  all_.reserve(count);
  const std::size_t end = endOfSlice(all_.size(), count, budget, kVerticesPerUnit);
  while (all_.size() < end) {
    const int v = static_cast<int>(all_.size());
    all_.emplace_back().isSaddle = isSaddle(mesh_, v);
  }
  return end == count;
}

void LabelVertices::clear() {
  for (const int v : reached_) all_[v] = {.isSaddle = all_[v].isSaddle};
  reached_.clear();
}

void LabelVertices::add(int v) {
  reached_.push_back(v);
  all_[v].index = static_cast<int>(reached_.size()) - 1;
}

void LabelVertices::load(const LabelState& state) {
  for (std::size_t i = 0; i < state.vertices.size(); ++i) {
    const ReachedVertex& r = state.vertices[i];
    add(r.vertex);
    Vertex& own = all_[r.vertex];
    own.distance = r.distance;
    own.piece = state.pieces[i];
    own.isFinal = r.isFinal;
  }
}

void LabelVertices::store(LabelState& state) {
  // Allocates exactly, because a label is stored only once or twice.
  state.vertices.reserve(reached_.size());
  state.pieces.reserve(reached_.size());
  state.vertices.resize(reached_.size());
  state.pieces.resize(reached_.size());
  for (std::size_t i = 0; i < reached_.size(); ++i) {
    Vertex& own = all_[reached_[i]];
    own.isFinal |= own.isRequired();
    own.required = RequiredDistances::kNone;
    state.vertices[i] = {reached_[i], own.isFinal, own.distance};
    state.pieces[i] = own.piece;
  }
}

}  // namespace gvd::exact
