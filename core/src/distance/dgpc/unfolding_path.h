// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::dgpc {

/// A path from a point back to the site of a label, by the label's distances at vertices, which are
/// infinite where it is not known. At each point, virtual sources are unfolded behind the
/// surrounding sides as in the sweep. The path takes one step towards the nearest of them, or along
/// an edge to a vertex if that is shorter, and repeats. The estimated distance must fall with every
/// step; otherwise the path keeps to its previous straight line, and if that leads nowhere, goes on
/// over a nearer vertex beside its last one. The distances of successive vertices fall, so the path
/// never loops. Empty if the distances contradict each other so much that they lead nowhere.
std::vector<SurfacePoint> pathByUnfolding(const TriangleMesh& mesh, const SurfacePoint& site,
                                          const std::function<double(int vertex)>& distanceAt,
                                          const SurfacePoint& p);

}  // namespace gvd::dgpc
