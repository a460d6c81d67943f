// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "dgpc/dgpc_field.h"
#include "dgpc/face_strip.h"

namespace gvd {

/// Turns the paths by which vertices see sites into geodesics. Views err: a line of sight may leave
/// the faces it was unfolded through, and where views end, paths bend whether or not they have to.
class PathStraightener {
 public:
  explicit PathStraightener(const DgpcField& field)
      : field_(field), mesh_(field.mesh()), strip_(field.mesh()) {}

  /// The geodesic that is found near the path by which a vertex sees the site of a label: of a
  /// straight line to the site and, should that be none or longer than the view's path, what
  /// follows from that path, the shorter. From where it bends, the path goes on by the views of the
  /// label's own vertices: the result depends on these, the view and the mesh only. Nothing if the
  /// views lead nowhere. O(faces on the way), a few times.
  std::optional<LocalGeodesic> straighten(int label, int vertex, const View& view);

  /// The vertex where the path of a view to a site bends last, or the site's; negative if that is
  /// in a face. Nothing if the line from the view's vertex does not lead there. O(faces on the
  /// way).
  std::optional<int> lookBack(const View& view, const SurfacePoint& site);

 private:
  std::optional<LocalGeodesic> aim(int halfedge, Eigen::Vector2d line, const SurfacePoint& site);
  bool followViews(int label, int vertex, const View& first);
  int stepToOwner(int label, int vertex) const;

  const DgpcField& field_;
  const TriangleMesh& mesh_;
  FaceStrip strip_;
  std::vector<int> walkedThrough_;  ///< halfedges
};

}  // namespace gvd
