// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The lengths of the shortest paths along edges from every vertex to a site (Dijkstra,
/// multi-source), kept up to date while sites come and go: upper bounds on the distance of the
/// nearest site. Which changes have led to the present sites makes no difference.
class EdgeBounds {
 public:
  EdgeBounds(const TriangleMesh& mesh, const SiteSet& sites);

  /// To be called after `sites` has got the label.
  void insert(int label);
  /// To be called after `sites` has lost the label; `site` is where it was.
  void remove(int label, const SurfacePoint& site);
  /// Works on at most `budget` vertices and lowers it by their number; true when all bounds are up
  /// to date.
  bool run(long& budget);

  double operator[](int vertex) const { return vertices_[vertex].bound; }
  /// The vertices at which a bound has changed since the last `clearChanged`, each once.
  const std::vector<int>& changed() const { return changed_; }
  void clearChanged();

 private:
  static constexpr int kNone = -1;
  struct Vertex {
    double bound = kInfinity;
    int label = -1;  ///< of the site at the path's end
    /// The bucket in which it has its turn, `kNone`. After a removal, the vertices beside the gap
    /// wait in far buckets; one that a nearer site comes to has its turn before them.
    int bucket : 31 = kNone;
    bool isChanged : 1 = false;
  };

  void offerFrom(const FaceSite& site, int face);
  void offer(int vertex, int label, double distance);
  void noteChange(int vertex);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  double inverseWidth_;
  std::vector<Vertex> vertices_;
  std::vector<std::vector<int>> buckets_;  ///< vertices by distance, in steps of half a mean edge
  size_t bucket_ = 0;
  std::vector<int> changed_;
};

}  // namespace gvd
