// SPDX-License-Identifier: MIT
#include "distance/given_sites.h"

#include "base/index_set.h"
#include "mesh/given_points.h"
#include "mesh/incidence.h"

namespace gvd {

void GivenSites::change(std::span<const SiteChange> changes) {
  for (const SiteChange& c : changes)
    if (c.site) onMesh(mesh_, *c.site, "site", c.label);
  given_.assign(changes.begin(), changes.end());
  changes_.clear();
  atPlaces_.clear();
  sequence_ = {};
}

bool GivenSites::step(const SiteSet& takingPart, long& budget) {
  return sequence_.run(
      forItems(given_, budget, kSitesPerUnit, [&](const SiteChange& c) { take(c); }),
      [&] { makeSet(atPlaces_); },
      forItems(atPlaces_, budget, kSitesPerUnit, [&](int label) { takePart(label, takingPart); }));
}

/// Changes a site as it was given, and notes which labels may begin or cease to be the lowest at
/// their place.
void GivenSites::take(const SiteChange& given) {
  atPlaces_.push_back(given.label);
  if (sites_.contains(given.label)) {
    const SurfacePoint left = sites_[given.label];
    sites_.remove(given.label);
    if (const int next = lowestAt(left); next >= 0) atPlaces_.push_back(next);
  }
  if (!given.site) return;
  const SurfacePoint site = onMesh(mesh_, *given.site);
  if (const int former = lowestAt(site); former >= 0) atPlaces_.push_back(former);
  sites_.insert(given.label, site);
}

/// The lowest label of the sites at a place, -1 if there is none. Not inlined, as the
/// WebAssembly module would be larger.
[[gnu::noinline]] int GivenSites::lowestAt(const SurfacePoint& place) const {
  const int corner = incidenceOf(place.bary).corner;
  int lowest = -1;
  visitRepresentations(mesh_, place, [&](const SurfacePoint& p) {
    for (const FaceSite& site : sites_.inFace(p.face)) {
      const bool isThere = corner >= 0 ? incidenceOf(site.bary).corner == incidenceOf(p.bary).corner
                                       : site.bary == p.bary;
      if (isThere && (lowest < 0 || site.label < lowest)) lowest = site.label;
    }
  });
  return lowest;
}

/// Adds a change if a label, as the lowest at its place, comes to take part, or if it ceases to.
void GivenSites::takePart(int label, const SiteSet& takingPart) {
  if (sites_.contains(label) && lowestAt(sites_[label]) == label) {
    const SurfacePoint& site = sites_[label];
    if (!takingPart.contains(label) || takingPart[label].face != site.face ||
        takingPart[label].bary != site.bary)
      changes_.push_back({label, site});
  } else if (takingPart.contains(label)) {
    changes_.push_back({label, std::nullopt});
  }
}

}  // namespace gvd
