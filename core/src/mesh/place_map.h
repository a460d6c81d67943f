// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "gvd/surface_point.h"

namespace gvd {

struct PlaceHash {
  std::size_t operator()(const SurfacePoint& p) const {
    auto hash = static_cast<std::uint64_t>(p.face);
    for (int i = 0; i < 2; ++i) {
      const double unsignedZero = p.bary[i] + 0.0;
      hash = (hash ^ Eigen::numext::bit_cast<std::uint64_t>(unsignedZero)) * 0x9e3779b97f4a7c15u;
    }
    return static_cast<std::size_t>(hash ^ hash >> 32);
  }
};

struct SamePlace {
  bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
    return a.face == b.face && a.bary == b.bary;
  }
};

/// A map from surface points to values. Points are equal if their faces and coordinates are: a
/// point on an edge is a different key in the other face.
template <class Value>
using PlaceMap = std::unordered_map<SurfacePoint, Value, PlaceHash, SamePlace>;

}  // namespace gvd
