// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "base/hashing.h"
#include "gvd/surface_point.h"

namespace gvd {

struct PlaceHash {
  std::size_t operator()(const SurfacePoint& p) const {
    const auto face = static_cast<std::uint64_t>(p.face);
    return static_cast<std::size_t>(hashOf(p.bary[1], hashOf(p.bary[0], face)));
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
