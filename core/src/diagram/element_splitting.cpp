// SPDX-License-Identifier: MIT
#include "diagram/element_splitting.h"

#include "gvd/diagram.h"

namespace gvd {
namespace {

/// Elements that take about as long to look at as one unit of the budget.
constexpr long kLooksPerUnit = 8;

}  // namespace

// --- Elements ------------------------------------------------------------------------------------

int Elements::meshHalfedge(int h) const {
  const int element = h / 3, i = h % 3;
  if (isFace(element)) return 3 * face[element] + i;
  // The side of the face that both ends lie on.
  const Eigen::Matrix3d& here = corners[cornersOf[element]];
  const auto from = here.col(i), to = here.col(cornerAfter(i));
  for (int side = 0; side < 3; ++side) {
    const int apex = cornerBefore(side);
    if (from[apex] == 0 && to[apex] == 0) return 3 * face[element] + side;
  }
  return -1;
}

void Elements::reserve(std::size_t count) {
  tail.reserve(3 * count);
  face.reserve(count);
  cornersOf.reserve(count);
}

void Elements::clear() {
  tail.clear();
  face.clear();
  cornersOf.clear();
  corners.clear();
}

void Elements::addFace(int f, const std::array<int, 3>& nodes) {
  tail.insert(tail.end(), nodes.begin(), nodes.end());
  face.push_back(f);
  cornersOf.push_back(-1);
}

///          c
///         / \          ab, bc, ca: `middle`
///       ca---bc
///       / \ / \        .
///      a---ab--b
void Elements::split(int element, const std::array<int, 3>& middle) {
  const Eigen::Matrix3d outer = cornersIn(element);
  Eigen::Matrix3d middles;
  for (int i = 0; i < 3; ++i) middles.col(i) = (outer.col(i) + outer.col(cornerAfter(i))) / 2;
  for (int i = 0; i < 3; ++i) {
    const int before = cornerBefore(i);
    tail.insert(tail.end(), {tail[3 * element + i], middle[i], middle[before]});
    face.push_back(face[element]);
    cornersOf.push_back(static_cast<int>(corners.size()));
    corners.emplace_back() << outer.col(i), middles.col(i), middles.col(before);
  }
  for (int i = 0; i < 3; ++i) tail[3 * element + i] = middle[i];
  if (isFace(element)) {
    cornersOf[element] = static_cast<int>(corners.size());
    corners.emplace_back();
  }
  corners[cornersOf[element]] = middles;
}

// --- Which of them are split ---------------------------------------------------------------------

bool ElementSplitting::step(long& budget) {
  for (; levelCount_ < detail_; ++levelCount_) {
    if (!level_.run([&] { return addMixed(budget); }, [&] { return splitRounds(budget); }))
      return false;
    level_ = {};
  }
  return true;
}

/// Splits the batch, then the elements that must follow their smaller neighbours, round after
/// round.
bool ElementSplitting::splitRounds(long& budget) {
  while (round_.run([&] { return splitBatch(budget); }, [&] { return addForced(budget); })) {
    round_ = {};
    if (batch_.empty()) return true;
  }
  return false;
}

/// Adds the elements that have several owners to the batch.
bool ElementSplitting::addMixed(long& budget) {
  return loop_.run(elements_.count(), budget, kLooksPerUnit, [&](int element) {
    if (commonOwner(element) == Diagram::kMixed) batch_.push_back(element);
  });
}

/// Adds the elements that must be split because of smaller neighbours.
bool ElementSplitting::addForced(long& budget) {
  return loop_.run(elements_.count(), budget, kLooksPerUnit, [&](int element) {
    if (mustSplit(element)) batch_.push_back(element);
  });
}

/// Whether an element with smaller neighbours would trace a side differently from them: it is
/// mixed, or a node on its sides has another owner.
bool ElementSplitting::mustSplit(int element) const {
  const int owner = commonOwner(element);
  for (int i = 0; i < 3; ++i) {
    const int a = elements_.tail[3 * element + i], b = elements_.tail[3 * element + cornerAfter(i)];
    if (owner == Diagram::kMixed ? nodes_.middleOf(a, b) >= 0 : !isUniform(a, b, owner))
      return true;
  }
  return false;
}

bool ElementSplitting::isUniform(int a, int b, int owner) const {
  const int m = nodes_.middleOf(a, b);
  if (m < 0) return true;
  return nodes_.owner(m) == owner && isUniform(a, m, owner) && isUniform(m, b, owner);
}

/// Splits the elements of the batch, after finding the distances at all their new nodes together:
/// for a label, many points take hardly longer than one.
bool ElementSplitting::splitBatch(long& budget) {
  if (!split_.run(
          [&] {
            return loop_.run(batch_.size(), budget, 1, [&](int i) {
              std::array<int, 3>& middle = middles_.emplace_back();
              for (int side = 0; side < 3; ++side) middle[side] = middleOf(batch_[i], side);
            });
          },
          [&] { atNodes_ = distances_.startDistancesAt(required_); },
          [&] { return atNodes_->step(budget); }, [&] { setLabels(atNodes_->take()); },
          [&] {
            return loop_.run(batch_.size(), budget, 1,
                             [&](int i) { elements_.split(batch_[i], middles_[i]); });
          }))
    return false;
  split_ = {};
  batch_.clear();
  middles_.clear();
  required_.clear();
  requiredCounts_.clear();
  return true;
}

/// Sets the labels of the nodes that have been added last.
void ElementSplitting::setLabels(std::span<const double> distances) {
  int node = nodes_.count() - static_cast<int>(requiredCounts_.size());
  auto distance = distances.begin();
  auto point = required_.begin();
  std::vector<LabelledDistance> found;
  for (const int count : requiredCounts_) {
    found.clear();
    for (int i = 0; i < count; ++i, ++point, ++distance)
      if (*distance < kInfinity) found.push_back({point->label, *distance});
    equalizeTies(found, ties_);
    nodes_.setLabels(node++, found);
  }
}

/// The node in the middle of a side. If there is none yet, adds it, and requires there the
/// distances of the labels known at both ends.
int ElementSplitting::middleOf(int element, int side) {
  const int next = cornerAfter(side);
  const int a = elements_.tail[3 * element + side], b = elements_.tail[3 * element + next];
  const int meshSide = elements_.meshHalfedge(3 * element + side);
  const bool isShared = meshSide < 0 || mesh_.twin(meshSide) >= 0;
  const int shared = isShared ? nodes_.middleOf(a, b) : -1;
  if (shared >= 0) return shared;
  const int node = nodes_.addMiddle(a, b, isShared);
  const Eigen::Matrix3d corners = elements_.cornersIn(element);
  const SurfacePoint p{elements_.face[element], (corners.col(side) + corners.col(next)) / 2};
  const size_t requiredBefore = required_.size();
  const auto atA = nodes_.labels(a), atB = nodes_.labels(b);
  for (auto i = atA.begin(), j = atB.begin(); i != atA.end() && j != atB.end();) {
    if (i->label < j->label) {
      ++i;
    } else if (j->label < i->label) {
      ++j;
    } else {
      required_.push_back({i->label, p});
      ++i, ++j;
    }
  }
  requiredCounts_.push_back(static_cast<int>(required_.size() - requiredBefore));
  return node;
}

}  // namespace gvd
