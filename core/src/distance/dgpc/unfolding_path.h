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

/// A path from a point back to the site of a label, near the shortest one. At each point, virtual
/// sources are unfolded behind the surrounding sides as in the sweep. The path takes one step
/// towards the nearest of them, or along an edge to a vertex if that is shorter, and repeats. The
/// estimated distance must fall with every step; otherwise the path keeps to its previous straight
/// line, and if that leads nowhere, goes on over a vertex. The distances of successive vertices
/// fall, so the path never loops.
class UnfoldingPath {
 public:
  UnfoldingPath(const TriangleMesh& mesh, const SurfacePoint& site,
                std::span<const ReachedVertex> reached);

  /// Empty if no path has been found.
  std::vector<SurfacePoint> from(const SurfacePoint& p);

 private:
  /// The next point, and the distance of the current point from the site by way of it.
  struct Step {
    double distance = kInfinity;
    SurfacePoint to;
    StraightLine line;  ///< the rest of the way, if the step crosses a side
  };

  bool goStraight();
  Step best() const;
  bool goOverVertex();
  bool goAlongEdges();
  Step nearestCorner() const;
  void offerSide(const SurfacePoint& place, int side, Step& best) const;

  const TriangleMesh& mesh_;
  PathPoints points_;
  std::vector<double> distances_;  ///< at vertices, infinity where the label has not been
  double bound_ = kInfinity;       ///< the distance at the last vertex of the path
};

}  // namespace gvd::dgpc
