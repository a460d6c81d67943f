// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/mollification.h"

namespace gvd {

/// Measures the faces, vertices and edges of a mesh, in slices: lengths, angles and areas, with
/// step 10 of building a `TriangleMesh`. Throws `Error(kInvalidMesh)` if positions are too far
/// apart or too close together.
class MeshMeasuring {
 public:
  /// The mesh must outlive this; positions and halfedges are there before the first step.
  explicit MeshMeasuring(TriangleMesh& mesh) : mesh_(mesh) {}

  bool step(long& budget);
  double progress() const { return sequence_.progress(); }

 private:
  void requireExtent();
  void requireEdgeLength() const;
  void findShortEdgeLength();
  IntrinsicTriangle triangle(int face) const;
  void measureFace(int face);
  void noteFlatness(int face);
  void setFace(int face, const IntrinsicTriangle& t);
  void sumUp(int face);

  TriangleMesh& mesh_;
  SlicedSequence sequence_;
  Eigen::AlignedBox3d box_;
  std::vector<int> maybeFlat_;  ///< faces that are flat unless the mean edge is short
};

}  // namespace gvd
