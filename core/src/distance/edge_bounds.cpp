// SPDX-License-Identifier: MIT
#include "distance/edge_bounds.h"

#include <algorithm>

#include "distance/face_layout.h"
#include "mesh/surface_geometry.h"

namespace gvd {

EdgeBounds::EdgeBounds(const TriangleMesh& mesh, const SiteSet& sites)
    : mesh_(mesh),
      sites_(sites),
      inverseWidth_(2 / mesh.meanEdgeLength()),
      vertices_(mesh.vertexCount()) {}

void EdgeBounds::insert(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) {
    offerFrom({label, site.bary}, site.face);
  });
}

/// A site at a corner bounds that corner alone, and paths go on along the edges: in needles,
/// distances from the site within the face would round differently from edge lengths.
void EdgeBounds::offerFrom(const FaceSite& site, int face) {
  const int corner = incidenceOf(site.bary).corner;
  if (corner >= 0) return offer(mesh_.tail(3 * face + corner), site.label, 0);
  for (int i = 0; i < 3; ++i)
    offer(mesh_.tail(3 * face + i), site.label, wayToCorner(mesh_.face(face), site.bary, i).norm());
}

/// The shortest edge path of a vertex bounded by a label runs over vertices bounded by the same
/// label, so a flood fill from the site finds them all. Their neighbours, and the sites in the
/// faces around them, offer bounds anew.
void EdgeBounds::remove(int label, const SurfacePoint& site) {
  std::vector<int> former;
  const auto take = [&](int v) {
    if (vertices_[v].label != label) return;
    vertices_[v].label = -1;
    vertices_[v].bound = kInfinity;
    noteChange(v);
    former.push_back(v);
  };
  for (int h = 3 * site.face; h < 3 * site.face + 3; ++h) {
    take(mesh_.tail(h));
    if (mesh_.twin(h) >= 0) take(mesh_.tail(TriangleMesh::previous(mesh_.twin(h))));
  }
  for (size_t i = 0; i < former.size(); ++i) mesh_.visitNeighbours(former[i], take);
  for (const int v : former) {
    mesh_.visitEdges(v, [&](int neighbour, double length) {
      const Vertex& beyond = vertices_[neighbour];
      if (beyond.label >= 0) offer(v, beyond.label, beyond.bound + length);
    });
    mesh_.visitFaces(v, [&](int face) {
      for (const FaceSite& other : sites_.inFace(face)) offerFrom(other, face);
    });
  }
}

bool EdgeBounds::run(long& budget) {
  constexpr size_t kAhead = 2;  // turns before its own at which a vertex's faces are fetched
  for (; bucket_ < buckets_.size(); ++bucket_) {
    while (!buckets_[bucket_].empty()) {
      if (budget-- <= 0) return false;
      std::vector<int>& bucket = buckets_[bucket_];
      if (bucket.size() > kAhead) prefetchFan(mesh_, bucket[bucket.size() - 1 - kAhead]);
      const int v = bucket.back();
      buckets_[bucket_].pop_back();
      Vertex& own = vertices_[v];
      if (own.bucket != static_cast<int>(bucket_)) continue;  // a stale entry
      own.bucket = kNone;
      mesh_.visitEdges(v, [&](int neighbour, double length) {
        offer(neighbour, own.label, own.bound + length);
      });
    }
  }
  bucket_ = 0;
  return true;
}

void EdgeBounds::offer(int v, int label, double distance) {
  Vertex& own = vertices_[v];
  if (!(distance < own.bound)) return;
  own.bound = distance;
  own.label = label;
  noteChange(v);
  const size_t b = std::max(bucket_, static_cast<size_t>(distance * inverseWidth_));
  if (own.bucket == static_cast<int>(b)) return;
  own.bucket = static_cast<int>(b);
  if (b >= buckets_.size()) buckets_.resize(b + 1);
  buckets_[b].push_back(v);
}

void EdgeBounds::noteChange(int v) {
  if (vertices_[v].isChanged) return;
  vertices_[v].isChanged = true;
  changed_.push_back(v);
}

void EdgeBounds::clearChanged() {
  for (const int v : changed_) vertices_[v].isChanged = false;
  changed_.clear();
}

}  // namespace gvd
