// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"

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
  struct Hash {
    size_t operator()(const SurfacePoint& p) const {
      auto hash = static_cast<std::uint64_t>(p.face);
      for (int i = 0; i < 2; ++i)
        hash = (hash ^ Eigen::numext::bit_cast<std::uint64_t>(p.bary[i])) * 0x9e3779b97f4a7c15u;
      return static_cast<size_t>(hash ^ hash >> 32);
    }
  };
  struct Equal {
    bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
      return a.face == b.face && a.bary == b.bary;
    }
  };

  std::vector<std::unordered_map<SurfacePoint, double, Hash, Equal>> ofLabel_;
};

}  // namespace gvd
