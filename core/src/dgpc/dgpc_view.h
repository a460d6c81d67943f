// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <numbers>

#include "base/plane.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

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
  /// Of a path that bends: from the source to where the site would be seen through the same faces
  /// if the path did not; not known if the detour is not.
  Eigen::Vector2d toSite = {0, 0};
  double offset = 0;  ///< length of the path from the site to the source
  int halfedge = -1;  ///< -1: the vertex is the site
  /// By how much the path is longer than if it were straight where it bends, through the same
  /// faces: by no more can it be cut short there. Negative if it does not bend, infinite
  /// if that is not known.
  float detour = -1;

  bool operator==(const View& other) const = default;

  bool isBent() const { return detour >= 0; }
  /// The detour after one more bend, between two straight pieces that are given in one frame.
  float detourAfter(const Eigen::Vector2d& before, const Eigen::Vector2d& after) const {
    const double longer = before.norm() + after.norm() - (before + after).norm();
    return std::max(detour, 0.0f) + static_cast<float>(std::max(longer, 0.0));
  }

  /// What is seen, in another frame, of which the origin and the x axis are given in this one.
  View inFrame(int otherHalfedge, const Eigen::Vector2d& origin, const Eigen::Vector2d& axis) const;

  /// From the source to the view's own vertex.
  Eigen::Vector2d path(const TriangleMesh& mesh) const {
    const TriangleMesh::Layout& l = mesh.layout(halfedge);
    return Eigen::Vector2d(l.x, l.y) - source;
  }

  /// The length of the path to the view's own vertex.
  double distance(const TriangleMesh& mesh) const {
    return halfedge < 0 ? 0 : offset + path(mesh).norm();
  }

  /// The direction, in the site's frame, in which a path leaves the site that ends here in the
  /// given unit direction.
  Eigen::Vector2d departure(const Eigen::Vector2d& arrival) const {
    return isBent() ? heading : turnedBackBy(arrival, heading);
  }

  /// The direction in which the path of this length to the view's own vertex leaves the site; the
  /// site's reference direction if that is the vertex.
  Eigen::Vector2d departure(const TriangleMesh& mesh, double distance) const {
    if (isBent()) return heading;
    const double straight = distance - offset;
    if (halfedge < 0 || !(straight > 0)) return {1, 0};
    return departure(path(mesh) / straight);
  }
};

/// Whether shortest paths may bend at a vertex: at inner saddles, and on the boundary. What they
/// hide is only reached around them, so they limit views. At all others paths on both sides of the
/// vertex reach every point behind it, and a view that is carried on past such a vertex gives no
/// length that is less than the distance (the hinge theorem for non-negative curvature): it needs
/// no limit, and in the plane every view of a site is the same.
inline bool limitsViews(const TriangleMesh& mesh, int vertex) {
  constexpr double kFlat = 2 * std::numbers::pi * (1 + 1e-12);  // of the sum of rounded angles
  return mesh.onBoundary(vertex) || mesh.angleSum(vertex) > kFlat;
}
/// Whether it does so by far, so that much of what is behind it is hidden: as on the edges of
/// machine parts and of holes, and hardly where a mesh stands for a smooth surface.
bool castsShadow(const TriangleMesh& mesh, int vertex);

/// How far a site is from a corner of its face, and how that corner sees it.
double distanceOfCorner(const TriangleMesh& mesh, const SurfacePoint& site, int corner);
View viewOfCorner(const TriangleMesh& mesh, const SurfacePoint& site, int corner);

/// An edge from a vertex to a neighbour, with a face beside it through which the neighbour sees the
/// vertex: the vertex is the tail or the tip of the halfedge, the neighbour the apex.
struct Spoke {
  int halfedge;
  bool isFromTail;
  int neighbour;
  double length;
  double angle;  ///< counterclockwise from the vertex's first outgoing halfedge
};

/// Calls `visit` for every edge at a vertex, counterclockwise.
template <class Visit>
void visitSpokes(const TriangleMesh& mesh, int vertex, Visit visit) {
  const int first = mesh.outgoing(vertex);
  double angle = 0;
  int h = first;
  do {
    const int back = TriangleMesh::previous(h);
    visit(Spoke{back, false, mesh.tip(h), mesh.length(h), angle});
    angle += mesh.cornerAngle(h);
    if (mesh.twin(back) < 0) visit(Spoke{h, true, mesh.tail(back), mesh.length(back), angle});
    h = mesh.twin(back);
  } while (h >= 0 && h != first);
}

/// How the neighbour along a spoke sees a site at the spoke's vertex.
View viewAlong(const TriangleMesh& mesh, const Spoke& spoke, double angleOfFirst);
/// How the apex of a halfedge's face sees a site along a path that bends at an end of the halfedge,
/// having come there at the distance `offset` from the site. Its detour is not known.
View viewOverEnd(const TriangleMesh& mesh, int halfedge, bool isFromTail, double offset,
                 const Eigen::Vector2d& departure);

}  // namespace gvd
