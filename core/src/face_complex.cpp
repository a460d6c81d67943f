// SPDX-License-Identifier: MIT
#include "face_complex.h"

#include <algorithm>
#include <utility>

#include "gvd/diagram.h"
#include "tolerances.h"

namespace gvd {
namespace {

std::uint64_t unorderedKey(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

std::uint64_t orderedKey(int a, int b) {
  return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
}

}  // namespace

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail)
    : mesh_(mesh), distances_(distances) {
  owner_.reserve(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) addOwner(distances.at(v));
  if (detail > 0) refine(detail);
}

void FaceComplex::addOwner(std::span<const LabelledDistance> labels) {
  LabelledDistance best;
  bool hasTie = false;
  for (const LabelledDistance& d : labels) {
    if (d.distance < best.distance) {
      best = d;
      hasTie = false;
    } else {
      hasTie |= d.distance == best.distance;
    }
  }
  owner_.push_back(best.label);
  hasTie_.push_back(hasTie);
}

int FaceComplex::soleOwner(int element) const {
  const auto tail = tails().subspan(3 * element, 3);
  const int owner = owner_[tail[0]];
  return owner_[tail[1]] == owner && owner_[tail[2]] == owner ? owner : Diagram::kMixed;
}

std::vector<FaceComplex::InnerNode> FaceComplex::innerNodes(int h) const {
  std::vector<InnerNode> nodes;
  if (isRefined() && twin_[h] < 0)
    collectInnerNodes(tail_[h], tail_[TriangleMesh::next(h)], 0, 1, nodes);
  return nodes;
}

void FaceComplex::collectInnerNodes(int a, int b, double from, double to,
                                    std::vector<InnerNode>& nodes) const {
  const auto middle = midpoint_.find(unorderedKey(a, b));
  if (middle == midpoint_.end()) return;
  const double share = (from + to) / 2;
  collectInnerNodes(a, middle->second, from, share, nodes);
  nodes.push_back({middle->second, share});
  collectInnerNodes(middle->second, b, share, to, nodes);
}

int FaceComplex::boundaryHalfedge(int h) const {
  if (twins()[h] >= 0) return -1;
  if (!isRefined()) return h;
  // The side of the face that both ends lie on.
  const Eigen::Matrix3d& corners = corners_[h / 3];
  const auto from = corners.col(h % 3), to = corners.col((h + 1) % 3);
  for (int i = 0; i < 3; ++i) {
    const int side = 3 * face_[h / 3] + i, opposite = (i + 2) % 3;
    if (from[opposite] == 0 && to[opposite] == 0) return mesh_.twin(side) < 0 ? side : -1;
  }
  return -1;
}

/// Splits level by level what has several owners, and after each level what a neighbour's new nodes
/// leave no choice about.
void FaceComplex::refine(int detail) {
  tail_.assign(mesh_.tails().begin(), mesh_.tails().end());
  face_.resize(mesh_.faceCount());
  for (int f = 0; f < mesh_.faceCount(); ++f) face_[f] = f;
  corners_.assign(mesh_.faceCount(), Eigen::Matrix3d::Identity());
  for (int level = 0; level < detail; ++level) {
    const int count = static_cast<int>(face_.size());
    for (int e = 0; e < count; ++e)
      if (soleOwner(e) == Diagram::kMixed) split(e);
    for (bool changed = true; changed;) {
      changed = false;
      for (int e = 0; e < static_cast<int>(face_.size()); ++e)
        if (mustSplit(e)) {
          split(e);
          changed = true;
        }
    }
  }
  matchTwins();
}

/// Whether an element beside smaller ones would not agree with them: it has several owners, or some
/// node on its sides has another one.
bool FaceComplex::mustSplit(int element) const {
  const int owner = soleOwner(element);
  for (int i = 0; i < 3; ++i) {
    const int a = tail_[3 * element + i], b = tail_[3 * element + (i + 1) % 3];
    if (owner == Diagram::kMixed ? midpoint_.contains(unorderedKey(a, b)) : !isUniform(a, b, owner))
      return true;
  }
  return false;
}

bool FaceComplex::isUniform(int a, int b, int owner) const {
  const auto middle = midpoint_.find(unorderedKey(a, b));
  if (middle == midpoint_.end()) return true;
  const int m = middle->second;
  return owner_[m] == owner && isUniform(a, m, owner) && isUniform(m, b, owner);
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
  const Eigen::Matrix3d corners = corners_[element];
  std::array<int, 3> node, middle;
  for (int i = 0; i < 3; ++i) {
    node[i] = tail_[3 * element + i];
    middle[i] = midpoint(element, i);
  }
  Eigen::Matrix3d middles;
  for (int i = 0; i < 3; ++i) middles.col(i) = (corners.col(i) + corners.col((i + 1) % 3)) / 2;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    tail_.insert(tail_.end(), {node[i], middle[i], middle[before]});
    face_.push_back(face);
    Eigen::Matrix3d part;
    part << corners.col(i), middles.col(i), middles.col(before);
    corners_.push_back(part);
    tail_[3 * element + i] = middle[i];
  }
  corners_[element] = middles;
}

/// The node in the middle of a side, with the distances of the labels known at both ends.
int FaceComplex::midpoint(int element, int side) {
  const int a = tail_[3 * element + side], b = tail_[3 * element + (side + 1) % 3];
  const auto [entry, isNew] = midpoint_.try_emplace(unorderedKey(a, b), nodeCount());
  if (!isNew) return entry->second;
  const Eigen::Matrix3d& corners = corners_[element];
  const SurfacePoint p{face_[element], (corners.col(side) + corners.col((side + 1) % 3)) / 2};
  std::vector<LabelledDistance> here;
  const auto atA = labels(a), atB = labels(b);
  for (auto i = atA.begin(), j = atB.begin(); i != atA.end() && j != atB.end();) {
    if (i->label < j->label) {
      ++i;
    } else if (j->label < i->label) {
      ++j;
    } else {
      const double distance = distances_.distance(i->label, p);
      if (distance < kInfinity) here.push_back({i->label, distance});
      ++i, ++j;
    }
  }
  equalizeTies(here);
  addOwner(here);
  added_.push_back(std::move(here));
  return entry->second;
}

void FaceComplex::matchTwins() {
  std::unordered_map<std::uint64_t, int> halfedge;
  halfedge.reserve(tail_.size());
  const int count = static_cast<int>(tail_.size());
  for (int h = 0; h < count; ++h) halfedge[orderedKey(tail_[h], tail_[TriangleMesh::next(h)])] = h;
  twin_.resize(count);
  for (int h = 0; h < count; ++h) {
    const auto twin = halfedge.find(orderedKey(tail_[TriangleMesh::next(h)], tail_[h]));
    twin_[h] = twin == halfedge.end() ? -1 : twin->second;
  }
}

}  // namespace gvd
