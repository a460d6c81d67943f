// SPDX-License-Identifier: MIT
#include "diagram/complex/element_splitting.h"

#include <algorithm>

#include "gvd/diagram.h"
#include "mesh/slits.h"

namespace gvd {

/// Splits a batch and finds the next one, round after round.
bool ElementSplitting::step(long& budget) {
  while (round_.runRound([&] { return splitBatch(budget); },
                         [&](SlicedLoop& loop) { return findBatch(loop, budget); }))
    if (batch_.empty()) return true;
  return false;
}

/// Finds the elements that must be split, among those near the elements of the last batch.
bool ElementSplitting::findBatch(SlicedLoop& loop, long& budget) {
  constexpr long kLooksPerUnit = 8;
  const auto isNearSplit = [&](int n) { return nearSplit_.contains(n); };
  if (!loop.run(elements_.count(), budget, kLooksPerUnit, [&](int element) {
        const int* const nodes = elements_.nodes(element);
        const bool isConcerned = isFirstRound_ || std::any_of(nodes, nodes + 3, isNearSplit);
        if (isConcerned && mustSplit(element)) batch_.push_back(element);
      }))
    return false;
  nearSplit_.clear();
  isFirstRound_ = false;
  return true;
}

/// Whether an element is mixed and has a side to split, or would trace a side differently from
/// smaller neighbours, because a node on it has another owner.
bool ElementSplitting::mustSplit(int element) const {
  const int owner = nodes_.commonOwner(elements_.nodes(element));
  const bool isMixed = owner == Diagram::kMixed;
  const auto lengths = isMixed ? elements_.sideLengths(mesh_, element) : std::array<double, 3>();
  for (int i = 0; i < 3; ++i)
    if (isMixed ? isSideSplit(element, i, lengths[i]) : !isUniform(sideOf(element, i), owner))
      return true;
  return false;
}

/// Whether a side is split if its element is. Long ones are, even those with one owner: the parts
/// of a thin element might never get shorter otherwise.
bool ElementSplitting::isSideSplit(int element, int side, double length) const {
  return length > longestSide_ || nodes_.middleOf(sideOf(element, side)) >= 0;
}

bool ElementSplitting::isUniform(const ElementSide& side, int owner) const {
  const int m = nodes_.middleOf(side);
  return m < 0 || (nodes_.owner(m) == owner && isUniform({side.from, m}, owner) &&
                   isUniform({m, side.to}, owner));
}

bool ElementSplitting::splitBatch(long& budget) {
  const auto forBatch = [&](auto body) { return forEach(batch_, budget, 1, body); };
  return split_.runRound(
      forBatch([&](int i) { addMiddles(batch_[i]); }), [&] { nearSplit_.extend(nodes_.count()); },
      [&] { return required_.find(budget); },
      forBatch([&](int i) { split(batch_[i], middles_[i]); }),
      [&] {
        batch_.clear();
        middles_.clear();
      });
}

/// Adds the nodes in the middle of the sides to split. At each, requires the near labels that are
/// known at both ends of the side; on a slit, those that are known at the third corner, too.
void ElementSplitting::addMiddles(int element) {
  const auto lengths = elements_.sideLengths(mesh_, element);
  const auto known = [&](int corner) { return nodes_.labels(node(element, corner)); };
  findNearLabels({known(0), known(1), known(2)}, lengths, ties_, near_);
  const Eigen::Matrix3d corners = elements_.cornersIn(element);
  std::array<int, 3>& middle = middles_.emplace_back();
  for (int i = 0; i < 3; ++i) {
    const int next = cornerAfter(i);
    middle[i] = isSideSplit(element, i, lengths[i]) ? middleOf(element, i) : -1;
    if (middle[i] < 0) continue;
    const int meshSide = mayHaveDoubleEdges(mesh_) ? elements_.meshHalfedge(3 * element + i) : -1;
    const bool isSlit = meshSide >= 0 && isSideOfSlit(mesh_, meshSide);
    const SurfacePoint p{elements_.face[element], (corners.col(i) + corners.col(next)) / 2};
    for (const auto& [label, isKnown] : near_)
      if (isKnown[i] && isKnown[next] && (!isSlit || isKnown[cornerBefore(i)]))
        required_.add(middle[i], label, p);
  }
}

/// The node in the middle of a side, added if there is none yet.
int ElementSplitting::middleOf(int element, int i) {
  const ElementSide side = sideOf(element, i);
  const int middle = nodes_.middleOf(side);
  return middle >= 0 ? middle : nodes_.addMiddle(side);
}

/// Splits an element, and notes its nodes and those of larger elements that its sides are part of:
/// elements at these nodes have to be looked at.
void ElementSplitting::split(int element, const std::array<int, 3>& middle) {
  for (int i = 0; i < 3; ++i) {
    if (middle[i] >= 0) nearSplit_.add(middle[i]);
    ElementSide side{node(element, i), node(element, cornerAfter(i))};
    do {
      nearSplit_.add(side.from);
      nearSplit_.add(side.to);
    } while (nodes_.enlarge(side));
  }
  elements_.split(mesh_, element, middle);
}

}  // namespace gvd
