// SPDX-License-Identifier: MIT
//
// Diagrams given by callers, and the sites given with them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/rejection.h"
#include "gvd/diagram.h"
#include "gvd/triangle_mesh.h"
#include "mesh/given_points.h"

namespace gvd {

/// Throws `Error(kInvalidArgument)` if a diagram given by a caller cannot be one of the mesh,
/// because it has another number of faces.
inline void requireFaces(const TriangleMesh& mesh, const Diagram& diagram) {
  if (static_cast<int>(diagram.faceLabel.size()) != mesh.faceCount())
    rejectArgument("the diagram is that of another mesh");
}

/// The sites of a diagram, with clean coordinates. Throws `Error(kInvalidArgument)` unless there is
/// an entry per label, with a site if the label has a region, and `Error(kInvalidPoint)` if a site
/// is not on the mesh.
inline std::vector<SurfacePoint> sitesOf(const TriangleMesh& mesh, const Diagram& diagram,
                                         std::span<const SurfacePoint> sites) {
  if (static_cast<int>(sites.size()) != diagram.siteCount)
    rejectArgument("the number of sites is " + std::to_string(sites.size()) +
                   ", not that of the diagram, " + std::to_string(diagram.siteCount));
  for (int label = 0; label < diagram.siteCount; ++label)
    if (sites[label].face < 0 && diagram.regionArea[label] > 0)
      rejectArgument("label " + std::to_string(label) + " has a region, but no site");
  std::vector<SurfacePoint> clean(sites.begin(), sites.end());
  for (std::size_t label = 0; label < clean.size(); ++label)
    if (clean[label].face != -1) clean[label] = onMesh(mesh, clean[label], "site", label);
  return clean;
}

}  // namespace gvd
