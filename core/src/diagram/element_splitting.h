// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/node_labels.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Triangles that are faces of a mesh, or parts of them: their corners are nodes.
struct Elements {
  std::vector<int> tail;                ///< of each halfedge, numbered as in `TriangleMesh`
  std::vector<int> face;                ///< of each element
  std::vector<int> cornersOf;           ///< of each element, in `corners`; -1 if it is a face
  std::deque<Eigen::Matrix3d> corners;  ///< of partial elements: barycentric, in columns

  int count() const { return static_cast<int>(face.size()); }
  /// The three nodes of an element.
  const int* nodes(int element) const {
    return tail.data() + 3 * static_cast<std::ptrdiff_t>(element);
  }
  bool isFace(int element) const { return cornersOf[element] < 0; }
  Eigen::Matrix3d cornersIn(int element) const {
    return isFace(element) ? Eigen::Matrix3d::Identity() : corners[cornersOf[element]];
  }
  /// The halfedge of the mesh that a halfedge is part of, -1 if it is inside a face.
  int meshHalfedge(int h) const;
  void reserve(std::size_t count);
  void clear();
  void addFace(int f, const std::array<int, 3>& nodes);
  /// Splits an element in four, given the nodes in the middle of its sides. The middle part takes
  /// the element's index, the other three are appended.
  void split(int element, const std::array<int, 3>& middle);
};

/// Splits mixed elements in four, `detail` times, with distances at the new nodes. Also splits
/// neighbours until every side between elements of different size has a single owner.
class ElementSplitting {
 public:
  ElementSplitting(const TriangleMesh& mesh, const TieTolerance& ties,
                   const DistanceField& distances, int detail, Elements& elements,
                   NodeLabels& nodes)
      : mesh_(mesh),
        ties_(ties),
        distances_(distances),
        detail_(detail),
        elements_(elements),
        nodes_(nodes) {}
  bool step(long& budget);

 private:
  bool addMixed(long& budget);
  bool addForced(long& budget);
  bool splitRounds(long& budget);
  bool splitBatch(long& budget);
  bool mustSplit(int element) const;
  bool isUniform(int a, int b, int owner) const;
  int middleOf(int element, int side);
  void setLabels(std::span<const double> distances);
  int commonOwner(int element) const { return nodes_.commonOwner(elements_.nodes(element)); }

  const TriangleMesh& mesh_;
  const TieTolerance& ties_;
  const DistanceField& distances_;
  const int detail_;
  Elements& elements_;
  NodeLabels& nodes_;

  SlicedSequence level_, round_, split_;
  SlicedLoop loop_;
  int levelCount_ = 0;                       ///< how often mixed elements have been split
  std::vector<int> batch_;                   ///< elements to be split next
  std::vector<std::array<int, 3>> middles_;  ///< of the sides of each
  std::vector<LabelledPoint> required_;      ///< labels at their new nodes
  std::vector<int> requiredCounts_;          ///< the number of them per new node
  std::unique_ptr<SlicedWork<std::vector<double>>> atNodes_;
};

}  // namespace gvd
