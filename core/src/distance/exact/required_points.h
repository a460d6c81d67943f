// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "distance/exact/label_vertices.h"
#include "distance/exact/required_distances.h"
#include "distance/exact/window.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// A point other than a vertex at which the distance of a label is required.
struct RequiredPoint {
  SurfacePoint point;
  double distance;  ///< of the label: an upper bound
  double nearest;   ///< that of the nearest label
};

/// The required points of a label, by face. Paths are offered to them, which lowers their distances
/// in `RequiredDistances`.
class RequiredPoints {
 public:
  struct InFace {
    int face;
    Eigen::Vector3d bary;
    int index;  ///< in `RequiredDistances`
  };

  /// Both must outlive this.
  RequiredPoints(const TriangleMesh& mesh, RequiredDistances& distances)
      : mesh_(mesh), distances_(distances) {}

  void clear() { inFaces_.clear(); }
  /// Takes points in place of others, with the paths that are straight from a corner of the face.
  void set(std::span<const RequiredPoint> points, const LabelVertices& vertices);

  bool isEmpty() const { return inFaces_.empty(); }
  /// The points in a face; one on an edge is in the faces on both sides.
  std::span<const InFace> in(int face) const;

  /// Offers the paths through a window to the points in its face.
  void offer(const Window& w, int halfedge);
  /// Offers the straight paths from a corner of a face, whose distance is given, to its points.
  void offerFrom(int corner, int face, double distance);

 private:
  const TriangleMesh& mesh_;
  RequiredDistances& distances_;
  std::vector<InFace> inFaces_;  ///< by face
};

}  // namespace gvd::exact
