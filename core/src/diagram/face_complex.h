// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The triangles a diagram is traced on, called *elements*: faces of the mesh, or for a finer
/// diagram parts of them, as halfedges in the manner of `TriangleMesh`; and at their corners, the
/// *nodes*, the labels with their distances. The first nodes are the vertices of the mesh.
///
/// Two elements with a common side agree on who owns which part of it: a label that is least
/// anywhere on a side, exactly compared, is known at all three nodes of both. Of slivers that
/// rounding makes or breaks, no distance field can promise that.
class FaceComplex {
 public:
  /// Of all faces. Those of several regions are split `detail` times in four, with distances at the
  /// new nodes.
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail);
  /// Of no faces yet.
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances);
  /// The same of some faces, given ascending, and of no others; nothing is known at vertices that
  /// these do not have. Only for a complex made without faces, again and again: takes time for
  /// these faces and for those that it had.
  void take(std::span<const int> faces, int detail);

  int elementCount() const { return static_cast<int>(tails().size() / 3); }
  int nodeCount() const { return static_cast<int>(nodes_.size()); }
  std::span<const int> tails() const { return isOwn() ? tail_ : mesh_.tails(); }
  /// -1 on the mesh boundary, and where an element meets several smaller ones: one label owns all
  /// of such a side.
  std::span<const int> twins() const { return isOwn() ? twin_ : mesh_.twins(); }
  /// The mesh's boundary halfedge that a halfedge without twin is part of, or -1.
  int boundaryHalfedge(int h) const;
  /// How many faces it is made of, and which of them a face is, -1 if it is none.
  int faceCount() const { return isPart() ? partSize_ : mesh_.faceCount(); }
  int faceIndex(int face) const { return isPart() ? indexInPart_[face] : face; }
  int face(int element) const { return isOwn() ? face_[element] : element; }
  /// Whether an element is all of its face.
  bool isWhole(int element) const {
    return !isOwn() || corners_[element] == Eigen::Matrix3d::Identity();
  }
  /// A point of an element in terms of its face.
  Eigen::Vector3d faceBary(int element, const Eigen::Vector3d& bary) const {
    return isOwn() ? Eigen::Vector3d(corners_[element] * bary) : bary;
  }
  std::span<const LabelledDistance> labels(int node) const {
    const int list = nodes_[node].ownLabels;
    return list < 0 ? distances_.at(node) : ownLabels_[list];
  }
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
  /// The faces for which labels were added to those that the distance field knows; some several
  /// times.
  const std::vector<int>& completedFaces() const { return completedFaces_; }
  /// The label that owns all of an element: the owner of all its nodes; else -2.
  int soleOwner(int element) const;
  /// The elements, ascending, of several regions or of none, and those with ties at all nodes: on
  /// all of these, two labels may tie.
  const std::vector<int>& contested() const { return contested_; }

 private:
  /// Whether elements are kept here, because they are not just the faces of the mesh.
  bool isOwn() const { return isOwn_; }
  bool isPart() const { return !indexInPart_.empty(); }
  void takeFaces(std::span<const int> faces);
  void clear();
  void noteOwner(int node);
  void refine(int detail);
  bool mustSplit(int element) const;
  bool isUniform(int a, int b, int owner) const;
  void split(int element);
  int midpoint(int element, int side);
  int middleOf(int a, int b) const;
  void collectInnerNodes(int a, int b, double from, double to, std::vector<InnerNode>& nodes) const;
  int meshHalfedge(int h) const;
  void matchTwins();
  void matchTwinsOfFaces();
  void collectContested();
  void complete();
  bool knowsMoreSomewhere(int element) const;
  bool hasOwnLabels(int element) const;
  bool completeAcross(int element, int side);
  void addLabel(int node, LabelledDistance added);
  double unfold(int element, int side, double atTail, double atTip) const;
  double squaredLength(int element, int from, int to) const;

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  struct Node {
    int owner = -1;
    int ownLabels = -1;  ///< which list of `ownLabels_` it has, -1 for that of the distance field
    bool hasTie = false;
    bool endsSplitSide = false;
  };
  std::vector<Node> nodes_;
  std::vector<int> contested_;
  bool isOwn_ = false;
  std::vector<int> indexInPart_;  ///< per face of the mesh, -1 if it is not in; empty if all are
  int partSize_ = 0;
  std::vector<int> completedFaces_;
  std::vector<int> tail_, twin_, face_;
  std::vector<Eigen::Matrix3d> corners_;
  /// The lists of nodes at which the distance field does not hold all that is known.
  std::vector<std::vector<LabelledDistance>> ownLabels_;
  std::unordered_map<std::uint64_t, int> midpoint_;  ///< of split sides, by their two nodes
};

}  // namespace gvd
