// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/sliced_loop.h"
#include "gvd/partition.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Finds the twins of a partition's halfedges. Between faces that are not cut, these are the twins
/// of the mesh; other sides are matched by their ends.
class TwinMatching {
 public:
  /// `uncut` is the triangle of each face that is not cut, -1 of others. All must outlive this.
  TwinMatching(const TriangleMesh& mesh, const std::vector<int>& uncut, Partition& partition)
      : mesh_(mesh), uncut_(uncut), out_(partition) {}
  bool step(long& budget);

 private:
  void matchTriangle(int t);
  bool takeFromMesh(int h);
  void match(int h);
  bool isOnMeshBoundary(int h) const;

  const TriangleMesh& mesh_;
  const std::vector<int>& uncut_;
  Partition& out_;

  SlicedSequence sequence_;
  /// Lists of the halfedges without a twin so far, by the lower of their ends.
  std::vector<int> firstOpen_, nextOpen_;
};

}  // namespace gvd
