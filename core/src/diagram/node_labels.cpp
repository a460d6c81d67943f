// SPDX-License-Identifier: MIT
#include "diagram/node_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "distance/labelled_distances.h"
#include "gvd/diagram.h"

namespace gvd {

void NodeLabels::clear(std::span<const int> nodes) {
  for (const int node : nodes) nodes_[node] = {};
  nodes_.resize(vertexCount_);
  for (const Midpoint& m : midpoints_) firstMidpoint_[m.lowerEnd] = -1;
  midpoints_.clear();
  labelChunks_.clear();
  addedLabels_.clear();
}

void NodeLabels::noteOwner(int node) {
  LabelledDistance nearest;
  bool hasTie = false;
  for (const LabelledDistance& d : labels(node)) {  // choices, as a branch could not be predicted
    const bool isNearer = d.distance < nearest.distance, isTie = d.distance == nearest.distance;
    hasTie = (hasTie & !isNearer) | isTie;
    nearest.label = isNearer ? d.label : nearest.label;
    nearest.distance = isNearer ? d.distance : nearest.distance;
  }
  nodes_[node].owner = nearest.label;
  nodes_[node].hasTie = hasTie;
}

int NodeLabels::commonOwner(const int* nodes) const {
  const int first = owner(nodes[0]), second = owner(nodes[1]), third = owner(nodes[2]);
  const bool isCommon = (first == second) & (second == third);
  return isCommon ? first : Diagram::kMixed;
}

void NodeLabels::addLabel(int node, LabelledDistance added) {
  if (!hasAddedLabels(node)) {
    const auto known = labels(node);
    addedLabels_[node].assign(known.begin(), known.end());
    nodes_[node].hasAddedLabels = true;
  }
  std::vector<LabelledDistance>& here = addedLabels_[node];
  if (const LabelledDistance* const nearest = findLabel(here, owner(node)))
    added.distance = std::max(added.distance, std::nextafter(nearest->distance, kInfinity));
  insertByLabel(here, added);
}

int NodeLabels::middleOf(int a, int b) const {
  const auto [low, high] = std::minmax(a, b);
  if (low >= static_cast<int>(firstMidpoint_.size())) return -1;
  int middle = firstMidpoint_[low];
  while (middle >= 0 && midpoint(middle).higherEnd != high) middle = midpoint(middle).next;
  return middle;
}

int NodeLabels::addMiddle(int a, int b, bool isShared) {
  const auto [low, high] = std::minmax(a, b);
  const int node = count();
  if (low >= static_cast<int>(firstMidpoint_.size())) firstMidpoint_.resize(low + 1, -1);
  midpoints_.push_back({low, high, isShared ? std::exchange(firstMidpoint_[low], node) : -1, {}});
  nodes_.emplace_back();
  return node;
}

bool NodeLabels::enlarge(Side& side) const {
  const auto [other, middle] = std::minmax(side.from, side.to);  // the midpoint was added later
  if (middle < vertexCount_) return false;
  const Midpoint& m = midpoint(middle);
  if (other != m.lowerEnd && other != m.higherEnd) return false;
  side = {m.lowerEnd, m.higherEnd};
  return true;
}

void NodeLabels::setLabels(int node, std::span<const LabelledDistance> labels) {
  constexpr size_t kChunk = 4096;
  if (labelChunks_.empty() ||
      labelChunks_.back().capacity() - labelChunks_.back().size() < labels.size()) {
    labelChunks_.emplace_back();
    labelChunks_.back().reserve(std::max(kChunk, labels.size()));
  }
  std::vector<LabelledDistance>& chunk = labelChunks_.back();
  chunk.insert(chunk.end(), labels.begin(), labels.end());
  midpoints_[node - vertexCount_].labels = std::span(chunk).last(labels.size());
  noteOwner(node);
}

void NodeLabels::appendBetween(int a, int b, double from, double to,
                               std::vector<InnerNode>& nodes) const {
  const int middle = middleOf(a, b);
  if (middle < 0) return;
  const double share = (from + to) / 2;
  appendBetween(a, middle, from, share, nodes);
  nodes.push_back({middle, share});
  appendBetween(middle, b, share, to, nodes);
}

}  // namespace gvd
