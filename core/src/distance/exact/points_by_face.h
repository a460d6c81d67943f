// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

#include "base/sorting.h"
#include "gvd/surface_point.h"

namespace gvd::exact {

/// The points other than vertices at which the distance of a label is required.
class PointsByFace {
 public:
  struct InFace {
    int face;
    Eigen::Vector3d bary;
    int index;  ///< in `RequiredDistances`
  };

  void clear() { inFaces_.clear(); }
  /// Adds a point; one on an edge is added in the faces on both sides.
  void add(const SurfacePoint& p, int index) { inFaces_.push_back({p.face, p.bary, index}); }
  /// To be called when all have been added.
  void sort() {
    sortStably(std::span(inFaces_), [](const InFace& a, const InFace& b) {
      return std::tie(a.face, a.index) < std::tie(b.face, b.index);
    });
  }

  bool isEmpty() const { return inFaces_.empty(); }
  /// The points in a face.
  std::span<const InFace> in(int face) const {
    const auto [first, last] =
        std::equal_range(inFaces_.begin(), inFaces_.end(), InFace{face, {}, 0},
                         [](const InFace& a, const InFace& b) { return a.face < b.face; });
    return std::span(inFaces_).subspan(first - inFaces_.begin(), last - first);
  }

 private:
  std::vector<InFace> inFaces_;  ///< by face
};

}  // namespace gvd::exact
