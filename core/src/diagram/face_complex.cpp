// SPDX-License-Identifier: MIT
#include "diagram/face_complex.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/tolerances.h"
#include "gvd/diagram.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

std::uint64_t unorderedKey(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

using Labels = std::span<const LabelledDistance>;

/// The lists are short.
const LabelledDistance* find(Labels labels, int label) {
  for (const LabelledDistance& d : labels)
    if (d.label >= label) return d.label == label ? &d : nullptr;
  return nullptr;
}

bool haveSameLabels(Labels a, Labels b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.label == y.label; });
}

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
    const bool isBehindAtTail = lagAtTail > 0 || (lagAtTail == 0 && other.label < label);
    const bool isBehindAtTip = lagAtTip > 0 || (lagAtTip == 0 && other.label < label);
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

}  // namespace

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail)
    : mesh_(mesh), distances_(distances) {
  nodes_.resize(mesh.vertexCount());
  for (int v = 0; v < nodeCount(); ++v) noteOwner(v);
  if (detail > 0) {
    std::vector<int> faces(mesh.faceCount());
    std::iota(faces.begin(), faces.end(), 0);
    takeFaces(faces);
    refine(detail);
    matchTwins();
  }
  collectContested();
  complete();
}

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances)
    : mesh_(mesh),
      distances_(distances),
      nodes_(mesh.vertexCount()),
      indexInPart_(mesh.faceCount(), -1) {}

void FaceComplex::take(std::span<const int> faces, int detail) {
  clear();
  takeFaces(faces);
  partSize_ = static_cast<int>(faces.size());
  for (int e = 0; e < partSize_; ++e) indexInPart_[face_[e]] = e;
  for (const int v : tail_)
    if (nodes_[v].owner < 0) noteOwner(v);
  if (detail > 0) {
    refine(detail);
    matchTwins();
  } else {
    matchTwinsOfFaces();
  }
  collectContested();
  complete();
}

void FaceComplex::clear() {
  nodes_.resize(mesh_.vertexCount());
  for (const int node : tail_)
    if (node < nodeCount()) nodes_[node] = {};
  for (const int f : face_) indexInPart_[f] = -1;
  tail_.clear();
  twin_.clear();
  face_.clear();
  corners_.clear();
  contested_.clear();
  completedFaces_.clear();
  ownLabels_.clear();
  midpoint_.clear();
}

void FaceComplex::takeFaces(std::span<const int> faces) {
  isOwn_ = true;
  face_.assign(faces.begin(), faces.end());
  corners_.assign(faces.size(), Eigen::Matrix3d::Identity());
  for (const int f : faces)
    for (int h = 3 * f; h < 3 * f + 3; ++h) tail_.push_back(mesh_.tail(h));
}

void FaceComplex::collectContested() {
  const std::span<const int> tail = tails();
  contested_.reserve(elementCount());
  for (int e = 0; e < elementCount(); ++e) {
    const Node &a = nodes_[tail[3 * e]], &b = nodes_[tail[3 * e + 1]], &c = nodes_[tail[3 * e + 2]];
    const bool hasOneOwner = a.owner >= 0 && a.owner == b.owner && b.owner == c.owner;
    if (!hasOneOwner || (a.hasTie && b.hasTie && c.hasTie)) contested_.push_back(e);
  }
}

/// Adds labels where an element's third node lacks one that owns part of the side across. A label
/// added may now own part of another side, hence again where some were added until none is. An
/// element of one owner lacks none: where that one is least at all nodes, it is everywhere.
void FaceComplex::complete() {
  bool isFirst = true;
  for (bool changed = true; changed; isFirst = false) {
    changed = false;
    for (const int e : contested_)
      if ((isFirst || hasOwnLabels(e)) && knowsMoreSomewhere(e))
        for (int side = 0; side < 3; ++side)
          if (completeAcross(e, side)) {
            completedFaces_.push_back(face(e));
            changed = true;
          }
  }
}

/// Whether the nodes of an element know different labels.
bool FaceComplex::knowsMoreSomewhere(int element) const {
  const int* const node = &tails()[3 * element];
  const Labels first = labels(node[0]);
  return !haveSameLabels(first, labels(node[1])) || !haveSameLabels(first, labels(node[2]));
}

/// Whether labels may have been added at a node.
bool FaceComplex::hasOwnLabels(int element) const {
  const int* const node = &tails()[3 * element];
  return std::any_of(node, node + 3, [&](int n) { return nodes_[n].ownLabels >= 0; });
}

bool FaceComplex::completeAcross(int element, int side) {
  const int i = 3 * element + side;
  const int tail = tails()[i], tip = tails()[TriangleMesh::next(i)];
  const int apex = tails()[TriangleMesh::previous(i)];
  bool changed = false;
  const Labels atTail = labels(tail);
  Labels atTip = labels(tip), atApex = labels(apex);
  if (const int owner = nodes_[tail].owner; owner >= 0 && !find(atTip, owner)) {
    const double distance = find(atTail, owner)->distance;
    addLabel(tip, {owner, distance + std::sqrt(squaredLength(element, side, side + 1))});
    atTip = labels(tip);
    changed = true;
  }
  for (const LabelledDistance& d : atTail) {
    if (find(atApex, d.label)) continue;
    const LabelledDistance* const other = find(atTip, d.label);
    if (!other || !ownsPartOf(d.label, d.distance, other->distance, atTail, atTip)) continue;
    addLabel(apex, {d.label, unfold(element, side, d.distance, other->distance)});
    atApex = labels(apex);
    changed = true;
  }
  return changed;
}

/// A label not known at a node does not own it: what is added there stays behind the owner.
void FaceComplex::addLabel(int node, LabelledDistance added) {
  int& list = nodes_[node].ownLabels;
  if (list < 0) {
    const Labels known = distances_.at(node);
    list = static_cast<int>(ownLabels_.size());
    ownLabels_.emplace_back(known.begin(), known.end());
  }
  std::vector<LabelledDistance>& here = ownLabels_[list];
  if (const LabelledDistance* const owner = find(here, nodes_[node].owner))
    added.distance = std::max(added.distance, std::nextafter(owner->distance, kInfinity));
  here.insert(std::upper_bound(here.begin(), here.end(), added,
                               [](const auto& a, const auto& b) { return a.label < b.label; }),
              added);
}

/// The distance of an element's third node from where the distances at the ends of a side put the
/// source in the plane.
double FaceComplex::unfold(int element, int side, double atTail, double atTip) const {
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
double FaceComplex::squaredLength(int element, int from, int to) const {
  return squaredDistance(faceBary(element, Eigen::Vector3d::Unit(from % 3)),
                         faceBary(element, Eigen::Vector3d::Unit(to % 3)),
                         squaredSides(mesh_, face(element)));
}

void FaceComplex::noteOwner(int node) {
  const Labels here = labels(node);
  const LabelledDistance nearest = nearestOf(here);
  nodes_[node].owner = nearest.label;
  nodes_[node].hasTie =
      here.size() > 1 && std::any_of(here.begin(), here.end(), [&](const LabelledDistance& d) {
        return d.label != nearest.label && d.distance == nearest.distance;
      });
}

int FaceComplex::soleOwner(int element) const {
  const int* const node = &tails()[3 * element];
  const int owner = nodes_[node[0]].owner;
  return nodes_[node[1]].owner == owner && nodes_[node[2]].owner == owner ? owner : Diagram::kMixed;
}

std::vector<FaceComplex::InnerNode> FaceComplex::innerNodes(int h) const {
  std::vector<InnerNode> nodes;
  if (!midpoint_.empty() && twin_[h] < 0)
    collectInnerNodes(tail_[h], tail_[TriangleMesh::next(h)], 0, 1, nodes);
  return nodes;
}

void FaceComplex::collectInnerNodes(int a, int b, double from, double to,
                                    std::vector<InnerNode>& nodes) const {
  const int middle = middleOf(a, b);
  if (middle < 0) return;
  const double share = (from + to) / 2;
  collectInnerNodes(a, middle, from, share, nodes);
  nodes.push_back({middle, share});
  collectInnerNodes(middle, b, share, to, nodes);
}

int FaceComplex::boundaryHalfedge(int h) const {
  if (twins()[h] >= 0) return -1;
  const int side = meshHalfedge(h);
  return side >= 0 && mesh_.twin(side) < 0 ? side : -1;
}

/// The halfedge of the mesh that a side of an element is part of, -1 if it is inside a face.
int FaceComplex::meshHalfedge(int h) const {
  if (!isOwn()) return h;
  // The side of the face that both ends lie on.
  const Eigen::Matrix3d& corners = corners_[h / 3];
  const auto from = corners.col(h % 3), to = corners.col((h + 1) % 3);
  for (int i = 0; i < 3; ++i) {
    const int opposite = (i + 2) % 3;
    if (from[opposite] == 0 && to[opposite] == 0) return 3 * face_[h / 3] + i;
  }
  return -1;
}

/// Splits level by level what has several owners, and after each level what a neighbour's new nodes
/// leave no choice about.
void FaceComplex::refine(int detail) {
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
}

/// Whether an element beside smaller ones would not agree with them: it has several owners, or some
/// node on its sides has another one.
bool FaceComplex::mustSplit(int element) const {
  const int owner = soleOwner(element);
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

/// The node in the middle of the side between two nodes, -1 if it is not split.
int FaceComplex::middleOf(int a, int b) const {
  if (!nodes_[a].endsSplitSide || !nodes_[b].endsSplitSide) return -1;
  const auto middle = midpoint_.find(unorderedKey(a, b));
  return middle == midpoint_.end() ? -1 : middle->second;
}

/// The node in the middle of a side, made if there is none yet, with the distances of the labels
/// known at both ends.
int FaceComplex::midpoint(int element, int side) {
  const int a = tail_[3 * element + side], b = tail_[3 * element + (side + 1) % 3];
  const int node = nodeCount();
  const auto [entry, isNew] = midpoint_.try_emplace(unorderedKey(a, b), node);
  if (!isNew) return entry->second;
  nodes_[a].endsSplitSide = nodes_[b].endsSplitSide = true;
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
  nodes_.push_back({.ownLabels = static_cast<int>(ownLabels_.size())});
  ownLabels_.push_back(std::move(here));
  noteOwner(node);
  return node;
}

/// Sides on the mesh boundary have none, also where the mesh was cut and another one has the same
/// two nodes.
void FaceComplex::matchTwins() {
  const int count = static_cast<int>(tail_.size());
  const auto isOnBoundary = [&](int h) {
    const int side = meshHalfedge(h);
    return side >= 0 && mesh_.twin(side) < 0;
  };
  // The halfedges that leave each node, as lists.
  std::vector<int> last(nodeCount(), -1), before(count, -1);
  for (int h = 0; h < count; ++h)
    if (!isOnBoundary(h)) before[h] = std::exchange(last[tail_[h]], h);
  twin_.assign(count, -1);
  for (int h = 0; h < count; ++h) {
    if (isOnBoundary(h)) continue;
    int twin = last[tail_[TriangleMesh::next(h)]];
    while (twin >= 0 && tail_[TriangleMesh::next(twin)] != tail_[h]) twin = before[twin];
    twin_[h] = twin;
  }
}

/// The same where the elements are the faces of a part.
void FaceComplex::matchTwinsOfFaces() {
  twin_.resize(tail_.size());
  for (int h = 0; h < static_cast<int>(twin_.size()); ++h) {
    const int twin = mesh_.twin(3 * face_[h / 3] + h % 3);
    const int element = twin < 0 ? -1 : indexInPart_[TriangleMesh::faceOf(twin)];
    twin_[h] = element < 0 ? -1 : 3 * element + twin % 3;
  }
}

}  // namespace gvd
