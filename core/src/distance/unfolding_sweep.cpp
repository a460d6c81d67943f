// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
#include "distance/unfolding_sweep.h"

#include "base/tolerances.h"
#include "mesh/surface_geometry.h"
#include "mesh/unfolding.h"

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

double UnfoldingSweep::unfolded(int halfedge) const {
  const double atTail = distance_[mesh_.tail(halfedge)], atTip = distance_[mesh_.tip(halfedge)];
  return unfold(mesh_, halfedge, atTail, atTip);
}

}  // namespace gvd
