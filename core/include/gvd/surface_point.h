// SPDX-License-Identifier: MIT
/// \file
/// A point on a surface, as all functions take and return it.
#pragma once

#include <Eigen/Core>

namespace gvd {

/// A point of the surface: a face and barycentric coordinates (non-negative, sum 1) in the order
/// of the face's corners. A point on an edge or a vertex has one representation for every face
/// around it; all of them mean the same point, and results depend on which one is given by rounding
/// at most.
///
/// Whether `face` counts the faces of a `TriangleMesh` or the input's triangles is said by the
/// function that takes or returns the point: `TriangleMesh::toInput` and `fromInput` convert.
///
/// In a list of sites, face -1 stands for a label without a site: one that has been removed. Its
/// region is empty, and the other sites keep their labels.
struct SurfacePoint {
  int face = -1;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();
};

/// The next of a face's three corners or sides: 1, 2, 0 after 0, 1, 2. Both functions look it up in
/// the bits of a number, because processors predict a branch on the corner badly.
constexpr int cornerAfter(int i) { return 0b00'10'01 >> 2 * i & 3; }
/// The previous one: 2, 0, 1 before 0, 1, 2.
constexpr int cornerBefore(int i) { return 0b01'00'10 >> 2 * i & 3; }

}  // namespace gvd
