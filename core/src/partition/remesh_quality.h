// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "gvd/remesh.h"

namespace gvd {

/// The quality of a remesh but for its distance from the surface. The remesh must outlive the work.
std::unique_ptr<SlicedWork<RemeshQuality>> startTriangleQuality(const PolygonMesh& remesh);

}  // namespace gvd
