// SPDX-License-Identifier: MIT
//
// WindowSweep::search: from a point back to the sites nearest to it.

#include "base/sliced_loop.h"
#include "distance/exact/window_sweep.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd::exact {

LabelState WindowSweep::search(const SurfacePoint& p, const SearchBounds& bounds, long& budget) {
  LabelState state;
  begin(-1, SpreadTo::kSites, state);
  search_.start(bounds);
  visitRepresentations(mesh_, p, [&](const SurfacePoint& place) {
    const TriangleMesh::Face& face = mesh_.face(place.face);
    for (int i = 0; i < 3; ++i)
      search_.offerVertex(face.vertices[i], distanceToCorner(face, place.bary, i));
    search_.visitSites(place.face, [&](const FaceSite& site) {
      search_.offerSite(site.label, layOut(face, 0, site.bary - place.bary).norm());
    });
  });
  if (search_.shortest() < kInfinity) startAt(p);
  long left = kUnlimited;
  step(left);
  budget -= kUnlimited - left;
  state_ = nullptr;
  return state;
}

/// Offers the straight paths through windows to the sites in their face.
void WindowSweep::offerSites(int h, std::span<const Window> windows) {
  const TriangleMesh::Face& face = mesh_.face(h / 3);
  search_.visitSites(h / 3, [&](const FaceSite& site) {
    const Eigen::Vector2d s = layOut(face, h % 3, site.bary);
    for (const Window& w : windows)
      if (search_.offerSite(site.label, w.distance(s.x(), s.y())))
        waiting_.windows.push_back({w, h});
  });
}

}  // namespace gvd::exact
