// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "distance/label_spread.h"
#include "distance/path_points.h"
#include "distance/straight_line.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::dgpc {

/// A path from a point back to the site of a label, near the shortest one. At every point the
/// distances at the ends of the sides around it put virtual sources behind these, by unfolding as
/// in the sweep; the path heads for the nearest one, or along an edge for a vertex, up to the side
/// or the vertex, and looks again. What it estimates of the distance falls with every point; where
/// it would not, the path keeps to its straight line. Where that leads nowhere, the path goes on
/// over a vertex. Vertices come ever nearer to the site, so it never loops.
class UnfoldingPath {
 public:
  UnfoldingPath(const TriangleMesh& mesh, const SurfacePoint& site,
                std::span<const ReachedVertex> reached);

  /// Empty if no path has been found.
  std::vector<SurfacePoint> from(const SurfacePoint& p);

 private:
  /// Where to go next, and the distance from the site that this makes of the point at hand.
  struct Step {
    double distance = kInfinity;
    SurfacePoint to;
    StraightLine line;  ///< the rest of the way from there, if it is across a side
  };

  bool goStraight();
  Step best() const;
  bool goOverVertex();
  bool goAlongEdges();
  Step nearestCorner() const;
  void offerSide(const SurfacePoint& place, int side, Step& best) const;

  const TriangleMesh& mesh_;
  PathPoints points_;
  std::vector<double> distances_;  ///< at vertices, infinity where the label has not come to
  double bound_ = kInfinity;       ///< the distance at the last vertex of the path
};

}  // namespace gvd::dgpc
