// SPDX-License-Identifier: MIT
#include "distance/label_closure.h"

#include <array>
#include <utility>

#include "distance/labelled_distances.h"

namespace gvd {

void LabelClosure::beginChange() {
  sequence_ = {};
  required_.clear();
  found_.clear();
  extended_.clear();
}

bool LabelClosure::step(long& budget) {
  return sequence_.run(
      [&](SlicedLoop& loop) {
        return loop.runWeighted(changedFaces_.size(), budget, kQuickRounds,
                                [&](int i) { return closeFace(changedFaces_.list()[i]); });
      },
      [&] { beginRound(found_); },
      [&] {
        for (;;) {
          if (!turns_.step(budget,
                           [&](int l, const auto& faces) { return listRequired(l, faces); }))
            return false;
          if (required_.empty()) return true;
          beginRound(std::exchange(required_, {}));
        }
      });
}

void LabelClosure::beginRound(std::span<const Requirement> requirements) {
  turns_.clear();
  turns_.addRequired(requirements);
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
        added_.push_back({v, label});
      }
  for (size_t i = 0, count = added_.size(); i < count; ++i) noteAdded(added_[i].vertex, label);
  found_.clear();
  for (const LabelAtVertex& added : added_) closeAround(added);
  std::vector<int> others;
  for (const Requirement& r : found_) {
    if (r.label == label)
      others.push_back(r.face);
    else
      required_.push_back(r);
  }
  return others;
}

/// A new label may lower the distances of labels that tie with it (`equalizeTies`); the closure
/// then has to look at these labels again.
void LabelClosure::noteAdded(int vertex, int label) {
  extended_.add(vertex);
  if (!lists_.hasUnequalTie(vertex, label)) return;
  lists_.equalizeTiesAgain(vertex);
  for (const LabelledDistance& d : lists_[vertex]) added_.push_back({vertex, d.label});
}

// --- What is required ----------------------------------------------------------------------------

/// Returns the number of labels looked at, or 1.
long LabelClosure::closeFace(int f) {
  const std::array<int, 3>& corners = mesh_.face(f).vertices;
  const auto a = lists_[corners[0]], b = lists_[corners[1]], c = lists_[corners[2]];
  if ((a.size() > 1) + (b.size() > 1) + (c.size() > 1) < 2) return 1;
  visitLabels(a, b, c, [&](int label, const auto& at) {
    const int known = (at[0] != nullptr) + (at[1] != nullptr) + (at[2] != nullptr);
    if (known != 2) return;
    const int i = at[2] ? at[1] ? 1 : 2 : 0;
    requireAcross(3 * f + i, {label, at[i]->distance, at[cornerAfter(i)]->distance});
  });
  return static_cast<long>(a.size() + b.size() + c.size());
}

/// The same for one label, newly known at a vertex, in all faces around the vertex.
void LabelClosure::closeAround(const LabelAtVertex& added) {
  const auto& [vertex, label] = added;
  const std::span<const int> fan = mesh_.fan(vertex);
  const double here = lists_.distance(vertex, label);
  double after = lists_.distance(mesh_.tip(fan.front()), label);
  for (const int h : fan) {
    const int last = TriangleMesh::previous(h);
    const double before = lists_.distance(mesh_.tail(last), label);
    if (after < kInfinity && before == kInfinity) requireAcross(h, {label, here, after});
    if (after == kInfinity && before < kInfinity) requireAcross(last, {label, before, here});
    after = before;
  }
}

/// Requires a label known at both ends of a halfedge at its apex if the label owns part of the
/// edge.
void LabelClosure::requireAcross(int h, const EdgeShare& share) {
  if (ownsPartOfEdge(share, h)) owners_.add(TriangleMesh::faceOf(h), share.label(), true, found_);
}

/// Whether a label is nearest anywhere on an edge by interpolation. Competes only with owners that
/// were not themselves found by interpolation, so that the order of discovery does not matter.
bool LabelClosure::ownsPartOfEdge(EdgeShare share, int h) const {
  const int tail = mesh_.tail(h), tip = mesh_.tip(h);
  const auto keepsPartBeside = [&](int other) {
    if (other == share.label()) return true;
    const double atTail = lists_.distance(tail, other), atTip = lists_.distance(tip, other);
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
