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
  touched_.clear();
}

void LabelVertices::add(int v) {
  reached_.push_back(v);
  all_[v].index = static_cast<int>(reached_.size()) - 1;
}

void LabelVertices::touch(int v) {
  if (all_[v].index < 0) add(v);
  all_[v].isTouched = true;
  touched_.push_back(v);
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
  // A 32nd more than is needed: some labels are stored again and again, a few vertices longer.
  const std::size_t count = reached_.size();
  if (count > state.vertices.capacity()) {
    state.vertices.reserve(count + count / 32);
    state.pieces.reserve(count + count / 32);
  }
  state.vertices.resize(count);
  state.pieces.resize(count);
  for (const int v : touched_) {
    Vertex& own = all_[v];
    own.isTouched = false;
    own.isFinal |= own.isRequired();
    own.required = RequiredDistances::kNone;
    state.vertices[own.index] = {v, own.isFinal, own.distance};
    state.pieces[own.index] = own.piece;
  }
  touched_.clear();
}

}  // namespace gvd::exact
