// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "distance/exact/label_state.h"
#include "distance/path_points.h"
#include "distance/reached_index.h"
#include "distance/straight_line.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The shortest path from a point back to the site of a label (Mitchell et al. 1987, §3.5). No back
/// pointers are kept. Between the vertices at which it turns, the path is a straight line of the
/// unfolded faces towards a known virtual source, followed from face to face.
class WindowPath {
 public:
  WindowPath(const TriangleMesh& mesh, const SurfacePoint& site, const LabelState& label,
             const ReachedIndex& index);

  /// Begins the path at a point.
  void start(const SurfacePoint& p);
  /// Offers a window of a face that the point lies in; `place` is the point in that face.
  void offer(const Window& w, int halfedge, const SurfacePoint& place);
  /// The shortest path: through an offered window, over a corner around the point, or straight
  /// within a face. Empty if none leads to the site.
  std::vector<SurfacePoint> take();

 private:
  /// The rest of a straight piece of the path, up to its virtual source.
  struct Piece {
    StraightLine line;
    double sourceDistance;
  };
  /// Where a followed piece ends, other than at a vertex.
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
  /// The distance at the path's last vertex. The next vertex must be nearer to the site, so the
  /// path ends.
  double bound_ = kInfinity;
  // The best beginning.
  double least_ = kInfinity;
  Piece first_;
};

/// The shortest path from a point to the site of a label that has reached it. For a point that is
/// no vertex, the windows of its faces must be among the label's waiting windows.
std::vector<SurfacePoint> pathToSite(const TriangleMesh& mesh, const SurfacePoint& site,
                                     const LabelState& label, const ReachedIndex& index,
                                     const SurfacePoint& p);

}  // namespace gvd::exact
