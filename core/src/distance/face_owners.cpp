// SPDX-License-Identifier: MIT
#include "distance/face_owners.h"

#include <algorithm>
#include <array>

namespace gvd {

bool FaceOwners::has(int face, int label) const {
  if (sole_[face] != kSeveral) return sole_[face] == label;
  const auto owners = several_[face];
  return std::any_of(owners.begin(), owners.end(),
                     [&](const Owner& owner) { return owner.label == label; });
}

void FaceOwners::reset(int face, std::vector<Requirement>& required) {
  several_.clear(face);
  const std::array<int, 3>& corners = mesh_.face(face).vertices;
  sole_[face] = bounds_[corners[0]].label;
  for (const int v : {corners[1], corners[2]})
    if (bounds_[v].label >= 0) add(face, bounds_[v].label, false, required);
  for (const FaceSite& site : sites_.inFace(face)) add(face, site.label, false, required);
}

void FaceOwners::add(int face, int label, bool isInterpolated, std::vector<Requirement>& required) {
  if (has(face, label)) return;
  if (sole_[face] != kSeveral) {
    if (sole_[face] >= 0) {
      several_.add(face, {sole_[face], false});
      required.push_back({sole_[face], face});
    }
    sole_[face] = kSeveral;
  }
  several_.add(face, {label, isInterpolated});
  required.push_back({label, face});
}

bool FaceOwners::removeInterpolated(int face, int label) {
  const size_t before = several_[face].size();
  several_.eraseIf(
      face, [&](const Owner& owner) { return owner.isInterpolated && owner.label == label; });
  const auto owners = several_[face];
  if (owners.size() == before) return false;
  if (owners.size() == 1) {
    sole_[face] = owners[0].label;
    several_.clear(face);
  }
  return true;
}

}  // namespace gvd
