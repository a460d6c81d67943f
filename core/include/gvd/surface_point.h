// SPDX-License-Identifier: MIT
/// \file
/// A point on a surface, as all functions take and return it.
#pragma once

#include <Eigen/Core>

namespace gvd {

/// A point of the surface: a face and barycentric coordinates (non-negative, sum 1) in the order
/// of the face's corners. A point on an edge or a vertex has one representation for every face
/// around it; all of them mean the same point, and results do not depend on which one is given.
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

}  // namespace gvd
