// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "exact/exact_frame.h"
#include "exact/exact_vertices.h"
#include "exact/exact_window.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The direction in which the path that an entry stands for leaves its site, as a unit vector in
/// the frame that `DistanceField::direction` describes; (1, 0) at the site itself. The path is
/// followed back from window to window and from vertex to vertex. O(number of faces on its way).
Eigen::Vector2d departure(const TriangleMesh& mesh, const SurfacePoint& site,
                          std::span<const Frame> frames, const WindowPool& windows,
                          const VertexTable& table, int entry);

}  // namespace gvd::exact
