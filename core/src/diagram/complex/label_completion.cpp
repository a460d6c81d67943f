// SPDX-License-Identifier: MIT
//
// Adds the labels that small elements of a detailed diagram lack: the distance at the third node is
// unfolded from the distances at the ends of a side.
#include "diagram/complex/label_completion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "distance/edge_share.h"
#include "distance/labelled_distances.h"
#include "mesh/face_metric.h"
#include "mesh/slits.h"

namespace gvd {
namespace {

using Labels = std::span<const LabelledDistance>;

/// Whether a label is nearest anywhere on a side, given the labels at the side's ends.
bool ownsPartOf(int label, double atTail, double atTip, Labels tail, Labels tip) {
  EdgeShare share(label, atTail, atTip);
  for (const LabelledDistance& other : tail) {
    const LabelledDistance* const otherAtTip = findLabel(tip, other.label);
    if (!otherAtTip || other.label == label) continue;
    share.yieldTo(other.label, other.distance, otherAtTip->distance);
    if (share.isEmpty()) return false;
  }
  return true;
}

/// Whether one of the owners is nearer than a label at both ends of a side.
bool isDominated(int label, double atTail, double atTip, Labels tail, Labels tip,
                 const std::array<int, 3>& owners) {
  return std::any_of(owners.begin(), owners.end(), [&](int owner) {
    const LabelledDistance *const from = findLabel(tail, owner), *const to = findLabel(tip, owner);
    if (!from || !to || owner == label) return false;
    EdgeShare share(label, atTail, atTip);
    share.yieldTo(owner, from->distance, to->distance);
    return share.isEmpty();
  });
}

}  // namespace

bool LabelCompletion::step(long& budget) {
  constexpr long kRounds = kQuickRounds / 8;  // of an undecided element
  while (loop_.run(complex_.elementCount(), budget, kQuickRounds, [&](int element) {
    if (!complex_.isUndecided(element)) return 1L;
    complete(element);
    return kRounds;
  })) {
    isFirstRound_ = false;
    if (!std::exchange(hasChanged_, false)) return true;
  }
  return false;
}

void LabelCompletion::complete(int element) {
  if (!isFirstRound_ && !hasAddedLabels(element)) return;
  if (!mayLackLabels(element)) return;
  for (int side = 0; side < 3; ++side)
    if (completeAcross(element, side)) {
      faces_.push_back(complex_.face(element));
      hasChanged_ = true;
    }
}

/// Whether labels have been added at any node of an element.
bool LabelCompletion::hasAddedLabels(int element) const {
  const int* const node = complex_.nodesOf(element);
  return std::any_of(node, node + 3, [&](int n) { return complex_.nodes().hasAddedLabels(n); });
}

/// Whether an owner is unknown at some node, or a label known at only two nodes is not farther than
/// one of the owners at both.
bool LabelCompletion::mayLackLabels(int element) const {
  const int* const node = complex_.nodesOf(element);
  std::array<Labels, 3> known;
  std::array<int, 3> owners;
  for (int i = 0; i < 3; ++i) {
    known[i] = complex_.nodes().labels(node[i]);
    owners[i] = complex_.nodes().owner(node[i]);
  }
  return anyLabel(known[0], known[1], known[2], [&](int label, const auto& at) {
    if (at[0] && at[1] && at[2]) return false;
    if (label == owners[0] || label == owners[1] || label == owners[2]) return true;
    for (int i = 0; i < 3; ++i) {
      const int j = cornerAfter(i);
      if (at[i] && at[j] &&
          !isDominated(label, at[i]->distance, at[j]->distance, known[i], known[j], owners))
        return true;
    }
    return false;
  });
}

bool LabelCompletion::completeAcross(int element, int side) {
  const int* const node = complex_.nodesOf(element);
  const int tail = node[side], tip = node[cornerAfter(side)], apex = node[cornerBefore(side)];
  bool changed = false;
  const Labels atTail = complex_.nodes().labels(tail);
  Labels atTip = complex_.nodes().labels(tip), atApex = complex_.nodes().labels(apex);
  if (const int owner = complex_.nodes().owner(tail); owner >= 0 && !findLabel(atTip, owner)) {
    const double distance = findLabel(atTail, owner)->distance;
    complex_.nodes().addLabel(
        tip, {owner, distance + std::sqrt(squaredLength(element, side, side + 1))});
    atTip = complex_.nodes().labels(tip);
    changed = true;
  }
  const int meshSide = complex_.boundaryHalfedge(3 * element + side);
  if (meshSide >= 0 && isSideOfSlit(complex_.mesh(), meshSide)) return changed;
  for (const LabelledDistance& d : atTail) {
    if (findLabel(atApex, d.label)) continue;
    const LabelledDistance* const other = findLabel(atTip, d.label);
    if (!other || !ownsPartOf(d.label, d.distance, other->distance, atTail, atTip)) continue;
    complex_.nodes().addLabel(apex, {d.label, unfold(element, side, d.distance, other->distance)});
    atApex = complex_.nodes().labels(apex);
    changed = true;
  }
  return changed;
}

/// The distance of an element's third node from the virtual source behind a side. Not by
/// `dgpc::unfold`, because here there has to be a source: if the distances violate the triangle
/// inequality, it is on the line of the side. And an element has no cosines, only squared lengths.
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
