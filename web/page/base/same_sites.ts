// SPDX-License-Identifier: MIT
//
// Whether sites have changed. Their diagram does not tell: edits change it in place.

import type { SurfacePoints } from 'geodesic-voronoi';

export function isSame(a: SurfacePoints, b: SurfacePoints): boolean {
  return String(a.face) === String(b.face) && String(a.bary) === String(b.bary);
}
