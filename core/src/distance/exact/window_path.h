// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "distance/exact/label_state.h"
#include "distance/exact/reached_index.h"
#include "distance/path_points.h"
#include "distance/straight_line.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The shortest path from a point back to the site of a label (Mitchell et al. 1987, §3.5). Nothing
/// points backwards: between the vertices at which it turns the path is a straight line of the
/// unfolded faces, of which the virtual source is known, and which is followed from face to face.
class WindowPath {
 public:
  WindowPath(const TriangleMesh& mesh, const SurfacePoint& site, const LabelState& label,
             const ReachedIndex& index);

  /// Begins the path at a point.
  void start(const SurfacePoint& p);
  /// Offers a window of a face that the point lies in; `place` is the point in terms of that face.
  void offer(const Window& w, int halfedge, const SurfacePoint& place);
  /// The path by the best of what was offered, of the corners around the point, and of the straight
  /// line in a face. Empty if none leads to the site.
  std::vector<SurfacePoint> take();

 private:
  /// What is left of a straight piece of the path.
  struct Piece {
    StraightLine line;
    double sourceDistance;
  };
  /// What following a piece comes to, unless it is a vertex.
  enum : int { kAtSite = -1, kLost = -2 };

  int follow(Piece piece);
  Piece lastPiece(int vertex) const;
  int sourceAt(const Piece& piece) const;
  bool leadsOn(int vertex, double distance) const;
  int nearestVertex() const;

  double distanceAt(int vertex) const {
    return index_[vertex] < 0 ? kInfinity : label_.vertices[index_[vertex]].distance;
  }

  const TriangleMesh& mesh_;
  const LabelState& label_;
  PathPoints points_;
  const ReachedIndex& index_;
  /// The vertices at which the path turns or passes come ever nearer to the site: it ends.
  double bound_ = kInfinity;
  // The best beginning.
  double least_ = kInfinity;
  Piece first_;
};

/// The shortest path from a point to the site of a label that has come to the point: unless that is
/// a vertex, through a window that waits at a face which has the point.
std::vector<SurfacePoint> pathToSite(const TriangleMesh& mesh, const SurfacePoint& site,
                                     const LabelState& label, const ReachedIndex& index,
                                     const SurfacePoint& p);

}  // namespace gvd::exact
