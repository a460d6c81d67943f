// SPDX-License-Identifier: MIT
//
// The amount of surface near every place of the scene, by which `occlusion.ts` darkens hollows.

import { vectorLength } from './vector_length.js';

/** Cells of the grid along each axis; it holds the unit sphere and a margin. */
export const resolution = 64;
export const halfWidth = 1.15;
const cell = (2 * halfWidth) / resolution;

/**
 * The grid is blurred to two standard deviations, in cells: three box filters of radius 1, then
 * three of radius 3. The variance of one is ((2r + 1)² - 1) / 12.
 */
const boxRadii = [1, 3] as const;
export const deviations = [Math.sqrt(2) * cell, Math.sqrt(14) * cell] as const;
/** The distance off the surface at which the grid is read, in standard deviations. */
export const lift = 1.5;
/** The byte for the density that is read near a plane; other densities are in proportion. */
export const byteOfPlane = 48;

/** The triangles of a model, within the unit sphere. */
interface Triangles {
  readonly positions: Float32Array;
  readonly indices: Int32Array;
}

/**
 * The area of the surface near every cell of a grid, blurred narrowly and widely: two bytes per
 * cell. Just off a plane each is `byteOfPlane`; more surface than that hides light.
 */
export function surfaceDensity(mesh: Triangles): Uint8Array {
  const density = new Uint8Array(2 * resolution ** 3);
  const area = areaPerCell(mesh);
  const scratch = new Float32Array(area.length);
  boxRadii.forEach((radius, channel) => {
    for (let round = 0; round < 3; ++round) {
      for (const stride of [1, resolution, resolution ** 2])
        boxFilter(area, scratch, radius, stride);
    }
    const ofPlane = Math.exp((-lift * lift) / 2) / (deviations[channel] * Math.sqrt(2 * Math.PI));
    const scale = byteOfPlane / (ofPlane * cell ** 3);
    for (let i = 0; i < area.length; ++i) density[2 * i + channel] = Math.min(255, scale * area[i]);
  });
  return density;
}

/** Samples each triangle at points that are dense enough for about every cell it passes. */
function areaPerCell({ positions, indices }: Triangles): Float32Array {
  const grid = new Float32Array(resolution ** 3);
  const [a, b, c] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)];
  for (let i = 0; i + 2 < indices.length; i += 3) {
    [a, b, c].forEach((corner, k) => {
      for (let axis = 0; axis < 3; ++axis) corner[axis] = positions[3 * indices[i + k] + axis];
    });
    const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const area = vectorLength(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
    if (!(area > 0)) continue;
    const longest = Math.max(vectorLength(ux, uy, uz), vectorLength(vx, vy, vz));
    const n = Math.ceil(longest / cell);
    const share = area / (n * n);
    for (let row = 0; row < n; ++row) {
      for (let column = 0; column < 2 * row + 1; ++column) {
        // The centres of n² triangles of equal size.
        const upright = column % 2 === 0;
        const s = (row + (upright ? 2 / 3 : 1 / 3)) / n;
        const t = (Math.floor(column / 2) + (upright ? 1 / 3 : 2 / 3)) / n;
        const [v, w] = [s - t, t];
        splat(grid, share, a[0] + v * ux + w * vx, a[1] + v * uy + w * vy, a[2] + v * uz + w * vz);
      }
    }
  }
  return grid;
}

/** Shares an amount among the eight cells around a point. */
function splat(grid: Float32Array, amount: number, x: number, y: number, z: number): void {
  const [gx, gy, gz] = [placeInGrid(x), placeInGrid(y), placeInGrid(z)];
  const [i, j, k] = [Math.floor(gx), Math.floor(gy), Math.floor(gz)];
  for (let corner = 0; corner < 8; ++corner) {
    const [di, dj, dk] = [corner & 1, (corner >> 1) & 1, corner >> 2];
    const weight =
      (di ? gx - i : 1 - gx + i) * (dj ? gy - j : 1 - gy + j) * (dk ? gz - k : 1 - gz + k);
    grid[i + di + resolution * (j + dj + resolution * (k + dk))] += weight * amount;
  }
}

/** In cells, from the centre of the first one. */
function placeInGrid(coordinate: number): number {
  return (coordinate + halfWidth) / cell - 0.5;
}

/**
 * Replaces each cell by the mean of those within a radius along one axis; beyond the grid is
 * nothing.
 */
function boxFilter(
  grid: Float32Array,
  scratch: Float32Array,
  radius: number,
  stride: number,
): void {
  scratch.set(grid);
  const span = stride * resolution;
  const weight = 1 / (2 * radius + 1);
  for (let block = 0; block < grid.length; block += span) {
    for (let start = block; start < block + stride; ++start) {
      let sum = 0;
      for (let n = 0; n < radius; ++n) sum += scratch[start + n * stride];
      for (let n = 0; n < resolution; ++n) {
        if (n + radius < resolution) sum += scratch[start + (n + radius) * stride];
        if (n > radius) sum -= scratch[start + (n - radius - 1) * stride];
        grid[start + n * stride] = weight * sum;
      }
    }
  }
}
