// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/index_map.h"
#include "distance/exact/label_state.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The shortest path from a point to the site of a label that has reached it, by the label's state.
/// For a point that is no vertex, the windows of its faces must be among the waiting ones. `index`
/// is working memory.
std::vector<SurfacePoint> pathToSite(const TriangleMesh& mesh, const SurfacePoint& site,
                                     const LabelState& state, const SurfacePoint& p,
                                     IndexMap& index);

}  // namespace gvd::exact
