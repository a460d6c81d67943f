// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/element_splitting.h"
#include "diagram/node_labels.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The triangles a diagram is traced on, called *elements*: faces of the mesh, or for a finer
/// diagram parts of them, as halfedges in the manner of `TriangleMesh`.
///
/// Two elements with a common side agree on who owns which part of it if a label that is least
/// anywhere on a side is known at all three nodes of both: faces have that from the distances,
/// smaller elements from `LabelCompletion`.
class FaceComplex {
 public:
  /// Of all faces, once `step` has returned true. Those of several regions are split `detail` times
  /// in four, with distances at the new nodes.
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail);
  bool step(long& budget);

  /// Of no faces yet.
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances);
  /// The same of some faces, given ascending, and of no others; nothing is known at vertices that
  /// these do not have. Only for a complex made without faces, again and again: takes time for
  /// these faces and for those that it had.
  void take(std::span<const int> faces, int detail);

  const TriangleMesh& mesh() const { return mesh_; }
  const NodeLabels& nodes() const { return nodes_; }
  NodeLabels& nodes() { return nodes_; }
  int elementCount() const { return static_cast<int>(tails().size() / 3); }
  std::span<const int> tails() const { return isOwn_ ? elements_.tail : mesh_.tails(); }
  /// -1 on the mesh boundary, and where an element meets several smaller ones: one label owns all
  /// of such a side.
  std::span<const int> twins() const { return isOwn_ ? twin_ : mesh_.twins(); }
  /// The mesh's boundary halfedge that a halfedge without twin is part of, or -1.
  int boundaryHalfedge(int h) const;
  /// How many faces it is made of, and which of them a face is, -1 if it is none.
  int faceCount() const { return isPart_ ? partSize_ : mesh_.faceCount(); }
  int faceIndex(int face) const { return isPart_ ? indexInPart_[face] : face; }
  int face(int element) const { return isOwn_ ? elements_.face[element] : element; }
  /// How many elements are a part of their face only.
  int partialCount() const { return static_cast<int>(elements_.corners.size()); }
  /// Whether every element is all of its face, so that they are in the order of their faces.
  bool hasWholeFacesOnly() const { return elements_.corners.empty(); }
  /// Whether an element is all of its face.
  bool isWhole(int element) const { return hasWholeFacesOnly() || elements_.isWhole(element); }
  /// A point of an element in terms of its face.
  Eigen::Vector3d faceBary(int element, const Eigen::Vector3d& bary) const {
    return isWhole(element)
               ? bary
               : Eigen::Vector3d(elements_.corners[elements_.cornersOf[element]] * bary);
  }

  /// The nodes between the ends of a halfedge where its element meets smaller ones, in order. None
  /// where the elements on both sides have the same size.
  std::vector<NodeLabels::InnerNode> innerNodes(int h) const;
  /// The label that owns all of an element: the owner of all its nodes; else -2, `Diagram::kMixed`.
  int soleOwner(int element) const { return soleOwner_[element]; }
  /// The elements, ascending, of several regions or of none, and those with ties at all nodes: on
  /// all of these, two labels may tie.
  const std::vector<int>& contested() const { return contested_; }
  /// How many elements several regions have a part of.
  int mixedCount() const { return mixedCount_; }

 private:
  bool takeMesh(long& budget);
  bool finish(long& budget);
  void addFace(int face);
  void clear();
  void noteContested(int element);
  int meshHalfedge(int h) const;
  bool isOnMeshBoundary(int h) const;
  bool matchTwins(long& budget);
  void linkHalfedge(int h);
  void matchTwin(int h);
  void matchTwinsOfFaces();

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const bool isPart_;
  int detail_;
  bool isOwn_;  ///< whether elements are kept here: they are not just the faces of the mesh
  NodeLabels nodes_;
  Elements elements_;  ///< if they are kept here
  std::vector<int> twin_;
  std::vector<int> soleOwner_;
  std::vector<int> contested_;
  std::vector<int> indexInPart_;  ///< per face of the mesh, -1 if it is not in; empty if all are
  int partSize_ = 0;

  SlicedSequence taking_, finishing_, matching_;
  SlicedLoop loop_;
  int splitCount_ = 0;  ///< faces of several regions, if these are split
  int mixedCount_ = 0;
  std::optional<ElementSplitting> splitting_;
  std::vector<int> lastOut_, before_;  ///< lists of halfedges, per node and per halfedge
};

}  // namespace gvd
