// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include "gvd/triangle_mesh.h"
#include "mesh/slits.h"

namespace gvd {

/// A side of an element, by the nodes at its ends.
struct ElementSide {
  int from, to;
  /// Tells double edges of the mesh apart (`mayHaveDoubleEdges`), between whose ends distances may
  /// differ: the higher of the edge's halfedges. -1 where there is no other side with these ends.
  int edge = -1;
};

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
  /// The side of a halfedge.
  ElementSide side(const TriangleMesh& mesh, int h) const {
    ElementSide side{tail[h], tail[TriangleMesh::next(h)]};
    if (mayHaveDoubleEdges(mesh) && std::max(side.from, side.to) < mesh.vertexCount()) {
      const int whole = meshHalfedge(h);
      side.edge = std::max(whole, mesh.twin(whole));
    }
    return side;
  }
  /// The lengths of an element's sides, in the order of its halfedges.
  std::array<double, 3> sideLengths(const TriangleMesh& mesh, int element) const;
  void reserve(std::size_t count);
  void clear();
  void addFace(int f, const std::array<int, 3>& nodes);
  /// Splits an element at the middles of one, two or three sides, given the nodes there and -1 for
  /// a side that stays whole. One part takes the element's index, the others are appended.
  void split(const TriangleMesh& mesh, int element, const std::array<int, 3>& middle);
};

}  // namespace gvd
