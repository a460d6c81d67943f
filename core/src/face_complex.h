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

/// The triangles a diagram is traced on, called *elements*: the faces of the mesh, or for a finer
/// diagram parts of them, as halfedges in the manner of `TriangleMesh`; and at their corners, the
/// *nodes*, the labels with their distances.
///
/// Two elements with a common side agree on who owns which part of it: a label that is least
/// anywhere on a side, exactly compared, is known at all three nodes of both. Of slivers that
/// rounding makes or breaks, no distance field can promise that.
class FaceComplex {
 public:
  /// Faces of several regions are split `detail` times in four, with distances at the new nodes.
  FaceComplex(const TriangleMesh& mesh, const DistanceField& distances, int detail);

  int elementCount() const { return static_cast<int>(tails().size() / 3); }
  int nodeCount() const { return static_cast<int>(owner_.size()); }
  std::span<const int> tails() const { return isRefined() ? tail_ : mesh_.tails(); }
  /// -1 on the mesh boundary, and where an element meets several smaller ones: one label owns all
  /// of such a side.
  std::span<const int> twins() const { return isRefined() ? twin_ : mesh_.twins(); }
  /// The mesh's boundary halfedge that a halfedge without twin is part of, or -1.
  int boundaryHalfedge(int h) const;
  int face(int element) const { return isRefined() ? face_[element] : element; }
  /// Whether an element is all of its face.
  bool isWhole(int element) const {
    return !isRefined() || corners_[element] == Eigen::Matrix3d::Identity();
  }
  /// A point of an element in terms of its face.
  Eigen::Vector3d faceBary(int element, const Eigen::Vector3d& bary) const {
    return isRefined() ? Eigen::Vector3d(corners_[element] * bary) : bary;
  }
  std::span<const LabelledDistance> labels(int node) const {
    const int vertices = mesh_.vertexCount();
    if (node >= vertices) return added_[node - vertices];
    if (completed_.empty()) return distances_.at(node);
    const auto completed = completed_.find(node);
    return completed == completed_.end() ? distances_.at(node) : completed->second;
  }
  /// The nearest label of a node, the lowest of those that tie; -1 if there is none.
  int owner(int node) const { return owner_[node]; }
  /// Whether another label is as near.
  bool hasTie(int node) const { return hasTie_[node]; }
  /// The nodes between the ends of a halfedge where its element meets smaller ones, in order; each
  /// with its share of the way. None where the elements on both sides have the same size.
  struct InnerNode {
    int node;
    double share;
  };
  std::vector<InnerNode> innerNodes(int h) const;
  /// The label that owns all of an element: the owner of all its nodes; else -2.
  int soleOwner(int element) const;

 private:
  bool isRefined() const { return !tail_.empty(); }
  void addOwner(std::span<const LabelledDistance> labels);
  void refine(int detail);
  bool mustSplit(int element) const;
  bool isUniform(int a, int b, int owner) const;
  void split(int element);
  int midpoint(int element, int side);
  void collectInnerNodes(int a, int b, double from, double to, std::vector<InnerNode>& nodes) const;
  void matchTwins();
  void complete();
  bool hasSeveralLabels(int element) const;
  bool completeAcross(int element, int side);
  void addLabel(int node, LabelledDistance added);
  double unfold(int element, int side, double atTail, double atTip) const;
  double squaredLength(int element, int from, int to) const;

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  std::vector<int> owner_;
  std::vector<char> hasTie_;
  std::vector<char> isShared_;  ///< whether a node knows more than one label
  std::vector<int> tail_, twin_, face_;
  std::vector<Eigen::Matrix3d> corners_;
  std::vector<std::vector<LabelledDistance>> added_;  ///< of the nodes that are no vertices
  std::unordered_map<int, std::vector<LabelledDistance>> completed_;  ///< of some vertices
  std::unordered_map<std::uint64_t, int> midpoint_;  ///< of split sides, by their two nodes
};

}  // namespace gvd
