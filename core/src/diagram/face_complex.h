// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The triangles a diagram is traced on, called *elements*: faces of the mesh, or for a finer
/// diagram parts of them, as halfedges in the manner of `TriangleMesh`; and at their corners, the
/// *nodes*, the labels with their distances. The first nodes are the vertices of the mesh.
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
  int elementCount() const { return static_cast<int>(tails().size() / 3); }
  int nodeCount() const { return static_cast<int>(nodes_.size()); }
  std::span<const int> tails() const { return isOwn_ ? tail_ : mesh_.tails(); }
  /// -1 on the mesh boundary, and where an element meets several smaller ones: one label owns all
  /// of such a side.
  std::span<const int> twins() const { return isOwn_ ? twin_ : mesh_.twins(); }
  /// The mesh's boundary halfedge that a halfedge without twin is part of, or -1.
  int boundaryHalfedge(int h) const;
  /// How many faces it is made of, and which of them a face is, -1 if it is none.
  int faceCount() const { return isPart() ? partSize_ : mesh_.faceCount(); }
  int faceIndex(int face) const { return isPart() ? indexInPart_[face] : face; }
  int face(int element) const { return isOwn_ ? face_[element] : element; }
  /// How many elements are a part of their face only.
  int partialCount() const { return static_cast<int>(corners_.size()); }
  /// Whether every element is all of its face, so that they are in the order of their faces.
  bool hasWholeFacesOnly() const { return corners_.empty(); }
  /// Whether an element is all of its face.
  bool isWhole(int element) const { return hasWholeFacesOnly() || cornersOf_[element] < 0; }
  /// A point of an element in terms of its face.
  Eigen::Vector3d faceBary(int element, const Eigen::Vector3d& bary) const {
    return isWhole(element) ? bary : Eigen::Vector3d(corners_[cornersOf_[element]] * bary);
  }

  std::span<const LabelledDistance> labels(int node) const {
    if (hasAddedLabels(node)) return addedLabels_.at(node);
    const int midpoint = node - mesh_.vertexCount();
    return midpoint < 0 ? distances_.at(node) : midpoints_[midpoint].labels;
  }
  /// Whether labels have been added at a node.
  bool hasAddedLabels(int node) const { return nodes_[node].hasAddedLabels; }
  /// Adds a label that is not known at a node and does not own it: it stays behind the owner.
  void addLabel(int node, LabelledDistance added);
  /// The nearest label of a node, the lowest of those that tie; -1 if none is known.
  int owner(int node) const { return nodes_[node].owner; }
  /// Whether another label is as near.
  bool hasTie(int node) const { return nodes_[node].hasTie; }

  /// The nodes between the ends of a halfedge where its element meets smaller ones, in order; each
  /// with its share of the way. None where the elements on both sides have the same size.
  struct InnerNode {
    int node;
    double share;
  };
  std::vector<InnerNode> innerNodes(int h) const;
  /// The label that owns all of an element: the owner of all its nodes; else -2, `Diagram::kMixed`.
  int soleOwner(int element) const { return soleOwner_[element]; }
  /// The elements, ascending, of several regions or of none, and those with ties at all nodes: on
  /// all of these, two labels may tie.
  const std::vector<int>& contested() const { return contested_; }

 private:
  /// In the order in which they are done; those for splitting elements only where `detail_` > 0.
  enum class Stage { kOwners, kCount, kTake, kSplit, kFollow, kLink, kMatch, kContested, kDone };
  /// The label owners, and what else there is to know of a node, in one word: there are many.
  struct Node {
    int owner : 30 = -1;
    unsigned hasTie : 1 = false;
    unsigned hasAddedLabels : 1 = false;
  };
  /// A node in the middle of a split side, in a list for the lower of the side's ends.
  struct Midpoint {
    int higherEnd;
    int next;                                  ///< node, -1 for none
    int commonCount;                           ///< of labels known at both ends of the side
    std::span<const LabelledDistance> labels;  ///< in labelChunks_
  };

  bool isPart() const { return !indexInPart_.empty(); }
  bool runStage(long& budget);
  void enter(Stage stage);
  void takeFace(int face);
  void clear();
  void noteOwner(int node);
  int commonOwner(int element) const;
  void noteContested(int element);
  bool splitMixed(long& budget);
  bool follow(long& budget);
  bool mustSplit(int element) const;
  bool isUniform(int a, int b, int owner) const;
  void split(int element);
  Eigen::Matrix3d cornersOf(int element) const;
  void splitBatch(long& budget);
  void addMidpoint(int element, int side);
  int middleOf(int a, int b) const;
  std::span<const LabelledDistance> keep(std::span<const LabelledDistance> labels);
  void collectInnerNodes(int a, int b, double from, double to, std::vector<InnerNode>& nodes) const;
  int meshHalfedge(int h) const;
  bool isOnMeshBoundary(int h) const;
  void linkHalfedge(int h);
  void matchTwin(int h);
  void matchTwinsOfFaces();

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  int detail_ = 0;

  Stage stage_ = Stage::kOwners;
  SlicedLoop loop_;
  int mixedCount_ = 0;                   ///< faces
  int level_ = 0;                        ///< of splitting
  int unsplitCount_ = 0;                 ///< elements before it
  int nextSplit_ = 0;                    ///< the element to be looked at next
  bool hasChanged_ = false;              ///< in this round of `follow`
  std::vector<int> batch_;               ///< elements to be split next
  std::vector<LabelledPoint> required_;  ///< labels at their new nodes

  std::vector<Node> nodes_;
  std::vector<int> soleOwner_;
  std::vector<int> contested_;
  bool isOwn_ = false;  ///< whether elements are kept here: they are not just the faces of the mesh
  std::vector<int> indexInPart_;  ///< per face of the mesh, -1 if it is not in; empty if all are
  int partSize_ = 0;
  std::vector<int> tail_, twin_, face_;
  std::vector<int> cornersOf_;  ///< in corners_, -1 for all of a face
  std::deque<Eigen::Matrix3d> corners_;
  std::map<int, std::vector<LabelledDistance>>
      addedLabels_;                 ///< all of nodes where some were added
  std::deque<Midpoint> midpoints_;  ///< the nodes after the vertices
  std::vector<int> firstMidpoint_;  ///< per node, -1 for none
  /// The labels of midpoints, list after list, each in one chunk.
  std::deque<std::vector<LabelledDistance>> labelChunks_;
  std::vector<LabelledDistance> labelsAtHand_;
  std::vector<int> lastOut_, before_;  ///< lists of halfedges, per node and per halfedge
};

}  // namespace gvd
