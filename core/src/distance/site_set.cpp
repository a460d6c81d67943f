// SPDX-License-Identifier: MIT
#include "distance/site_set.h"

namespace gvd {

void SiteSet::insert(int label, const SurfacePoint& site) {
  if (label >= labelCount()) points_.resize(label + 1);
  points_[label] = site;
  ++count_;
  visitFacesOf(label, [&](const SurfacePoint& p) { inFace_.add(p.face, {label, p.bary}); });
}

void SiteSet::remove(int label) {
  visitFacesOf(label, [&](const SurfacePoint& p) {
    inFace_.eraseIf(p.face, [&](const FaceSite& site) { return site.label == label; });
  });
  points_[label] = {};
  --count_;
}

}  // namespace gvd
