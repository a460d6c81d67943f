// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "unfolding_sweep.h"

#include "surface_geometry.h"
#include "tolerances.h"

namespace gvd {

void UnfoldingSweep::seed(const SurfacePoint& site) {
  const auto sides = squaredSides(mesh_, site.face);
  for (int i = 0; i < 3; ++i)
    offer(mesh_.tail(3 * site.face + i),
          std::sqrt(squaredDistance(site.bary, Eigen::Vector3d::Unit(i), sides)));
}

void UnfoldingSweep::offer(int vertex, double distance) {
  double& known = distance_[vertex];
  if (!(distance < known * (1 - kDistanceTolerance))) return;
  if (known == kInfinity) reached_.push_back(vertex);
  known = distance;
  queue_.push({distance, vertex});
}

void UnfoldingSweep::offerToNeighbours(int vertex) {
  const int first = mesh_.outgoing(vertex);
  int h = first;
  do {
    const int back = TriangleMesh::previous(h);
    const int right = mesh_.tip(h), left = mesh_.tail(back);
    // The apex across each of the face's two sides here, the other end of which may be known or
    // not.
    const double toLeft = unfolded(h), toRight = unfolded(back);
    offer(left, toLeft);
    offer(right, toRight);
    h = mesh_.twin(back);
  } while (h >= 0 && h != first);
}

/// The distance of a halfedge's apex from what is known at its two ends.
double UnfoldingSweep::unfolded(int halfedge) const {
  constexpr double kRounding = 1e-12;
  const TriangleMesh::Layout& l = mesh_.layout(halfedge);
  const double atTail = distance_[mesh_.tail(halfedge)], atTip = distance_[mesh_.tip(halfedge)];
  if (atTail < kInfinity && atTip < kInfinity) {
    // The virtual source is at (x, -y), the apex at (l.x, l.y).
    const double x = ((atTail - atTip) * (atTail + atTip) + l.length * l.length) * l.inverse;
    const double squaredY = atTail * atTail - x * x;
    if (squaredY > -kRounding * atTail * atTail) {
      const double y = squaredY > 0 ? std::sqrt(squaredY) : 0;
      // Where the line between them crosses the halfedge's line, times (y + l.y).
      const double across = x * l.y + l.x * y, height = l.y + y;
      const double slack = kRounding * l.length * height;
      if (across >= -slack && across <= l.length * height + slack)
        return std::sqrt((l.x - x) * (l.x - x) + height * height);
    }
  }
  return std::min(atTail + mesh_.length(TriangleMesh::previous(halfedge)),
                  atTip + mesh_.length(TriangleMesh::next(halfedge)));
}

}  // namespace gvd
