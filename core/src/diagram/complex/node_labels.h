// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "diagram/complex/elements.h"
#include "gvd/diagram.h"
#include "gvd/geodesic.h"

namespace gvd {

/// The labels known at the *nodes*, the corners of the triangles that a diagram is traced on, with
/// their distances. The first nodes are the vertices of the mesh, the others midpoints of sides
/// that were split.
class NodeLabels {
 public:
  /// The owners of the vertices are not yet found.
  NodeLabels(const DistanceField& distances, int vertexCount)
      : distances_(distances), vertexCount_(vertexCount), nodes_(vertexCount) {}

  int count() const { return static_cast<int>(nodes_.size()); }
  /// Finds the owner of a vertex, unless that has been done.
  void findOwner(int vertex) {
    if (nodes_[vertex].owner < 0) noteOwner(vertex);
  }
  /// Forgets all midpoints and added labels, and the owners of `nodes`, which must be all nodes
  /// with an owner.
  void clear(std::span<const int> nodes);

  std::span<const LabelledDistance> labels(int node) const {
    if (hasAddedLabels(node)) return addedLabels_.at(node);
    return node < vertexCount_ ? distances_.at(node) : midpoint(node).labels;
  }
  /// The nearest label, the lowest of those that tie; -1 if none is known.
  int owner(int node) const { return nodes_[node].owner; }
  /// Whether another label is as near.
  bool hasTie(int node) const { return nodes_[node].hasTie; }
  /// The owner of all three nodes, else `Diagram::kMixed`.
  int commonOwner(const int* nodes) const {
    const int first = owner(nodes[0]), second = owner(nodes[1]), third = owner(nodes[2]);
    const bool isCommon = (first == second) & (second == third);
    return isCommon ? first : Diagram::kMixed;
  }
  /// The highest label known at any node whose owner has been found, -1 if there is none.
  int highestLabel() const { return highestLabel_; }

  /// Whether labels have been added at a node.
  bool hasAddedLabels(int node) const { return nodes_[node].hasAddedLabels; }
  /// Adds a label that is not known at a node. Its distance is kept above the owner's.
  void addLabel(int node, LabelledDistance added);

  /// The node in the middle of a side, -1 if it is not split.
  int middleOf(const ElementSide& side) const;
  /// Adds the node in the middle of a side and returns it; its labels are to be set.
  int addMiddle(const ElementSide& side);
  /// Sets all labels of a midpoint, ascending; finds its owner.
  void setLabels(int node, std::span<const LabelledDistance> labels);
  /// Replaces a side by the one that it is half of; false if there is none.
  bool enlarge(ElementSide& side) const;
  /// A node between the ends of a side, and its share of the way.
  struct InnerNode {
    int node;
    double share;
  };
  /// Appends the nodes between the ends of a side, in order.
  void appendBetween(const ElementSide& side, std::vector<InnerNode>& nodes) const {
    appendBetween(side, 0, 1, nodes);
  }

 private:
  /// Packed in one word, because there are many nodes.
  struct Node {
    int owner : 30 = -1;
    unsigned hasTie : 1 = false;
    unsigned hasAddedLabels : 1 = false;
  };
  /// A node in the middle of a split side.
  struct Midpoint {
    ElementSide side;
    int next = -1;                             ///< in the list, a node, -1 for none
    std::span<const LabelledDistance> labels;  ///< in `labelChunks_`
  };
  /// The midpoints of some of the sides that end at a node. A side is listed at the end with fewer
  /// so far, so that lists are short even where all sides end at one node.
  struct MidpointList {
    int first = -1;  ///< node
    int size = 0;
  };

  const Midpoint& midpoint(int node) const { return midpoints_[node - vertexCount_]; }
  void noteOwner(int node);
  int findListed(int end, int otherEnd, int edge) const;
  void appendBetween(const ElementSide& side, double from, double to,
                     std::vector<InnerNode>& nodes) const;

  const DistanceField& distances_;
  const int vertexCount_;
  std::vector<Node> nodes_;
  int highestLabel_ = -1;
  std::deque<Midpoint> midpoints_;   ///< the nodes after the vertices
  std::vector<MidpointList> lists_;  ///< per node
  /// The labels of midpoints, list after list, each in one chunk.
  std::deque<std::vector<LabelledDistance>> labelChunks_;
  /// All labels of the nodes where some were added.
  std::map<int, std::vector<LabelledDistance>> addedLabels_;
};

}  // namespace gvd
