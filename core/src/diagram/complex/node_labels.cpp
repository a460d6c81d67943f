// SPDX-License-Identifier: MIT
#include "diagram/complex/node_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "distance/labelled_distances.h"

namespace gvd {

void NodeLabels::clear(std::span<const int> nodes) {
  for (const int node : nodes) nodes_[node] = {};
  nodes_.resize(vertexCount_);
  highestLabel_ = -1;
  for (const Midpoint& m : midpoints_) lists_[m.side.from] = lists_[m.side.to] = {};
  midpoints_.clear();
  labelChunks_.clear();
  addedLabels_.clear();
}

void NodeLabels::noteOwner(int node) {
  const auto known = labels(node);
  if (!known.empty()) highestLabel_ = std::max(highestLabel_, known.back().label);
  LabelledDistance nearest;
  bool hasTie = false;
  for (const LabelledDistance& d : known) {  // choices, as a branch could not be predicted
    const bool isNearer = d.distance < nearest.distance, isTie = d.distance == nearest.distance;
    hasTie = (hasTie & !isNearer) | isTie;
    nearest.label = isNearer ? d.label : nearest.label;
    nearest.distance = isNearer ? d.distance : nearest.distance;
  }
  nodes_[node].owner = nearest.label;
  nodes_[node].hasTie = hasTie;
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

int NodeLabels::middleOf(const ElementSide& side) const {
  const int middle = findListed(side.from, side.to, side.edge);
  return middle >= 0 ? middle : findListed(side.to, side.from, side.edge);
}

/// The midpoint of a side if it is listed at `end`, else -1.
int NodeLabels::findListed(int end, int otherEnd, int edge) const {
  if (end >= static_cast<int>(lists_.size())) return -1;
  int middle = lists_[end].first;
  while (middle >= 0) {
    const ElementSide& side = midpoint(middle).side;
    if ((side.from == otherEnd || side.to == otherEnd) && side.edge == edge) break;
    middle = midpoint(middle).next;
  }
  return middle;
}

int NodeLabels::addMiddle(const ElementSide& side) {
  const int node = count(), last = std::max(side.from, side.to);
  if (last >= static_cast<int>(lists_.size())) lists_.resize(last + 1);
  MidpointList &from = lists_[side.from], &to = lists_[side.to];
  MidpointList& list = from.size < to.size ? from : to;
  midpoints_.push_back({side, std::exchange(list.first, node), {}});
  ++list.size;
  nodes_.emplace_back();
  return node;
}

bool NodeLabels::enlarge(ElementSide& side) const {
  const auto [other, middle] = std::minmax(side.from, side.to);  // the midpoint was added later
  if (middle < vertexCount_) return false;
  const ElementSide& whole = midpoint(middle).side;
  if (other != whole.from && other != whole.to) return false;
  side = whole;
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

void NodeLabels::appendBetween(const ElementSide& side, double from, double to,
                               std::vector<InnerNode>& nodes) const {
  const int middle = middleOf(side);
  if (middle < 0) return;
  const double share = (from + to) / 2;
  appendBetween({side.from, middle}, from, share, nodes);
  nodes.push_back({middle, share});
  appendBetween({middle, side.to}, share, to, nodes);
}

}  // namespace gvd
