// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "exact/exact_frame.h"
#include "exact/exact_vertices.h"
#include "exact/exact_window.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Distances at vertices, and windows from which the distances of all other points follow.
class Field final : public DistanceField {
 public:
  /// The values of vertex v are `values[offset[v]]` up to `values[offset[v + 1]]`, ascending by
  /// label.
  Field(const TriangleMesh& mesh, std::vector<SurfacePoint> sites, std::vector<Frame> frames,
        WindowPool windows, std::vector<FaceSite> faceSites, VertexTable table,
        std::vector<int> offset, std::vector<LabelledDistance> values);

  std::span<const LabelledDistance> at(int vertex) const override;
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  /// Follows the path back to the site: O(number of faces on its way).
  Eigen::Vector2d direction(int label, int vertex) const override;

 private:
  bool isKnownAt(int vertex, int label) const;
  bool isKnownAround(const SurfacePoint& p, int label) const;
  /// Calls visit(label, length) for paths to a point that include the shortest of every label known
  /// there; the same ones, whichever face the point is given in.
  template <class Visit>
  void visitPaths(const SurfacePoint& p, Visit visit) const;
  template <class Visit>
  void visitPathsInFace(const SurfacePoint& p, Visit visit) const;

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<Frame> frames_;
  WindowPool windows_;
  std::vector<FaceSite> faceSites_;
  VertexTable table_;
  std::vector<int> offset_;
  std::vector<LabelledDistance> values_;
};

}  // namespace gvd::exact
