// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "base/random.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

inline std::vector<double> faceAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) areas[f] = mesh.faceArea(f);
  return areas;
}

/// A point in a face drawn by the cumulative sums of values per face, uniform within the face.
inline SurfacePoint drawPoint(std::mt19937_64& random, const std::vector<double>& sums) {
  SurfacePoint p;
  p.face = drawIndex(random, sums);
  p.bary = drawBarycentric(random);
  return p;
}

}  // namespace gvd
