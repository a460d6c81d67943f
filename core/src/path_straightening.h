// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "dgpc_field.h"
#include "face_strip.h"

namespace gvd {

/// Turns the paths that the vertices of a field know, from view to view, into geodesics. Views err:
/// a line of sight may leave the faces it was unfolded through, and where views end, paths bend
/// whether or not they have to. What comes after this depends on the owners' views only.
class PathStraightener {
 public:
  explicit PathStraightener(const DgpcField& field)
      : field_(field), mesh_(field.mesh()), strip_(field.mesh()) {}

  /// From the site of a label to a vertex that it owns, or that has a neighbour that it owns:
  /// nothing if that is not so, or if the views lead nowhere. O(faces on the way), a few times.
  std::optional<LocalGeodesic> straighten(int label, int vertex);

 private:
  bool followViews(int label, int vertex);
  int stepToOwner(int label, int vertex) const;
  std::optional<int> lookBack(const View& view, const SurfacePoint& site);

  const DgpcField& field_;
  const TriangleMesh& mesh_;
  FaceStrip strip_;
  std::vector<int> seenThrough_;  ///< halfedges, from a vertex back to the source of its view
};

}  // namespace gvd
