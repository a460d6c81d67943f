// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "accuracy.h"
#include "gvd/surface_point.h"

namespace gvd::bench {

/// Exact distances by other programs. Points refer to the triangles of the file.
struct TruthCase {
  std::string name;
  std::filesystem::path mesh;  ///< a GLB
  std::vector<SurfacePoint> sites;
  std::vector<SurfacePoint> points;
  std::vector<TrueNearest> nearest;  ///< of every point
};

/// Reads what truth_cases.mjs writes: a line with the name, one with the mesh, then numbers.
///
///     sites points
///     face bary bary bary                         per site
///     face bary bary bary label distance second   per point; negative: none, or not known
TruthCase readTruthCase(const std::filesystem::path& path);

}  // namespace gvd::bench
