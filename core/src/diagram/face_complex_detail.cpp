// SPDX-License-Identifier: MIT
// Splitting the elements of a complex for a finer diagram.
#include <algorithm>
#include <array>
#include <utility>

#include "base/tolerances.h"
#include "diagram/face_complex.h"
#include "gvd/diagram.h"

namespace gvd {

namespace {

/// How many elements it takes as long to look at as to split one.
constexpr int kLooksPerSplit = 8;
/// Elements that are split at once, for it takes a while to let a label go on to new nodes, but
/// hardly longer for many of them.
constexpr size_t kBatch = 256;

}  // namespace

/// Splits what has several owners, but not what has just been split.
bool FaceComplex::splitMixed(long& budget) {
  while (nextSplit_ < unsplitCount_) {
    if (budget <= 0) return false;
    const int element = nextSplit_++;
    if (commonOwner(element) == Diagram::kMixed) batch_.push_back(element);
    if (element % kLooksPerSplit == 0) --budget;
    if (batch_.size() == kBatch) splitBatch(budget);
  }
  splitBatch(budget);
  return true;
}

/// Splits what the new nodes of neighbours leave no choice about, round after round: an element
/// that is split may have neighbours that were passed already.
bool FaceComplex::follow(long& budget) {
  do {
    hasChanged_ = hasChanged_ && nextSplit_ > 0;
    while (nextSplit_ < static_cast<int>(face_.size())) {
      if (budget <= 0) return false;
      const int element = nextSplit_++;
      if (mustSplit(element)) batch_.push_back(element);
      if (element % kLooksPerSplit == 0) --budget;
      if (batch_.size() == kBatch || nextSplit_ == static_cast<int>(face_.size())) {
        hasChanged_ = hasChanged_ || !batch_.empty();
        splitBatch(budget);
      }
    }
    nextSplit_ = 0;
  } while (hasChanged_);
  return true;
}

/// Splits the elements of the batch, after finding the distances at all their new nodes.
void FaceComplex::splitBatch(long& budget) {
  const int firstNew = nodeCount();
  for (const int element : batch_)
    for (int side = 0; side < 3; ++side) addMidpoint(element, side);
  const std::vector<double> distances = distances_.distancesAt(required_);
  auto distance = distances.begin();
  auto point = required_.begin();
  for (int node = firstNew; node < nodeCount(); ++node) {
    labelsAtHand_.clear();
    Midpoint& midpoint = midpoints_[node - mesh_.vertexCount()];
    for (int i = 0; i < midpoint.commonCount; ++i, ++point, ++distance)
      if (*distance < kInfinity) labelsAtHand_.push_back({point->label, *distance});
    equalizeTies(labelsAtHand_);
    midpoint.labels = keep(labelsAtHand_);
    noteOwner(node);
  }
  budget -= static_cast<long>(batch_.size() + required_.size());
  required_.clear();
  for (const int element : batch_) split(element);
  batch_.clear();
}

/// Whether an element beside smaller ones would not agree with them: it has several owners, or some
/// node on its sides has another one.
bool FaceComplex::mustSplit(int element) const {
  const int owner = commonOwner(element);
  for (int i = 0; i < 3; ++i) {
    const int a = tail_[3 * element + i], b = tail_[3 * element + (i + 1) % 3];
    if (owner == Diagram::kMixed ? middleOf(a, b) >= 0 : !isUniform(a, b, owner)) return true;
  }
  return false;
}

bool FaceComplex::isUniform(int a, int b, int owner) const {
  const int m = middleOf(a, b);
  if (m < 0) return true;
  return nodes_[m].owner == owner && isUniform(a, m, owner) && isUniform(m, b, owner);
}

/// In four, by the midpoints of the sides; the middle part takes the element's place.
///
///          c
///         / \          ab, bc, ca: midpoints
///       ca---bc
///       / \ / \        .
///      a---ab--b
void FaceComplex::split(int element) {
  const int face = face_[element];
  const Eigen::Matrix3d corners = cornersOf(element);
  std::array<int, 3> node, middle;
  for (int i = 0; i < 3; ++i) {
    node[i] = tail_[3 * element + i];
    middle[i] = middleOf(node[i], tail_[3 * element + (i + 1) % 3]);
  }
  Eigen::Matrix3d middles;
  for (int i = 0; i < 3; ++i) middles.col(i) = (corners.col(i) + corners.col((i + 1) % 3)) / 2;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    tail_.insert(tail_.end(), {node[i], middle[i], middle[before]});
    face_.push_back(face);
    Eigen::Matrix3d part;
    part << corners.col(i), middles.col(i), middles.col(before);
    cornersOf_.push_back(static_cast<int>(corners_.size()));
    corners_.push_back(part);
    tail_[3 * element + i] = middle[i];
  }
  if (cornersOf_[element] < 0) {
    cornersOf_[element] = static_cast<int>(corners_.size());
    corners_.push_back(middles);
  } else {
    corners_[cornersOf_[element]] = middles;
  }
}

Eigen::Matrix3d FaceComplex::cornersOf(int element) const {
  if (isWhole(element)) return Eigen::Matrix3d::Identity();
  return corners_[cornersOf_[element]];
}

/// The node in the middle of the side between two nodes, -1 if it is not split.
int FaceComplex::middleOf(int a, int b) const {
  const auto [low, high] = std::minmax(a, b);
  if (low >= static_cast<int>(firstMidpoint_.size())) return -1;
  int middle = firstMidpoint_[low];
  while (middle >= 0 && midpoints_[middle - mesh_.vertexCount()].higherEnd != high)
    middle = midpoints_[middle - mesh_.vertexCount()].next;
  return middle;
}

/// Adds the node in the middle of a side if there is none yet, and requires there the distances of
/// the labels known at both ends.
void FaceComplex::addMidpoint(int element, int side) {
  const int a = tail_[3 * element + side], b = tail_[3 * element + (side + 1) % 3];
  if (middleOf(a, b) >= 0) return;
  const Eigen::Matrix3d corners = cornersOf(element);
  const SurfacePoint p{face_[element], (corners.col(side) + corners.col((side + 1) % 3)) / 2};
  const int node = nodeCount();
  const auto [low, high] = std::minmax(a, b);
  if (low >= static_cast<int>(firstMidpoint_.size())) firstMidpoint_.resize(low + 1, -1);
  const size_t requiredBefore = required_.size();
  const auto atA = labels(a), atB = labels(b);
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
  const int commonCount = static_cast<int>(required_.size() - requiredBefore);
  midpoints_.push_back({high, std::exchange(firstMidpoint_[low], node), commonCount, {}});
  nodes_.emplace_back();
}

/// A copy in memory that stays where it is.
std::span<const LabelledDistance> FaceComplex::keep(std::span<const LabelledDistance> labels) {
  constexpr size_t kChunk = 4096;
  if (labelChunks_.empty() ||
      labelChunks_.back().capacity() - labelChunks_.back().size() < labels.size()) {
    labelChunks_.emplace_back();
    labelChunks_.back().reserve(std::max(kChunk, labels.size()));
  }
  std::vector<LabelledDistance>& chunk = labelChunks_.back();
  chunk.insert(chunk.end(), labels.begin(), labels.end());
  return std::span(chunk).last(labels.size());
}

/// Puts a halfedge in the list of those that leave its tail.
void FaceComplex::linkHalfedge(int h) {
  before_.push_back(isOnMeshBoundary(h) ? -1 : std::exchange(lastOut_[tail_[h]], h));
}

void FaceComplex::matchTwin(int h) {
  int twin = -1;
  if (!isOnMeshBoundary(h)) {
    twin = lastOut_[tail_[TriangleMesh::next(h)]];
    while (twin >= 0 && tail_[TriangleMesh::next(twin)] != tail_[h]) twin = before_[twin];
  }
  twin_.push_back(twin);
}

}  // namespace gvd
