// SPDX-License-Identifier: MIT
//
// The reference for the energy of a tessellation: regular hexagons in the plane.

import type { DiagramData, Mesh } from 'geodesic-voronoi';

/**
 * Σ ∫ ρ d² for as many regular hexagons in the plane as there are sites: 5/(18√3) · (∫ √ρ)²/k. Without
 * `rootIntegral`, which is ∫ √ρ, ρ is 1.
 * Exact for uniform density, otherwise the limit for many sites (Gersho 1979).
 */
export function hexagonEnergy(
  { siteCount, regionArea }: Pick<DiagramData, 'siteCount' | 'regionArea'>,
  rootIntegral: number = regionArea.reduce((sum, area) => sum + area, 0),
): number {
  return (5 / (18 * Math.sqrt(3))) * (rootIntegral ** 2 / siteCount);
}

/** ∫ √ρ over a mesh, taking √ρ to be linear on a face. */
export function rootDensityIntegral(
  { positions, indices }: Pick<Mesh, 'positions' | 'indices'>,
  density: ArrayLike<number>,
): number {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    const root = (Math.sqrt(density[a]) + Math.sqrt(density[b]) + Math.sqrt(density[c])) / 3;
    const area = triangleArea(positions, a, b, c);
    if (area > 0) sum += area * root; // not where corners are no numbers
  }
  return sum;
}

function triangleArea(positions: Float64Array, a: number, b: number, c: number): number {
  const side = (v: number, axis: number) => positions[3 * v + axis] - positions[3 * a + axis];
  const [ux, uy, uz] = [side(b, 0), side(b, 1), side(b, 2)];
  const [vx, vy, vz] = [side(c, 0), side(c, 1), side(c, 2)];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}
