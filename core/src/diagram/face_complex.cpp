// SPDX-License-Identifier: MIT
//
// The triangles that a diagram is traced on, their owners and their twins. How they are split for
// more detail is in face_complex_detail.cpp.
#include "diagram/face_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gvd/diagram.h"

namespace gvd {

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail)
    : mesh_(mesh), distances_(distances), detail_(detail) {
  nodes_.reserve(mesh.vertexCount());
}

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances)
    : mesh_(mesh),
      distances_(distances),
      stage_(Stage::kDone),
      nodes_(mesh.vertexCount()),
      isOwn_(true),
      indexInPart_(mesh.faceCount(), -1) {}

bool FaceComplex::step(long& budget) {
  while (stage_ != Stage::kDone) {
    if (!runStage(budget)) return false;
  }
  return true;
}

/// Works on the stage at hand, and enters the next one when this is done.
bool FaceComplex::runStage(long& budget) {
  switch (stage_) {
    case Stage::kOwners:
      if (!loop_.run(mesh_.vertexCount(), budget, kQuickRounds, [&](int v) {
            nodes_.emplace_back();
            noteOwner(v);
          }))
        return false;
      enter(detail_ > 0 ? Stage::kCount : Stage::kContested);
      return true;
    case Stage::kCount:
      if (!loop_.run(mesh_.faceCount(), budget, kQuickRounds,
                     [&](int f) { mixedCount_ += commonOwner(f) == Diagram::kMixed; }))
        return false;
      enter(Stage::kTake);
      return true;
    case Stage::kTake:
      if (!loop_.run(mesh_.faceCount(), budget, kQuickRounds, [&](int f) { takeFace(f); }))
        return false;
      enter(Stage::kSplit);
      return true;
    case Stage::kSplit:
      if (!splitMixed(budget)) return false;
      enter(Stage::kFollow);
      return true;
    case Stage::kFollow:
      if (!follow(budget)) return false;
      enter(++level_ < detail_ ? Stage::kSplit : Stage::kLink);
      return true;
    case Stage::kLink:
      if (!fillInSlices(lastOut_, nodes_.size(), -1, budget) ||
          !loop_.run(tail_.size(), budget, kQuickRounds, [&](int h) { linkHalfedge(h); }))
        return false;
      enter(Stage::kMatch);
      return true;
    case Stage::kMatch:
      if (!loop_.run(tail_.size(), budget, kQuickRounds, [&](int h) { matchTwin(h); }))
        return false;
      enter(Stage::kContested);
      return true;
    case Stage::kContested:
      soleOwner_.reserve(elementCount());
      if (!loop_.run(elementCount(), budget, kQuickRounds, [&](int e) { noteContested(e); }))
        return false;
      enter(Stage::kDone);
      return true;
    case Stage::kDone:
      break;
  }
  return true;
}

void FaceComplex::enter(Stage stage) {
  stage_ = stage;
  nextSplit_ = 0;
  if (stage == Stage::kTake) {
    isOwn_ = true;
    // Room for what splitting adds, lest all be copied: three elements for each that is split, of
    // which there are twice as many in every level, and some around them.
    const size_t splits = static_cast<size_t>(mixedCount_) << std::min(detail_, 8);
    tail_.reserve(3 * (mesh_.faceCount() + 4 * splits));
    face_.reserve(mesh_.faceCount() + 4 * splits);
    cornersOf_.reserve(mesh_.faceCount() + 4 * splits);
  }
  if (stage == Stage::kSplit) unsplitCount_ = static_cast<int>(face_.size());
  if (stage == Stage::kLink) {
    before_.reserve(tail_.size());
    twin_.reserve(tail_.size());
  }
}

void FaceComplex::take(std::span<const int> faces, int detail) {
  clear();
  detail_ = detail;
  partSize_ = static_cast<int>(faces.size());
  for (const int f : faces) {
    indexInPart_[f] = static_cast<int>(face_.size());
    takeFace(f);
  }
  for (const int v : tail_)
    if (nodes_[v].owner < 0) noteOwner(v);
  if (detail > 0) {
    enter(Stage::kSplit);
  } else {
    matchTwinsOfFaces();
    enter(Stage::kContested);
  }
  long unlimited = std::numeric_limits<long>::max();
  step(unlimited);
}

void FaceComplex::clear() {
  nodes_.resize(mesh_.vertexCount());
  for (const int node : tail_) {
    if (node < nodeCount()) nodes_[node] = {};
    if (node < static_cast<int>(firstMidpoint_.size())) firstMidpoint_[node] = -1;
  }
  for (const int f : face_) indexInPart_[f] = -1;
  for (auto* list :
       {&tail_, &twin_, &face_, &cornersOf_, &soleOwner_, &contested_, &lastOut_, &before_})
    list->clear();
  corners_.clear();
  addedLabels_.clear();
  midpoints_.clear();
  labelChunks_.clear();
  level_ = 0;
}

void FaceComplex::takeFace(int face) {
  face_.push_back(face);
  cornersOf_.push_back(-1);
  for (int h = 3 * face; h < 3 * face + 3; ++h) tail_.push_back(mesh_.tail(h));
}

void FaceComplex::noteContested(int element) {
  const int* const node = &tails()[3 * element];
  const Node &a = nodes_[node[0]], &b = nodes_[node[1]], &c = nodes_[node[2]];
  const bool hasOneOwner = a.owner == b.owner && b.owner == c.owner;
  soleOwner_.push_back(hasOneOwner ? a.owner : Diagram::kMixed);
  if (!hasOneOwner || a.owner < 0 || (a.hasTie && b.hasTie && c.hasTie))
    contested_.push_back(element);
}

void FaceComplex::noteOwner(int node) {
  LabelledDistance nearest;
  bool hasTie = false;
  for (const LabelledDistance& d : labels(node)) {
    if (d.distance < nearest.distance) {
      nearest = d;
      hasTie = false;
    } else if (d.distance == nearest.distance && nearest.label >= 0) {
      hasTie = true;
    }
  }
  nodes_[node].owner = nearest.label;
  nodes_[node].hasTie = hasTie;
}

void FaceComplex::addLabel(int node, LabelledDistance added) {
  if (!hasAddedLabels(node)) {
    const auto known = labels(node);
    addedLabels_[node].assign(known.begin(), known.end());
    nodes_[node].hasAddedLabels = true;
  }
  std::vector<LabelledDistance>& here = addedLabels_[node];
  const auto isBefore = [](const auto& a, const auto& b) { return a.label < b.label; };
  const LabelledDistance owner{nodes_[node].owner, 0};
  const auto known = std::lower_bound(here.begin(), here.end(), owner, isBefore);
  if (known != here.end() && known->label == owner.label)
    added.distance = std::max(added.distance, std::nextafter(known->distance, kInfinity));
  here.insert(std::upper_bound(here.begin(), here.end(), added, isBefore), added);
}

int FaceComplex::commonOwner(int element) const {
  const int* const node = &tails()[3 * element];
  const int owner = nodes_[node[0]].owner;
  return nodes_[node[1]].owner == owner && nodes_[node[2]].owner == owner ? owner : Diagram::kMixed;
}

std::vector<FaceComplex::InnerNode> FaceComplex::innerNodes(int h) const {
  std::vector<InnerNode> nodes;
  if (!midpoints_.empty() && twin_[h] < 0)
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
  const int element = h / 3, i = h % 3;
  if (isWhole(element)) return 3 * face(element) + i;
  // The side of the face that both ends lie on.
  const Eigen::Matrix3d& corners = corners_[cornersOf_[element]];
  const auto from = corners.col(i), to = corners.col((i + 1) % 3);
  for (int side = 0; side < 3; ++side) {
    const int opposite = (side + 2) % 3;
    if (from[opposite] == 0 && to[opposite] == 0) return 3 * face_[element] + side;
  }
  return -1;
}

/// Sides on the mesh boundary have no twin, also where the mesh was cut and another one has the
/// same two nodes.
bool FaceComplex::isOnMeshBoundary(int h) const {
  const int side = meshHalfedge(h);
  return side >= 0 && mesh_.twin(side) < 0;
}

/// The twins where the elements are the faces of a part.
void FaceComplex::matchTwinsOfFaces() {
  twin_.resize(tail_.size());
  for (int h = 0; h < static_cast<int>(twin_.size()); ++h) {
    const int twin = mesh_.twin(3 * face_[h / 3] + h % 3);
    const int element = twin < 0 ? -1 : indexInPart_[TriangleMesh::faceOf(twin)];
    twin_[h] = element < 0 ? -1 : 3 * element + twin % 3;
  }
}

}  // namespace gvd
