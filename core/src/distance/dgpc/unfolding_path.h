// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "distance/path_points.h"
#include "distance/straight_line.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::dgpc {

/// A path from a point back to the site of a label, by the label's distances at vertices. At each
/// point, virtual sources are unfolded behind the surrounding sides as in the sweep. The path takes
/// one step towards the nearest of them, or along an edge to a vertex if that is shorter, and
/// repeats. The estimated distance must fall with every step; otherwise the path keeps to its
/// previous straight line, and if that leads nowhere, goes on over a nearer vertex beside its last
/// one. The distances of successive vertices fall, so the path never loops.
class UnfoldingPath {
 public:
  /// Infinite at vertices that the label has not reached.
  using DistanceAt = std::function<double(int vertex)>;

  UnfoldingPath(const TriangleMesh& mesh, const SurfacePoint& site, DistanceAt distanceAt)
      : mesh_(mesh), points_(mesh, site), distanceAt_(std::move(distanceAt)) {}

  /// Empty if the distances contradict each other so much that they lead nowhere.
  std::vector<SurfacePoint> from(const SurfacePoint& p);

 private:
  /// The next point, and the distance of the current point from the site by way of it.
  struct Step {
    double distance = kInfinity;
    SurfacePoint to;
    StraightLine line;  ///< the rest of the way, if the step crosses a side
  };

  bool goStraight();
  bool goOverVertex();
  Step best() const;
  void offerSide(const SurfacePoint& place, int side, Step& best) const;

  const TriangleMesh& mesh_;
  PathPoints points_;
  const DistanceAt distanceAt_;
  double bound_ = kInfinity;  ///< the distance at the last vertex of the path
};

}  // namespace gvd::dgpc
