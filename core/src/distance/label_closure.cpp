// SPDX-License-Identifier: MIT
#include "distance/label_closure.h"

#include <array>

#include "distance/edge_share.h"
#include "distance/labelled_distances.h"
#include "mesh/slits.h"

namespace gvd {

void LabelClosure::beginChange() {
  sequence_ = {};
  found_.clear();
  extended_.clear();
}

bool LabelClosure::step(long& budget) {
  return sequence_.run(
      forItems(changedFaces_.list(), budget, kQuickRounds, [&](int f) { return closeFace(f); }),
      [&] { turns_.setRequired(found_); },
      [&] {
        return turns_.step(budget,
                           [&](int l, const auto& faces) { return listRequired(l, faces); });
      },
      forItems(extended_.list(), budget, kQuickRounds, [&](int v) { lists_.equalizeTies(v); }));
}

// --- Listing -------------------------------------------------------------------------------------

/// Lists a label at all corners of the faces that it was required at. Returns the faces that it is
/// required at besides.
std::vector<int> LabelClosure::listRequired(int label, std::span<const int> faces) {
  added_.clear();
  for (const int f : faces)
    for (const int v : mesh_.face(f).vertices)
      if (lists_.distance(v, label) == kInfinity) {
        lists_.add(label, spread_.indexOf(v));
        added_.push_back(v);
        extended_.add(v);
      }
  found_.clear();
  for (const int v : added_) closeAround(v, label);
  // Also required is a label that was the sole owner of a face: it is known at the corners already.
  std::vector<int> others;
  for (const Requirement& r : found_)
    if (r.label == label) others.push_back(r.face);
  return others;
}

// --- What is required ----------------------------------------------------------------------------

/// Returns how many quick rounds it took.
long LabelClosure::closeFace(int f) {
  constexpr long kRoundsPerLabel = 8;  // labels known at two corners are compared with others
  const std::array<int, 3>& corners = mesh_.face(f).vertices;
  const auto a = lists_[corners[0]], b = lists_[corners[1]], c = lists_[corners[2]];
  if ((a.size() > 1) + (b.size() > 1) + (c.size() > 1) < 2) return 1;
  visitLabels(a, b, c, [&](int label, const auto& at) {
    const int known = (at[0] != nullptr) + (at[1] != nullptr) + (at[2] != nullptr);
    if (known != 2) return;
    const int side = !at[2] ? 0 : !at[0] ? 1 : 2;  // across from the corner that lacks the label
    requireAcross(3 * f + side, label);
  });
  return kRoundsPerLabel * static_cast<long>(a.size() + b.size() + c.size());
}

/// The same for one label, newly known at a vertex, in all faces around the vertex.
void LabelClosure::closeAround(int vertex, int label) {
  const auto isKnown = [&](int v) { return lists_.distance(v, label) < kInfinity; };
  const std::span<const int> fan = mesh_.fan(vertex);
  bool isKnownAfter = isKnown(mesh_.tip(fan.front()));
  for (const int h : fan) {
    const int last = TriangleMesh::previous(h);
    const bool isKnownBefore = isKnown(mesh_.tail(last));
    if (isKnownAfter && !isKnownBefore) requireAcross(h, label);
    if (isKnownBefore && !isKnownAfter) requireAcross(last, label);
    isKnownAfter = isKnownBefore;
  }
}

/// Requires a label known at both ends of a halfedge at its apex if the label owns part of the
/// edge. Sides of a slit are left out: paths from the other side lead around its ends, and a label
/// that is nearest at an end is known in the faces there anyway.
void LabelClosure::requireAcross(int h, int label) {
  if (ownsPartOfEdge(label, h) && !isSideOfSlit(mesh_, h))
    owners_.add(TriangleMesh::faceOf(h), label, true, found_);
}

/// Whether a label may be nearest anywhere on an edge by interpolation. Competes only with owners
/// that were not themselves found by interpolation, so that the order of discovery does not matter.
bool LabelClosure::ownsPartOfEdge(int label, int h) const {
  const int tail = mesh_.tail(h), tip = mesh_.tip(h);
  EdgeShare share(label, lists_.leastDistance(tail, label), lists_.leastDistance(tip, label));
  const auto keepsPartBeside = [&](int other) {
    if (other == label) return true;
    const double atTail = lists_.foundDistance(tail, other);
    const double atTip = lists_.foundDistance(tip, other);
    if (atTail < kInfinity && atTip < kInfinity) share.yieldTo(other, atTail, atTip);
    return !share.isEmpty();
  };
  for (const int side : {h, mesh_.twin(h)}) {
    if (side < 0) continue;
    const int face = TriangleMesh::faceOf(side);
    if (owners_.sole(face) >= 0 && !keepsPartBeside(owners_.sole(face))) return false;
    for (const FaceOwners::Owner& owner : owners_.several(face))
      if (!owner.isInterpolated && !keepsPartBeside(owner.label)) return false;
  }
  return true;
}

}  // namespace gvd
