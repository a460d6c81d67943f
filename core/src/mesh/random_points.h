// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if a number of points to be drawn is negative.
inline void requireCount(int count) {
  if (count < 0) rejectArgument("there cannot be " + std::to_string(count) + " sample points");
}

/// Lengthens a list to the cumulative sums of the areas of all faces, in slices; true when it is
/// that long.
inline bool sumAreas(const TriangleMesh& mesh, std::vector<double>& sums, long& budget) {
  const std::size_t count = mesh.faceCount();
  sums.reserve(count);
  const std::size_t end = endOfSlice(sums.size(), count, budget, kQuickRounds);
  while (sums.size() < end)
    sums.push_back((sums.empty() ? 0 : sums.back()) + mesh.faceArea(static_cast<int>(sums.size())));
  return end == count;
}

/// A point in a face drawn by the cumulative sums of values per face, uniform within the face.
inline SurfacePoint drawPoint(std::mt19937_64& random, const std::vector<double>& sums) {
  SurfacePoint p;
  p.face = drawIndex(random, sums);
  p.bary = drawBarycentric(random);
  return p;
}

}  // namespace gvd
