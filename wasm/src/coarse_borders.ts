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
  const squared = (from: number, to: number) => {
    const x = positions[3 * to] - positions[3 * from];
    const y = positions[3 * to + 1] - positions[3 * from + 1];
    const z = positions[3 * to + 2] - positions[3 * from + 2];
    return x * x + y * y + z * z;
  };
  let area = 0;
  let weighted = 0;
  for (let face = 0; face < faceLabel.length; ++face) {
    if (faceLabel[face] !== -2) continue;
    const [a, b, c] = indices.subarray(3 * face, 3 * face + 3);
    const [ab, bc, ca] = [squared(a, b), squared(b, c), squared(c, a)];
    const ofFace = Math.sqrt(Math.max(0, 4 * ab * bc - (ab + bc - ca) ** 2)) / 4; // Heron
    area += ofFace;
    weighted += ofFace * Math.max(ab, bc, ca);
  }
  const regions = regionArea.filter((ofRegion) => ofRegion > 0);
  const meanRegion = regions.reduce((sum, ofRegion) => sum + ofRegion, 0) / regions.length;
  return weighted > mostSquaredLength * meanRegion * area;
}
