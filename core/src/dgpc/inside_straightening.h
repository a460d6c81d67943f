// SPDX-License-Identifier: MIT
#pragma once

#include "dgpc/dgpc_field.h"

namespace gvd {

/// Makes the distances inside of regions those of geodesics, where views bend, as they are where
/// regions meet. A diagram does not need that; an integral over regions would jump where sites
/// move. Distances of vertices that know of several labels stay as they are.
///
/// Where two neighbours see a site along straight lines, so does a vertex beyond the edge between
/// them, but for the curvature of what the three lines enclose. That is the angle by which the
/// neighbours' directions at the site differ from those in the unfolded triangle: as long as it
/// changes little, the vertex's distance follows from the neighbours'. Else its path is
/// straightened. Errors then are 3e-4 of a distance on average, where views err by 2e-3 and
/// geodesics by 1e-4.
///
/// O(vertices log vertices), and for a path that is straightened O(faces on the way).
void straightenInsides(DgpcField& field);

}  // namespace gvd
