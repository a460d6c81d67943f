// SPDX-License-Identifier: MIT
#include "distance/edge_bounds.h"

#include <algorithm>

#include "base/prefetch.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"
#include "mesh/prefetch_around.h"

namespace gvd {

EdgeBounds::EdgeBounds(const TriangleMesh& mesh, const SiteSet& sites)
    : mesh_(mesh),
      sites_(sites),
      queue_(kBucketsPerEdge / mesh.shortEdgeLength()),
      changed_(mesh.vertexCount()) {}

void EdgeBounds::insert(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) {
    offerFrom({label, site.bary}, site.face);
  });
}

/// A site at a corner bounds that corner alone, and paths go on along the edges: in needles,
/// distances from the site within the face would round differently from edge lengths.
void EdgeBounds::offerFrom(const FaceSite& site, int face) {
  const int corner = incidenceOf(site.bary).corner;
  if (corner >= 0) return offer(mesh_.tail(3 * face + corner), site.label, 0, kNone);
  for (int i = 0; i < 3; ++i)
    offer(mesh_.tail(3 * face + i), site.label, distanceToCorner(mesh_.face(face), site.bary, i),
          kNone);
}

void EdgeBounds::remove(int label, const SurfacePoint& site) {
  const auto forgetNextToSite = [&](int v) {
    if (vertices_[v].label == label && vertices_[v].from == kNone) forgetBound(v);
  };
  for (int h = 3 * site.face; h < 3 * site.face + 3; ++h) {
    forgetNextToSite(mesh_.tail(h));
    if (mesh_.twin(h) >= 0) forgetNextToSite(mesh_.tail(TriangleMesh::previous(mesh_.twin(h))));
  }
}

void EdgeBounds::forgetBound(int vertex) {
  Vertex& own = vertices_[vertex];
  own.bound = kInfinity;
  own.label = own.from = kNone;
  changed_.add(vertex);
  forgotten_.push_back(vertex);
}

/// The vertices beyond are found by `from`, not by label: if a vertex gets a shorter path of
/// another label, and the bound of a vertex beyond it rounds to what it was, that one keeps its
/// former label. Once all are forgotten, the neighbours, and the sites in the faces around, offer
/// bounds anew.
bool EdgeBounds::forget(long& budget) {
  for (; followed_ < forgotten_.size(); ++followed_) {
    if (budget-- <= 0) return false;
    const int from = forgotten_[followed_];
    mesh_.visitNeighbours(from, [&](int v) {
      if (vertices_[v].from == from) forgetBound(v);
    });
  }
  if (!loop_.run(forgotten_.size(), budget, 1, [&](int i) { offerAround(forgotten_[i]); }))
    return false;
  forgotten_.clear();
  followed_ = 0;
  return true;
}

void EdgeBounds::offerAround(int vertex) {
  mesh_.visitEdges(vertex, [&](int neighbour, double length) {
    const Vertex& beyond = vertices_[neighbour];
    if (beyond.label >= 0) offer(vertex, beyond.label, beyond.bound + length, neighbour);
  });
  mesh_.visitFaces(vertex, [&](int face) {
    for (const FaceSite& other : sites_.inFace(face)) offerFrom(other, face);
  });
}

/// The vertices of a bucket come in the order in which they were queued. Where edges are much
/// shorter than the bucket is wide, the latest first would make paths longer and longer, and lower
/// each bound again and again.
bool EdgeBounds::step(long& budget) {
  while (queue_.advance()) {
    if (budget-- <= 0) return false;
    if (const auto later = queue_.ahead(2 * kPrefetchAhead)) prefetchFan(mesh_, *later);
    for (const int next : queue_.toPrefetch())
      mesh_.visitFaces(next, [&](int f) { prefetchInBatch(mesh_.face(f).lengths); });
    const int v = queue_.take();
    Vertex& own = vertices_[v];
    if (own.bucket != static_cast<int>(queue_.frontBucket())) continue;  // a stale entry
    own.bucket = kNone;
    mesh_.visitEdges(v, [&](int neighbour, double length) {
      offer(neighbour, own.label, own.bound + length, v);
    });
  }
  return true;
}

void EdgeBounds::improve(int v, int label, double distance, int from) {
  Vertex& own = vertices_[v];
  own.bound = distance;
  own.label = label;
  own.from = from;
  changed_.add(v);
  const size_t bucket = queue_.bucketOf(distance);
  if (own.bucket == static_cast<int>(bucket)) return;
  own.bucket = static_cast<int>(bucket);
  queue_.add(v, bucket);
}

}  // namespace gvd
