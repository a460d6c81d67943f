// SPDX-License-Identifier: MIT
#include "distance/site_set.h"

namespace gvd {
namespace {

/// A site that is off an edge or vertex by less than rounding is on it: the faces beside it would
/// see it on the wrong side.
SurfacePoint onEdgeOrVertex(SurfacePoint p) {
  constexpr double kRounding = 0x1p-44;  // some hundred times that of a coordinate
  if (!(p.bary.array() > 0 && p.bary.array() < kRounding).any()) return p;
  p.bary = (p.bary.array() < kRounding).select(0, p.bary).eval();
  p.bary /= p.bary.sum();
  return p;
}

}  // namespace

void SiteSet::insert(int label, const SurfacePoint& given) {
  const SurfacePoint point = onEdgeOrVertex(given);
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
