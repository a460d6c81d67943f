// SPDX-License-Identifier: MIT
#include "distance/site_set.h"

#include "base/tolerances.h"

namespace gvd {
namespace {

/// Moves a site within rounding of an edge or vertex onto it: unfolded into the faces beside it,
/// such a site might come out on the wrong side.
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
