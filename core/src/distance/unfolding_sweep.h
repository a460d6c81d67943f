// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/heap.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The distances of one site after another, each around the site as far as asked for: geodesic
/// polar coordinates without the angle (Melvær & Reimers 2012). The distance at a vertex follows
/// from those at two others of a face by a virtual source, or else along an edge; label-correcting,
/// so exact in the plane where the way is free. What one site costs depends on how far it spreads
/// only.
///
/// Less accurate than the sweep behind `propagate`, which carries the views of vertices, but that
/// one starts from scratch; this is for sampling.
class UnfoldingSweep {
 public:
  explicit UnfoldingSweep(const TriangleMesh& mesh)
      : mesh_(mesh), distance_(mesh.vertexCount(), kInfinity) {}

  /// Spreads from a site: from a vertex on to its neighbours where spreads(vertex, distance).
  template <class Spreads>
  void run(const SurfacePoint& site, Spreads spreads);

  /// The vertices that the last site has come to; it may not have spread on from them.
  const std::vector<int>& reached() const { return reached_; }
  /// The last site's distance, infinite where it has not come to.
  double distance(int vertex) const { return distance_[vertex]; }

 private:
  struct Item {
    double distance;
    int vertex;
    bool operator<(const Item& other) const {
      return distance < other.distance || (distance == other.distance && vertex < other.vertex);
    }
  };

  void seed(const SurfacePoint& site);
  void offer(int vertex, double distance);
  void offerToNeighbours(int vertex);
  /// The distance of a halfedge's apex from what is known at its two ends.
  double unfolded(int halfedge) const;

  const TriangleMesh& mesh_;
  std::vector<double> distance_;
  std::vector<int> reached_;
  QuaternaryHeap<Item> queue_;
};

template <class Spreads>
void UnfoldingSweep::run(const SurfacePoint& site, Spreads spreads) {
  for (const int v : reached_) distance_[v] = kInfinity;
  reached_.clear();
  seed(site);
  while (!queue_.empty()) {
    const Item item = queue_.top();
    queue_.pop();
    if (item.distance == distance_[item.vertex] && spreads(item.vertex, item.distance))
      offerToNeighbours(item.vertex);
  }
}

}  // namespace gvd
