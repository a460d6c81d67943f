// SPDX-License-Identifier: MIT
#include "distance/site_set.h"

#include "base/tolerances.h"

namespace gvd {
namespace {

/// A site that is off an edge or vertex by less than rounding is on it: the faces beside it would
/// see it on the wrong side.
SurfacePoint onEdgeOrVertex(SurfacePoint p) {
  if (!(p.bary.array() > 0 && p.bary.array() < kCoordinateRounding).any()) return p;
  p.bary = (p.bary.array() < kCoordinateRounding).select(0, p.bary).eval();
  p.bary /= p.bary.sum();
  return p;
}

}  // namespace

void SiteSet::insert(int label, const SurfacePoint& given) {
  if (label >= labelCount()) points_.resize(label + 1);
  points_[label] = onEdgeOrVertex(given);
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
