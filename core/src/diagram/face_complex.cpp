// SPDX-License-Identifier: MIT
//
// The triangles that a diagram is traced on, with their owners and twins.
#include "diagram/face_complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gvd/diagram.h"

namespace gvd {
namespace {

/// The longest side of the parts of mixed faces: √2 times the mean edge, halved `detail` times.
/// Halving leaves sides between half of this and all of it, a mean edge on average.
double longestSideOf(const TriangleMesh& mesh, int detail) {
  return std::ldexp(std::sqrt(2.0) * mesh.meanEdgeLength(), -detail);
}

}  // namespace

FaceComplex::FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail,
                         Extent extent)
    : mesh_(mesh),
      distances_(distances),
      isPart_(extent == Extent::kPart),
      detail_(detail),
      longestSide_(longestSideOf(mesh, detail)),
      isOwn_(isPart_ || detail > 0),
      ties_(mesh),
      nodes_(distances, mesh.vertexCount()),
      twins_(mesh, elements_) {
  if (!isPart_) return;
  indexInPart_.assign(mesh.faceCount(), -1);
  nodes_.addVertices();
}

bool FaceComplex::step(long& budget) { return (isPart_ || addMesh(budget)) && finish(budget); }

/// Adds all vertices, and the faces too if mixed ones are to be split.
bool FaceComplex::addMesh(long& budget) {
  const auto forFaces = [&](auto body) {
    return !isOwn_ || loop_.run(mesh_.faceCount(), budget, kQuickRounds, body);
  };
  return adding_.run([&] { nodes_.reserve(mesh_.vertexCount()); },
                     [&] {
                       return loop_.run(mesh_.vertexCount(), budget, kQuickRounds,
                                        [&](int) { nodes_.addVertex(); });
                     },
                     [&] {
                       return forFaces([&](int f) {
                         if (nodes_.commonOwner(mesh_.face(f).vertices.data()) == Diagram::kMixed)
                           partsExpected_ += expectedParts(f);
                       });
                     },
                     [&] {
                       // Lists that grow beyond what is reserved are copied in one step.
                       if (isOwn_)
                         elements_.reserve(mesh_.faceCount() + static_cast<size_t>(partsExpected_));
                     },
                     [&] { return forFaces([&](int f) { addFace(f); }); });
}

/// About how many elements a mixed face becomes, if bisectors run along its longest side; at most a
/// thousand, as they mostly run across where faces are large.
double FaceComplex::expectedParts(int face) const {
  const std::array<double, 3>& lengths = mesh_.face(face).lengths;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  return 4 * std::min(longest / longestSide_, 256.0);
}

/// Splits elements, matches twins and finds owners, once faces and the labels of vertices are
/// there.
bool FaceComplex::finish(long& budget) {
  return finishing_.run(
      [&] {
        return detail_ == 0 || runPart(splitting_, budget, mesh_, ties_, distances_, longestSide_,
                                       elements_, nodes_);
      },
      [&] {
        if (detail_ > 0) return twins_.match(nodes_.count(), budget);
        if (isPart_) twins_.matchFaces(indexInPart_);
        return true;
      },
      [&] { soleOwner_.reserve(elementCount()); },
      [&] {
        return loop_.run(elementCount(), budget, kQuickRounds, [&](int e) { noteUndecided(e); });
      });
}

void FaceComplex::setPart(std::span<const int> faces) {
  clear();
  partSize_ = static_cast<int>(faces.size());
  for (const int f : faces) {
    indexInPart_[f] = elements_.count();
    addFace(f);
  }
  for (const int v : elements_.tail) nodes_.findOwner(v);
}

void FaceComplex::clear() {
  nodes_.clear(elements_.tail);
  for (const int f : elements_.face) indexInPart_[f] = -1;
  twins_.clear();
  elements_.clear();
  soleOwner_.clear();
  undecided_.clear();
  splitting_.reset();
  mixedCount_ = 0;
  finishing_ = {};
}

void FaceComplex::addFace(int face) { elements_.addFace(face, mesh_.face(face).vertices); }

void FaceComplex::noteUndecided(int element) {
  const int* const node = nodesOf(element);
  soleOwner_.push_back(nodes_.commonOwner(node));
  mixedCount_ += soleOwner_.back() == Diagram::kMixed;
  if (soleOwner_.back() < 0 || std::all_of(node, node + 3, [&](int n) { return nodes_.hasTie(n); }))
    undecided_.push_back(element);
}

std::vector<NodeLabels::InnerNode> FaceComplex::innerNodes(int h) const {
  std::vector<NodeLabels::InnerNode> inner;
  if (!hasFacesOnly() && twins_[h] < 0)
    nodes_.appendBetween(elements_.tail[h], elements_.tail[TriangleMesh::next(h)], inner);
  return inner;
}

int FaceComplex::boundaryHalfedge(int h) const {
  if (isOwn_) return elements_.boundaryHalfedge(mesh_, h);
  return mesh_.twin(h) < 0 ? h : -1;
}

}  // namespace gvd
