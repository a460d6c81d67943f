// SPDX-License-Identifier: MIT
//
// Whether triangles are too long for the regions of a diagram, and how short they should be.

import { toRange } from './arguments.js';
import { toOptions, toResult } from './checks.js';
import type { DiagramData } from './results.js';
import type { Mesh } from './types.js';

/** The longest edge that is asked for, as a share of the length that triangles may have. */
const finer = 0.45;

export interface FinerMaxEdgeOptions {
  /**
   * The length that the triangles crossed by borders may have, on average over their area, as a share of the
   * side of a square as large as a mean region. Default 0.77: equal triangles have it with four per region,
   * the long thin ones of mechanical parts with hundreds. For energies and centroids of tessellations, 0.4 is
   * right: 16 equal triangles per region.
   */
  length?: number | undefined;
}

/**
 * The `maxEdge` by which the triangles of a mesh become short enough for a diagram; 0 if they are. Borders are
 * straight within each triangle, and a region is known by the corners that it owns: where triangles are about
 * as long as regions, several per cent of the area may be in the wrong region, whatever the `detail`.
 * O(triangles).
 */
export function finerMaxEdge(
  mesh: Pick<Mesh, 'positions' | 'indices' | 'info'>,
  data: DiagramData,
  options?: FinerMaxEdgeOptions,
): number {
  const { positions, indices, info } = toResult('mesh', mesh);
  const { faceLabel, regionArea } = toResult('data', data);
  const { length } = toOptions(options, { length: 0.77 });
  const most = toRange('length', length, 'radius');
  const squared = (from: number, to: number) => {
    const x = positions[3 * to] - positions[3 * from];
    const y = positions[3 * to + 1] - positions[3 * from + 1];
    const z = positions[3 * to + 2] - positions[3 * from + 2];
    return x * x + y * y + z * z;
  };
  /** The mean squared length of some faces, by area. */
  const meanSquared = (isCounted: (label: number) => boolean) => {
    let area = 0;
    let weighted = 0;
    for (let face = 0; face < faceLabel.length; ++face) {
      if (!isCounted(faceLabel[face])) continue;
      const [a, b, c] = indices.subarray(3 * face, 3 * face + 3);
      const [ab, bc, ca] = [squared(a, b), squared(b, c), squared(c, a)];
      const ofFace = Math.sqrt(Math.max(0, 4 * ab * bc - (ab + bc - ca) ** 2)) / 4; // Heron
      area += ofFace;
      weighted += ofFace * Math.max(ab, bc, ca);
    }
    return weighted / area;
  };
  const mixed = -2;
  const hasBorders = faceLabel.includes(mixed);
  const mean = meanSquared((label) => (hasBorders ? label === mixed : label >= 0));
  const regions = regionArea.filter((ofRegion) => ofRegion > 0);
  const meanRegion = regions.reduce((sum, ofRegion) => sum + ofRegion, 0) / regions.length;
  const wanted = most * Math.sqrt(meanRegion);
  if (!(mean > wanted ** 2)) return 0;
  return Number(((finer * wanted) / info.boundingDiagonal).toPrecision(1));
}
