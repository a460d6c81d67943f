// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gvd/geodesic.h"
#include "mesh/place_map.h"

namespace gvd {

/// The distances of labels at points as they were found first. A label that has gone on since may
/// find the same path by other windows, and round its length differently; but where a live diagram
/// is traced again in part, that part must fit the rest to the last bit.
class PointDistances {
 public:
  /// Infinity if it has not been found yet.
  double find(const LabelledPoint& p) const {
    if (p.label >= static_cast<int>(ofLabel_.size())) return kInfinity;
    const auto found = ofLabel_[p.label].find(p.point);
    return found == ofLabel_[p.label].end() ? kInfinity : found->second;
  }
  void add(const LabelledPoint& p, double distance) {
    if (p.label >= static_cast<int>(ofLabel_.size())) ofLabel_.resize(p.label + 1);
    ofLabel_[p.label].emplace(p.point, distance);
  }
  /// Forgets all of a label.
  void remove(int label) {
    if (label < static_cast<int>(ofLabel_.size())) ofLabel_[label].clear();
  }

 private:
  std::vector<PlaceMap<double>> ofLabel_;
};

}  // namespace gvd
