// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "base/bucket_queue.h"
#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/site_set.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Upper bounds on the distance of the nearest site at every vertex: the length of the shortest
/// path along edges (multi-source Dijkstra). Kept up to date while sites are inserted and removed;
/// the result does not depend on the history of changes.
class EdgeBounds {
 public:
  EdgeBounds(const TriangleMesh& mesh, const SiteSet& sites);
  /// Makes room, in slices; true when it is there. Before anything else.
  bool prepare(long& budget) {
    return fillInSlices(vertices_, mesh_.vertexCount(), Vertex(), budget);
  }

  /// Call after `sites.remove`; `site` is where the site was.
  void remove(int label, const SurfacePoint& site);
  /// Forgets the bounds of all vertices whose paths lead to removed sites, in slices; true when
  /// done. Call after all sites were removed, and before any is inserted.
  bool forget(long& budget);
  /// Call after `sites.insert`.
  void insert(int label);
  /// Works on at most `budget` vertices and lowers it by their number; true when all bounds are up
  /// to date.
  bool step(long& budget);

  /// Bounds below this are final, to the width of a bucket, while `step` is not done.
  double front() const { return queue_.front(); }

  double operator[](int vertex) const { return vertices_[vertex].bound; }
  /// The vertices at which a bound has changed since the last `clearChanged`.
  const IndexSet& changed() const { return changed_; }
  void clearChanged() { changed_.clear(); }

 private:
  /// Buckets of the queue per short edge. Hardly any edge leads to a vertex of the same bucket, so
  /// most vertices are processed once (delta-stepping: Meyer & Sanders 2003).
  static constexpr double kBucketsPerEdge = 1.5;
  static constexpr int kNone = -1;
  struct Vertex {
    double bound = kInfinity;
    int label = kNone;  ///< of the site at the path's end
    int from = kNone;   ///< the vertex before this one on the path; none next to the site
    /// The bucket that the vertex is processed from, `kNone` if it is not queued. Other buckets may
    /// hold stale entries of the vertex, which `step` skips.
    int bucket = kNone;
  };

  void forgetBound(int vertex);
  void offerAround(int vertex);
  void offerFrom(const FaceSite& site, int face);
  /// Inlined, because most offers are no improvement.
  void offer(int vertex, int label, double distance, int from) {
    if (distance < vertices_[vertex].bound) improve(vertex, label, distance, from);
  }
  void improve(int vertex, int label, double distance, int from);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  std::vector<Vertex> vertices_;
  BucketQueue queue_;           ///< vertices by distance
  IndexSet changed_;            ///< vertices
  std::vector<int> forgotten_;  ///< vertices whose paths led to removed sites
  size_t followed_ = 0;         ///< how many of these have been followed to the vertices beyond
  SlicedLoop loop_;
};

}  // namespace gvd
