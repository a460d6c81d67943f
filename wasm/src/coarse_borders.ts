// SPDX-License-Identifier: MIT
//
// Whether triangles are too long for borders that are straight within each.

import { toResult } from './checks.js';
import type { DiagramData } from './results.js';
import type { Mesh } from './types.js';

/**
 * The squared length of the triangles that borders cross, on average over their area, as a share of a mean
 * region's area: if it is larger, borders are coarse. Equal triangles reach it with four per region, the long
 * thin ones of mechanical parts with hundreds.
 */
const mostSquaredLength = 0.6;

/**
 * Whether the borders of a diagram without `detail`, straight within each triangle, are coarse: the triangles
 * that they cross are about as long as regions. Several per cent of the area may then go to the wrong region.
 * O(triangles).
 */
export function hasCoarseBorders(
  mesh: Pick<Mesh, 'positions' | 'indices'>,
  data: DiagramData,
): boolean {
  const { positions, indices } = toResult('mesh', mesh);
  const { faceLabel, regionArea } = toResult('data', data);
  const side = (from: number, to: number) =>
    [0, 1, 2].map((axis) => positions[3 * to + axis] - positions[3 * from + axis]);
  let area = 0;
  let weighted = 0;
  faceLabel.forEach((label, face) => {
    if (label !== -2) return;
    const [a, b, c] = indices.subarray(3 * face, 3 * face + 3);
    const sides = [side(a, b), side(b, c), side(c, a)];
    const [[x, y, z], [u, v, w]] = sides;
    const ofFace = Math.hypot(y * w - z * v, z * u - x * w, x * v - y * u) / 2;
    area += ofFace;
    weighted += ofFace * Math.max(...sides.map((s) => Math.hypot(...s))) ** 2;
  });
  const regions = regionArea.filter((ofRegion) => ofRegion > 0);
  const meanRegion = regions.reduce((sum, ofRegion) => sum + ofRegion, 0) / regions.length;
  return weighted > mostSquaredLength * meanRegion * area;
}
