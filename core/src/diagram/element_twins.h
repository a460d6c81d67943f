// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/elements.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The twins of the halfedges of elements; -1 where an element meets none, or several smaller ones.
class ElementTwins {
 public:
  /// Both must outlive this.
  ElementTwins(const TriangleMesh& mesh, const Elements& elements)
      : mesh_(mesh), elements_(elements) {}

  /// Matches sides by the nodes at their ends, in slices; true when all are matched.
  bool match(int nodeCount, long& budget);
  /// Matches the sides of elements that are faces; `elementOfFace` is -1 for other faces.
  void matchFaces(std::span<const int> elementOfFace);
  /// Forgets all twins, before the elements are cleared; in time proportional to their number.
  void clear();

  int operator[](int h) const { return twin_[h]; }

 private:
  void link(int h);
  void matchSide(int h);

  const TriangleMesh& mesh_;
  const Elements& elements_;
  SlicedSequence sequence_;
  /// The halfedges that leave a node, but for those on the mesh boundary.
  struct Outgoing {
    int last = -1;  ///< `before_` has the others, one after the other
    int count = 0;
  };
  std::vector<Outgoing> outgoing_;  ///< per node
  std::vector<int> before_;         ///< per halfedge, the next in its list, -1 for none
  std::vector<int> twin_;
};

}  // namespace gvd
