// SPDX-License-Identifier: MIT
//
// WindowSweep::search: from a point back to the sites nearest to it.
#include <algorithm>
#include <limits>

#include "distance/exact/window_sweep.h"
#include "distance/path_points.h"

namespace gvd::exact {

void WindowSweep::search(const SurfacePoint& p, const KnownDistances& known, const SiteSet& sites,
                         LabelState& state) {
  begin(-1, SpreadTo::kSites, state);
  known_ = &known;
  sites_ = &sites;
  shortest_ = kInfinity;
  foundSites_.clear();
  visitPlaces(mesh_, p, [&](const SurfacePoint& place) {
    const TriangleMesh::Face& face = mesh_.face(place.face);
    for (int i = 0; i < 3; ++i)
      shorten(known.atMost(face.vertices[i]) + wayToCorner(face, place.bary, i).norm());
    for (const FaceSite& site : sites.inFace(place.face)) {
      if (!isSearchedFor(site)) continue;
      foundSites_.push_back({site.label, layOut(face, 0, site.bary - place.bary).norm()});
      shorten(foundSites_.back().distance);
    }
  });
  if (shortest_ < kInfinity) startAt(p);
  long unlimited = std::numeric_limits<long>::max();
  run(unlimited);
}

/// The largest distance of a vertex from the point with which a path over the vertex is no longer
/// than the shortest known one. For a place on an edge beside the vertex, the way along the edge is
/// added. The tolerance admits paths that tie.
double WindowSweep::mostUpTo(int v) const {
  return shortest_ * (1 + kDistanceTolerance) - known_->atLeast(v);
}

void WindowSweep::shorten(double length) { shortest_ = std::min(shortest_, length); }

/// Sites on vertices are found by their distance 0 at the vertex instead.
bool WindowSweep::isSearchedFor(const FaceSite& site) const {
  return known_->isAbout(site.label) && incidenceOf(site.bary).corner < 0;
}

/// Offers the straight paths through windows to the sites in their face.
void WindowSweep::offerSites(int h, std::span<const Window> windows) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  for (const FaceSite& site : sites_->inFace(h / 3)) {
    if (!isSearchedFor(site)) continue;
    const Eigen::Vector2d s = layOut(face, h % 3, site.bary);
    for (const Window& w : windows) {
      const double length = w.distance(s.x(), s.y());
      if (!(length <= shortest_ * (1 + kDistanceTolerance))) continue;
      shorten(length);
      foundSites_.push_back({site.label, length});
      waiting_.push_back({w, h});
    }
  }
}

}  // namespace gvd::exact
