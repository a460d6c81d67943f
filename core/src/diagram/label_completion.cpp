// SPDX-License-Identifier: MIT
#include "diagram/label_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Labels = std::span<const LabelledDistance>;

/// The lists are short.
const LabelledDistance* find(Labels labels, int label) {
  for (const LabelledDistance& d : labels)
    if (d.label >= label) return d.label == label ? &d : nullptr;
  return nullptr;
}

/// Whether a label is farther than another one where the difference of their squared distances is
/// `lag`; ties go to the lower label.
bool isBehind(double lag, int label, int other) { return lag > 0 || (lag == 0 && other < label); }

/// Whether a label is least anywhere on a side, given what is known at its ends: by the squares
/// that the diagram is traced from, so that no more than the places of ties is rounded.
bool ownsPartOf(int label, double atTail, double atTip, Labels tail, Labels tip) {
  constexpr double kRounding = 1e-14;
  double from = 0, to = 1;
  for (const LabelledDistance& other : tail) {
    const LabelledDistance* const otherAtTip = find(tip, other.label);
    if (!otherAtTip || other.label == label) continue;
    const double lagAtTail = atTail * atTail - other.distance * other.distance;
    const double lagAtTip = atTip * atTip - otherAtTip->distance * otherAtTip->distance;
    const bool isBehindAtTail = isBehind(lagAtTail, label, other.label);
    const bool isBehindAtTip = isBehind(lagAtTip, label, other.label);
    if (isBehindAtTail && isBehindAtTip) return false;
    if (isBehindAtTail == isBehindAtTip) continue;
    const double tie = lagAtTail / (lagAtTail - lagAtTip);
    if (isBehindAtTail)
      from = std::max(from, tie);
    else
      to = std::min(to, tie);
  }
  return from <= to + kRounding;
}

/// What is known of one label at the nodes of an element, by corner; null where it is not known.
struct Known {
  int label;
  std::array<const LabelledDistance*, 3> at;

  bool isKnownAtBoth(int i, int j) const { return at[i] && at[j]; }
  bool isBehindAt(int corner, const Known& other) const {
    const double ours = at[corner]->distance, theirs = other.at[corner]->distance;
    return isBehind(ours * ours - theirs * theirs, label, other.label);
  }
};

}  // namespace

bool LabelCompletion::step(long& budget) {
  constexpr long kElementsPerUnit = 8;
  const std::vector<int>& contested = complex_.contested();
  while (loop_.run(contested.size(), budget, kElementsPerUnit,
                   [&](int i) { complete(contested[i]); })) {
    isFirstRound_ = false;
    if (!std::exchange(hasChanged_, false)) return true;
  }
  return false;
}

void LabelCompletion::complete(int element) {
  if (!isFirstRound_ && !hasOwnLabels(element)) return;
  if (!mayLackLabels(element)) return;
  for (int side = 0; side < 3; ++side)
    if (completeAcross(element, side)) {
      faces_.push_back(complex_.face(element));
      hasChanged_ = true;
    }
}

/// Whether labels may have been added at a node.
bool LabelCompletion::hasOwnLabels(int element) const {
  const int* const node = &complex_.tails()[3 * element];
  return std::any_of(node, node + 3, [&](int n) { return complex_.hasOwnLabels(n); });
}

/// Whether an owner is not known at all nodes, or a label known at two of them is not plainly behind
/// one of the owners at both.
bool LabelCompletion::mayLackLabels(int element) const {
  const int* const node = &complex_.tails()[3 * element];
  std::array<Labels, 3> lists;
  std::array<const LabelledDistance*, 3> next;
  std::array<Known, 3> owners{};
  for (int i = 0; i < 3; ++i) {
    lists[i] = complex_.labels(node[i]);
    next[i] = lists[i].data();
  }
  for (int i = 0; i < 3; ++i) {
    const int owner = complex_.owner(node[i]);
    if (owner < 0) continue;
    owners[i].label = owner;
    for (int j = 0; j < 3; ++j) owners[i].at[j] = find(lists[j], owner);
    if (!owners[i].at[0] || !owners[i].at[1] || !owners[i].at[2]) return true;
  }
  constexpr int kNoLabel = std::numeric_limits<int>::max();
  for (;;) {
    const auto labelAt = [&](int i) {
      return next[i] == lists[i].data() + lists[i].size() ? kNoLabel : next[i]->label;
    };
    const std::array<int, 3> labels = {labelAt(0), labelAt(1), labelAt(2)};
    const int label = std::min({labels[0], labels[1], labels[2]});
    if (label == kNoLabel) return false;
    Known known{label, {}};
    int count = 0, unknownAt = 0;
    for (int i = 0; i < 3; ++i) {
      if (labels[i] == label) {
        known.at[i] = next[i]++;
        ++count;
      } else {
        unknownAt = i;
      }
    }
    if (count != 2) continue;
    const int tail = (unknownAt + 1) % 3, tip = (unknownAt + 2) % 3;
    const bool isHidden = std::any_of(owners.begin(), owners.end(), [&](const Known& owner) {
      return owner.isKnownAtBoth(tail, tip) && known.isBehindAt(tail, owner) &&
             known.isBehindAt(tip, owner);
    });
    if (!isHidden) return true;
  }
}

bool LabelCompletion::completeAcross(int element, int side) {
  const std::span<const int> tails = complex_.tails();
  const int i = 3 * element + side;
  const int tail = tails[i], tip = tails[TriangleMesh::next(i)];
  const int apex = tails[TriangleMesh::previous(i)];
  bool changed = false;
  const Labels atTail = complex_.labels(tail);
  Labels atTip = complex_.labels(tip), atApex = complex_.labels(apex);
  if (const int owner = complex_.owner(tail); owner >= 0 && !find(atTip, owner)) {
    const double distance = find(atTail, owner)->distance;
    complex_.addLabel(tip, {owner, distance + std::sqrt(squaredLength(element, side, side + 1))});
    atTip = complex_.labels(tip);
    changed = true;
  }
  for (const LabelledDistance& d : atTail) {
    if (find(atApex, d.label)) continue;
    const LabelledDistance* const other = find(atTip, d.label);
    if (!other || !ownsPartOf(d.label, d.distance, other->distance, atTail, atTip)) continue;
    complex_.addLabel(apex, {d.label, unfold(element, side, d.distance, other->distance)});
    atApex = complex_.labels(apex);
    changed = true;
  }
  return changed;
}

/// The distance of an element's third node from where the distances at the ends of a side put the
/// source in the plane.
double LabelCompletion::unfold(int element, int side, double atTail, double atTip) const {
  const double squared = squaredLength(element, side, side + 1);
  const double fromTail = squaredLength(element, side, side + 2);
  const double fromTip = squaredLength(element, side + 1, side + 2);
  const double length = std::sqrt(squared);
  const double sourceX = (atTail * atTail - atTip * atTip + squared) / (2 * length);
  const double apexX = (fromTail - fromTip + squared) / (2 * length);
  const double sourceY = std::sqrt(std::max(0.0, atTail * atTail - sourceX * sourceX));
  const double apexY = std::sqrt(std::max(0.0, fromTail - apexX * apexX));
  const double x = apexX - sourceX, y = apexY + sourceY;
  return std::sqrt(x * x + y * y);
}

/// Between two corners of an element, counted on from 0 to 2.
double LabelCompletion::squaredLength(int element, int from, int to) const {
  return squaredDistance(complex_.faceBary(element, Eigen::Vector3d::Unit(from % 3)),
                         complex_.faceBary(element, Eigen::Vector3d::Unit(to % 3)),
                         squaredSides(complex_.mesh(), complex_.face(element)));
}

}  // namespace gvd
