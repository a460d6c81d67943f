// SPDX-License-Identifier: MIT
#include "diagram/dynamic/overlap_faces.h"

namespace gvd {

bool OverlapFaces::update(const IndexSet& labels, long& budget) {
  constexpr long kFacesPerUnit = 16;
  const std::vector<int>& changed = distances_.changedFaces().list();
  return sequence_.runRound(
      [&] { forgetChanged(labels); },
      forItems(changed, budget, kFacesPerUnit, [&](int face) { note(face, labels); }));
}

/// Removes the changed faces from the lists of the changed labels.
void OverlapFaces::forgetChanged(const IndexSet& labels) {
  ofLabel_.resize(distances_.sites().labelCount());
  const IndexSet& changed = distances_.changedFaces();
  for (const int label : labels.list())
    std::erase_if(ofLabel_[label], [&](int f) { return changed.contains(f); });
}

/// Adds a face to the lists of those labels that overlap others at one of its corners.
void OverlapFaces::note(int face, const IndexSet& labels) {
  for (int h = 3 * face; h < 3 * face + 3; ++h) {
    const auto known = distances_.at(mesh_.tail(h));
    if (known.size() < 2) continue;
    for (const LabelledDistance& d : known) {
      if (!labels.contains(d.label)) continue;
      std::vector<int>& faces = ofLabel_[d.label];
      if (faces.empty() || faces.back() != face) faces.push_back(face);
    }
  }
}

std::vector<int> OverlapFaces::of(std::span<const int> labels) {
  faces_.clear();
  for (const int label : labels)
    for (const int f : ofLabel_[label]) faces_.add(f);
  return faces_.sorted();
}

}  // namespace gvd
