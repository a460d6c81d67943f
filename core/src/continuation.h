// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "dgpc_view.h"
#include "gvd/geodesic.h"

namespace gvd {

/// Adds to the nearest site of each vertex those other sites that a diagram needs to know there.
///
/// To tell where in a face one region ends, the distances of both labels must be known at all its
/// corners, also those that another label owns. What counts there is the continuation of the
/// distance inside the region: how far the site is, as seen from the corners the region has. So it
/// depends on no path outside of the region, and nothing need have spread there.
///
/// `nearest` and `views` are those of the vertices; label -1 where no site has come.
std::unique_ptr<DistanceField> continueOverBorders(const TriangleMesh& mesh,
                                                   std::vector<SurfacePoint> sites,
                                                   std::vector<LabelledDistance> nearest,
                                                   std::vector<View> views);

}  // namespace gvd
