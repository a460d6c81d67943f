// SPDX-License-Identifier: MIT
#include "distance/edge_bounds.h"

#include <algorithm>

#include "distance/face_layout.h"

namespace gvd {

EdgeBounds::EdgeBounds(const TriangleMesh& mesh, const SiteSet& sites)
    : mesh_(mesh),
      sites_(sites),
      inverseWidth_(2 / mesh.meanEdgeLength()),
      bounds_(mesh.vertexCount()),
      isChanged_(mesh.vertexCount(), false),
      bucketOf_(mesh.vertexCount(), kNone) {}

void EdgeBounds::insert(int label) {
  sites_.visitFacesOf(label, [&](const SurfacePoint& site) {
    offerFrom({label, site.bary}, site.face);
  });
}

/// From a corner, paths run along the edges: other ways to measure these round otherwise in
/// needles.
void EdgeBounds::offerFrom(const FaceSite& site, int face) {
  const int corner = incidenceOf(site.bary).corner;
  if (corner >= 0) return offer(mesh_.tail(3 * face + corner), site.label, 0);
  for (int i = 0; i < 3; ++i)
    offer(mesh_.tail(3 * face + i), site.label, wayToCorner(mesh_.face(face), site.bary, i).norm());
}

/// The vertices of a label are connected with its site by paths of its own. What is around them,
/// vertices and sites, offers its bounds anew.
void EdgeBounds::remove(int label, const SurfacePoint& site) {
  std::vector<int> former;
  const auto take = [&](int v) {
    if (bounds_[v].label != label) return;
    bounds_[v] = {};
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
      const LabelledDistance& beyond = bounds_[neighbour];
      if (beyond.label >= 0) offer(v, beyond.label, beyond.distance + length);
    });
    mesh_.visitFaces(v, [&](int face) {
      for (const FaceSite& other : sites_.inFace(face)) offerFrom(other, face);
    });
  }
}

bool EdgeBounds::run(long& budget) {
  for (; bucket_ < buckets_.size(); ++bucket_) {
    while (!buckets_[bucket_].empty()) {
      if (budget-- <= 0) return false;
      const int v = buckets_[bucket_].back();
      buckets_[bucket_].pop_back();
      if (bucketOf_[v] != static_cast<int>(bucket_)) continue;  // it was lowered, and had its turn
      bucketOf_[v] = kNone;
      const LabelledDistance from = bounds_[v];
      mesh_.visitEdges(v, [&](int neighbour, double length) {
        offer(neighbour, from.label, from.distance + length);
      });
    }
  }
  bucket_ = 0;
  return true;
}

void EdgeBounds::offer(int vertex, int label, double distance) {
  LabelledDistance& bound = bounds_[vertex];
  if (!(distance < bound.distance)) return;
  bound = {label, distance};
  noteChange(vertex);
  const size_t b = std::max(bucket_, static_cast<size_t>(distance * inverseWidth_));
  if (bucketOf_[vertex] == static_cast<int>(b)) return;
  bucketOf_[vertex] = static_cast<int>(b);
  if (b >= buckets_.size()) buckets_.resize(b + 1);
  buckets_[b].push_back(vertex);
}

void EdgeBounds::noteChange(int vertex) {
  if (isChanged_[vertex]) return;
  isChanged_[vertex] = true;
  changed_.push_back(vertex);
}

void EdgeBounds::clearChanged() {
  for (const int v : changed_) isChanged_[v] = false;
  changed_.clear();
}

}  // namespace gvd
