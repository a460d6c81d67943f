// SPDX-License-Identifier: MIT
#include "distance/label_closure.h"

#include "distance/common_labels.h"
#include "distance/edge_share.h"
#include "distance/face_layout.h"

namespace gvd {

void LabelClosure::closeFace(int f, std::vector<Requirement>& required) {
  const int* const corners = &mesh_.tails()[3 * static_cast<size_t>(f)];
  const auto a = lists_[corners[0]], b = lists_[corners[1]], c = lists_[corners[2]];
  if ((a.size() > 1) + (b.size() > 1) + (c.size() > 1) < 2) return;
  anyLabel(a, b, c, [&](int label, const auto& at) {
    const int known = (at[0] != nullptr) + (at[1] != nullptr) + (at[2] != nullptr);
    if (known == 2) requireAcross(3 * f + (at[2] ? at[1] ? 1 : 2 : 0), label, required);
    return false;
  });
}

void LabelClosure::closeAround(int vertex, int label, std::vector<Requirement>& required) {
  mesh_.visitFaces(vertex, [&](int f) {
    const auto& corners = mesh_.face(f).vertices;
    const int i = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    const bool isAfter = lists_.distance(corners[cornerAfter(i)], label) < kInfinity;
    const bool isBefore = lists_.distance(corners[cornerBefore(i)], label) < kInfinity;
    if (isAfter != isBefore)
      requireAcross(3 * f + (isAfter ? i : cornerBefore(i)), label, required);
  });
}

/// Requires a label known at both ends of a halfedge at its apex if the label owns part of the
/// edge.
void LabelClosure::requireAcross(int h, int label, std::vector<Requirement>& required) {
  if (ownsPartOfEdge(label, h)) owners_.add(TriangleMesh::faceOf(h), label, true, required);
}

/// Whether a label is nearest anywhere on an edge by interpolation. Competes only with owners that
/// were not themselves found by interpolation, so that the order of discovery does not matter.
bool LabelClosure::ownsPartOfEdge(int label, int h) const {
  const int tail = mesh_.tail(h), tip = mesh_.tip(h);
  EdgeShare share(label, lists_.distance(tail, label), lists_.distance(tip, label));
  const auto keepsPartBeside = [&](int other) {
    if (other == label) return true;
    const double atTail = lists_.distance(tail, other), atTip = lists_.distance(tip, other);
    if (atTail < kInfinity && atTip < kInfinity) share.yieldTo(other, atTail, atTip);
    return !share.isEmpty();
  };
  // The owners of the ends come first: for most labels, one of them is nearer at both ends.
  if (!keepsPartBeside(bounds_[tail].label) || !keepsPartBeside(bounds_[tip].label)) return false;
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
