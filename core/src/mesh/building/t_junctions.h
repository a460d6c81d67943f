// SPDX-License-Identifier: MIT
//
// Step 4 of building a `TriangleMesh`, in slices: vertices within sides of other triangles.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/triangle_tree.h"

namespace gvd {

/// A flat triangle whose three vertices lie on a side of another triangle.
struct FlatTriangle {
  Corners vertices;
  int beside;               ///< the other triangle
  Eigen::Matrix3d corners;  ///< columns: barycentric coordinates of the vertices there
};

/// Joins T-junctions: boundary vertices within a boundary edge of a triangle that they are no
/// corners of. Between the edge and the edges from vertex to vertex along it, there is room for one
/// flat triangle per vertex. So all triangles remain as they are. Each vertex is joined to the
/// nearest edge within the tolerance. O(n log n).
class TJunctionFilling {
 public:
  /// `faces` have twins, and their vertices are farther apart than the tolerance. All must outlive
  /// this.
  TJunctionFilling(std::span<const double> positions, const Faces& faces, double tolerance)
      : positions_(positions),
        faces_(faces),
        tolerance_(tolerance),
        vertices_(static_cast<int>(positions.size() / 3)) {}
  bool step(long& budget);
  std::vector<FlatTriangle> take() { return std::move(out_); }

 private:
  /// A vertex within a halfedge.
  struct Junction {
    int halfedge;
    double share;  ///< of the halfedge, up to the vertex
    int vertex;
  };

  void addEdge(int h);
  void findEdgeOf(int vertex);
  long fillEdgeOf(int index);
  void fill(std::span<const Junction> points);

  const std::span<const double> positions_;
  const Faces& faces_;
  const double tolerance_;

  SlicedSequence sequence_;
  std::vector<int> edges_;              ///< of the boundary, as halfedges
  std::vector<SpaceTriangle> inSpace_;  ///< the edges, until the tree has them
  IndexSet vertices_;                   ///< of the boundary
  std::optional<TriangleTree> tree_;    ///< of the edges
  std::vector<Junction> found_;
  std::vector<FlatTriangle> out_;
};

}  // namespace gvd
