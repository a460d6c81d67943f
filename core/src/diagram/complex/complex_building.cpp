// SPDX-License-Identifier: MIT
#include "diagram/complex/complex_building.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gvd/diagram.h"
#include "mesh/slits.h"

namespace gvd {
namespace {

/// The longest side of the parts of mixed faces: √2 times the mean edge, halved `detail` times.
/// Halving leaves sides between half of this and all of it, a mean edge on average.
double longestSideOf(const TriangleMesh& mesh, int detail) {
  return std::ldexp(std::sqrt(2.0) * mesh.meanEdgeLength(), -detail);
}

/// The sole owner of a face of whose vertices none has been visited.
constexpr int kUnknown = -3;

}  // namespace

ComplexBuilding::ComplexBuilding(const TriangleMesh& mesh, const DistanceField& distances,
                                 int detail, Extent extent)
    : mesh_(mesh),
      distances_(distances),
      detail_(detail),
      longestSide_(longestSideOf(mesh, detail)),
      ties_(mesh),
      complex_(mesh, distances, extent == Extent::kPart || detail > 0) {
  if (extent == Extent::kPart) complex_.indexInPart_.emplace(mesh.faceCount());
}

bool ComplexBuilding::step(long& budget) {
  return sequence_.run(
      [&] { return complex_.isPart() || addMesh(budget); },
      [&] {
        return detail_ == 0 || runPart(splitting_, budget, mesh_, ties_, distances_, longestSide_,
                                       complex_.elements_, complex_.nodes_);
      },
      [&] { return complex_.twins_.prepare(complex_.elements_.tail.size(), budget); },
      forEach(complex_.elements_.tail, budget, kQuickRounds, [&](int h) { matchTwin(h); }),
      [&] { complex_.soleOwner_.reserve(complex_.elementCount()); },
      forEach(complex_.elements_.face, budget, kQuickRounds, [&](int e) { findOwner(e); }));
}

double ComplexBuilding::progress() const {
  const double added = splitting_ ? splitting_->expectedCount() - mesh_.faceCount() : 0;
  return partsExpected_ > 0 ? std::min(added / partsExpected_, 1.0) : sequence_.progress();
}

/// Finds the owners of all vertices, and with them those of the faces; adds these if mixed ones are
/// to be split.
bool ComplexBuilding::addMesh(long& budget) {
  NodeLabels& nodes = complex_.nodes_;
  const bool hasOwnElements = complex_.hasOwnElements_;
  const auto forFaces = [&](auto body) {
    return forEach(hasOwnElements ? mesh_.faceCount() : 0, budget, kQuickRounds, body);
  };
  return adding_.run(
      [&] {
        return hasOwnElements ||
               fillInSlices(complex_.soleOwner_, mesh_.faceCount(), kUnknown, budget);
      },
      forEach(mesh_.vertexCount(), budget, kQuickRounds,
              [&](int v) {
                nodes.findOwner(v);
                if (!hasOwnElements) ownFacesAround(v);
                return static_cast<long>(mesh_.fan(v).size());
              }),
      forFaces([&](int f) {
        if (nodes.commonOwner(mesh_.face(f).vertices.data()) == Diagram::kMixed)
          partsExpected_ += expectedParts(f);
      }),
      [&] {
        // Lists that grow beyond what is reserved are copied in one step.
        if (hasOwnElements)
          complex_.elements_.reserve(mesh_.faceCount() + static_cast<size_t>(partsExpected_));
      },
      forFaces([&](int f) { addFace(f); }));
}

/// About how many elements a mixed face becomes, if bisectors run along its longest side; not more
/// than `kMost`, because where faces are large, bisectors mostly run across.
double ComplexBuilding::expectedParts(int face) const {
  const std::array<double, 3>& lengths = mesh_.face(face).lengths;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  constexpr double kMost = 1024;
  return std::min(4 * longest / longestSide_, kMost);
}

/// Of double edges of the mesh, only sides of the same one are twins; a side on the mesh boundary
/// gets none.
void ComplexBuilding::matchTwin(int h) {
  const Elements& elements = complex_.elements_;
  const int side = elements.meshHalfedge(h), twin = side < 0 ? -1 : mesh_.twin(side);
  if (side >= 0) {
    const int beyond = twin < 0 ? -1 : complex_.faceIndex(TriangleMesh::faceOf(twin));
    if (beyond < 0) return;
    if (complex_.isFace(h / 3) && complex_.isFace(beyond))
      return complex_.twins_.set(h, 3 * beyond + twin % 3);
  }
  complex_.twins_.add(
      h, [&](int of) { return elements.tail[of]; },
      [&](int other) {
        return !mayHaveDoubleEdges(mesh_) || elements.meshHalfedge(other) == twin;
      });
}

void ComplexBuilding::startPart(std::span<const int> faces) {
  clear();
  for (const int f : faces) {
    complex_.indexInPart_->add(f, complex_.elements_.count());
    addFace(f);
  }
  for (const int v : complex_.elements_.tail) complex_.nodes_.findOwner(v);
}

void ComplexBuilding::clear() {
  complex_.nodes_.clear(complex_.elements_.tail);
  complex_.indexInPart_->clear();
  complex_.twins_.clear();
  complex_.elements_.clear();
  complex_.soleOwner_.clear();
  complex_.mixedCount_ = 0;
  splitting_.reset();
  sequence_ = {};
}

void ComplexBuilding::addFace(int face) {
  complex_.elements_.addFace(face, mesh_.face(face).vertices);
}

/// Makes the owner of a vertex the sole owner of the faces around it, unless another vertex has
/// made them its own. Fans are in order of vertices and take fewer bytes than faces.
void ComplexBuilding::ownFacesAround(int vertex) {
  const int owner = complex_.nodes_.owner(vertex);
  for (const int h : mesh_.fan(vertex)) {
    int& sole = complex_.soleOwner_[TriangleMesh::faceOf(h)];
    const bool isMixed = (sole != kUnknown) & (sole != owner);
    complex_.mixedCount_ += isMixed & (sole != Diagram::kMixed);
    sole = isMixed ? Diagram::kMixed : owner;
  }
}

/// Finds the sole owner of an element, if there is one.
void ComplexBuilding::findOwner(int element) {
  const int owner = complex_.nodes_.commonOwner(complex_.nodesOf(element));
  complex_.soleOwner_.push_back(owner);
  complex_.mixedCount_ += owner == Diagram::kMixed;
}

}  // namespace gvd
