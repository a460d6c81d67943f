// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "gvd/triangle_mesh.h"

namespace gvd {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `v` in a frame whose x axis is the unit vector `axis`.
inline Eigen::Vector2d turned(const Eigen::Vector2d& v, const Eigen::Vector2d& axis) {
  return {v.dot(axis), cross(axis, v)};
}

/// How a vertex sees a site: through a strip of faces, unfolded into the frame of the strip's last
/// halfedge (TriangleMesh::Layout), of which the vertex is the apex. This is the vertex's polar
/// coordinate about the site together with what it takes to carry it on.
struct View {
  Eigen::Vector2d source = {0, 0};  ///< the site, or the vertex where the path to it bends last
  /// From the source to the vertices that limit the view on either side; zero: none does.
  Eigen::Vector2d left = {0, 0}, right = {0, 0};
  /// Unit vector. While the path is straight, the site's reference direction, in this frame; once
  /// it has bent, the direction in which it left the site, in the site's frame.
  Eigen::Vector2d heading = {1, 0};
  double offset = 0;  ///< length of the path from the site to the source
  int halfedge = -1;  ///< -1: the vertex is the site
  bool isBent = false;

  /// The direction, in the site's frame, in which a path leaves the site that ends here in the
  /// given unit direction; the latter in a frame whose x axis is `axis` in the view's.
  Eigen::Vector2d departure(const Eigen::Vector2d& arrival, const Eigen::Vector2d& axis) const {
    return isBent ? heading : turned(arrival, turned(heading, axis));
  }

  /// The direction in which the path of this length to the view's own vertex leaves the site; the
  /// site's reference direction if that is the vertex.
  Eigen::Vector2d departure(const TriangleMesh& mesh, double distance) const {
    if (isBent) return heading;
    const double straight = distance - offset;
    if (halfedge < 0 || !(straight > 0)) return {1, 0};
    const TriangleMesh::Layout& l = mesh.layout(halfedge);
    return departure((Eigen::Vector2d(l.x, l.y) - source) / straight, {1, 0});
  }
};

}  // namespace gvd
