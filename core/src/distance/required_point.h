// SPDX-License-Identifier: MIT
#pragma once

#include "gvd/surface_point.h"

namespace gvd {

/// A point, no vertex, at which the distance of a label is required.
struct RequiredPoint {
  SurfacePoint point;
  double distance;  ///< of the label, as far as it is known
  double nearest;   ///< that of the nearest label
};

}  // namespace gvd
