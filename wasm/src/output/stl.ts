// SPDX-License-Identifier: MIT
//
// Writing binary STL: triangles, each with its corners in 32-bit floats, and nothing else.

import { stlBytes } from '../input/stl_layout.js';
import { toFloat32 } from './file_options.js';

/** `corners` are three indices into the x, y, z triples of `positions` for each triangle. */
export function stl(
  comment: string,
  positions: ArrayLike<number>,
  corners: ArrayLike<number>,
  scale: number,
): Uint8Array<ArrayBuffer> {
  const count = corners.length / 3;
  const bytes = new Uint8Array(stlBytes(count));
  bytes.set(new TextEncoder().encode(comment));
  const view = new DataView(bytes.buffer);
  const places = new Float64Array(9);
  for (let t = 0; t < count; ++t) {
    for (let i = 0; i < 9; ++i)
      places[i] = scale * positions[3 * corners[3 * t + Math.floor(i / 3)] + (i % 3)];
    const at = stlBytes(t);
    normalOf(places).forEach((x, k) => view.setFloat32(at + 4 * k, x, true));
    places.forEach((x, i) => view.setFloat32(at + 12 + 4 * i, toFloat32(x, scale, 'an STL'), true));
  }
  view.setUint32(stlBytes(0) - 4, count, true);
  return bytes;
}

/** The unit normal of a triangle; zero if it has no area. */
function normalOf([px, py, pz, qx, qy, qz, rx, ry, rz]: Float64Array): number[] {
  const [ux, uy, uz] = [qx - px, qy - py, qz - pz];
  const [vx, vy, vz] = [rx - px, ry - py, rz - pz];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal) || 1;
  return normal.map((x) => x / length);
}
