// SPDX-License-Identifier: MIT
#include "distance/site_set.h"

namespace gvd {

void SiteSet::insert(int label, const SurfacePoint& point) {
  if (label >= labelCount()) points_.resize(label + 1);
  points_[label] = point;
  ++count_;
  visitFaces(point, [&](const SurfacePoint& p) { inFace_.add(p.face, {label, p.bary}); });
}

void SiteSet::remove(int label) {
  visitFaces(points_[label], [&](const SurfacePoint& p) {
    const auto sites = inFace_[p.face];
    size_t i = 0;
    while (sites[i].label != label) ++i;
    inFace_.erase(p.face, i);
  });
  points_[label] = {};
  --count_;
}

}  // namespace gvd
