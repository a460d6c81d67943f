// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/index_map.h"
#include "diagram/complex/elements.h"
#include "diagram/complex/node_labels.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"
#include "mesh/slits.h"
#include "mesh/twin_matching.h"

namespace gvd {

/// The triangles a diagram is traced on, called *elements*: faces of the mesh, or for a finer
/// diagram parts of them, as halfedges in the manner of `TriangleMesh`. A `ComplexBuilding` makes
/// one.
///
/// Two elements agree on the owners along their common side if every label that is nearest
/// somewhere on it is known at all three nodes of both. The distance field guarantees this for
/// faces, `LabelCompletion` for smaller elements.
class FaceComplex {
 public:
  const TriangleMesh& mesh() const { return mesh_; }
  const NodeLabels& nodes() const { return nodes_; }
  NodeLabels& nodes() { return nodes_; }
  int elementCount() const { return hasOwnElements_ ? elements_.count() : mesh_.faceCount(); }
  /// The three nodes at an element's corners.
  const int* nodesOf(int element) const {
    return hasOwnElements_ ? elements_.nodes(element) : mesh_.face(element).vertices.data();
  }
  /// -1 on the mesh boundary, at faces outside of the complex, and where an element meets several
  /// smaller ones: one label owns all of such a side.
  int twin(int element, int side) const {
    return hasOwnElements_ ? twins_[3 * element + side] : mesh_.face(element).twins[side];
  }
  /// Whether all three sides of an element have a twin.
  bool hasAllTwins(int element) const {
    return (twin(element, 0) | twin(element, 1) | twin(element, 2)) >= 0;
  }
  /// The mesh's boundary halfedge that a halfedge is part of, -1 if none.
  int boundaryHalfedge(int h) const {
    const int side = hasOwnElements_ ? elements_.meshHalfedge(h) : h;
    return side >= 0 && mesh_.twin(side) < 0 ? side : -1;
  }
  /// The number of faces of the complex, and the index of a face among them, -1 if it is not in.
  int faceCount() const { return isPart() ? indexInPart_->size() : mesh_.faceCount(); }
  int faceIndex(int face) const { return isPart() ? (*indexInPart_)[face] : face; }
  int face(int element) const { return hasOwnElements_ ? elements_.face[element] : element; }
  /// The number of elements that are only part of their face.
  int partialCount() const { return static_cast<int>(elements_.corners.size()); }
  /// Whether every element is a face, so that they are in the order of their faces.
  bool hasFacesOnly() const { return elements_.corners.empty(); }
  /// Whether an element is a face.
  bool isFace(int element) const { return hasFacesOnly() || elements_.isFace(element); }
  /// A point of an element in terms of its face.
  Eigen::Vector3d faceBary(int element, const Eigen::Vector3d& bary) const {
    return isFace(element)
               ? bary
               : Eigen::Vector3d(elements_.corners[elements_.cornersOf[element]] * bary);
  }

  /// The nodes between the ends of a halfedge where its element meets smaller ones, in order. None
  /// where the elements on both sides have the same size.
  std::vector<NodeLabels::InnerNode> innerNodes(int h) const {
    std::vector<NodeLabels::InnerNode> inner;
    if (!hasFacesOnly() && twins_[h] < 0) nodes_.appendBetween(elements_.side(mesh_, h), inner);
    return inner;
  }

  /// Appends the nodes between the ends of a halfedge of the mesh boundary, in order.
  void appendNodesOnBoundary(int h, std::vector<NodeLabels::InnerNode>& nodes) const {
    const int edge = mayHaveDoubleEdges(mesh_) ? h : -1;
    if (!hasFacesOnly()) nodes_.appendBetween({mesh_.tail(h), mesh_.tip(h), edge}, nodes);
  }

  /// The label that owns all of an element: the owner of all its nodes. `Diagram::kUnreachable` if
  /// they have none, `Diagram::kMixed` if they have several.
  int soleOwner(int element) const { return soleOwner_[element]; }
  std::vector<int> takeSoleOwners() { return std::move(soleOwner_); }
  /// Whether an element is mixed, has no owner, or has ties at all nodes: then two labels may tie
  /// everywhere on it.
  bool isUndecided(int element) const {
    const int* const node = nodesOf(element);
    return soleOwner(element) < 0 ||
           (nodes_.hasTie(node[0]) && nodes_.hasTie(node[1]) && nodes_.hasTie(node[2]));
  }
  /// The number of mixed elements.
  int mixedCount() const { return mixedCount_; }

 private:
  friend class ComplexBuilding;
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, bool hasOwnElements)
      : mesh_(mesh), hasOwnElements_(hasOwnElements), nodes_(distances, mesh.vertexCount()) {}

  bool isPart() const { return indexInPart_.has_value(); }

  const TriangleMesh& mesh_;
  const bool hasOwnElements_;  ///< false: the elements are the faces of the mesh
  NodeLabels nodes_;
  Elements elements_;  ///< empty, like `twins_`, unless `hasOwnElements_`
  TwinMatching twins_;
  std::vector<int> soleOwner_;  ///< per element
  int mixedCount_ = 0;
  std::optional<IndexMap> indexInPart_;  ///< of faces of the mesh; none if all of them are in
};

}  // namespace gvd
