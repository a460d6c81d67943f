// SPDX-License-Identifier: MIT
//
// A model's mesh as the scene has it, and places and normals on it.

import { ModelFrame } from './model_frame.js';
import type { SceneArrays } from './scene_arrays.js';

/** A model's triangles as the scene has them; faces keep the numbers of the input. */
export class SceneMesh {
  readonly frame: ModelFrame;
  readonly positions: Float32Array;
  readonly indices: Int32Array;
  readonly normals: Float32Array;
  readonly cornerPositions: Float32Array;
  readonly surfaceDensity: Uint8Array;

  constructor(arrays: SceneArrays) {
    this.frame = new ModelFrame(arrays.centre, arrays.scale);
    this.positions = arrays.positions;
    this.indices = arrays.indices;
    this.normals = arrays.normals;
    this.cornerPositions = arrays.cornerPositions;
    this.surfaceDensity = arrays.surfaceDensity;
  }

  get faceCount(): number {
    return this.indices.length / 3;
  }

  /** Six times the volume that the triangles enclose: negative if their normals point inwards. */
  get sixfoldVolume(): number {
    const { positions: p, indices } = this;
    let sum = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
      sum +=
        p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
        p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
        p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    return sum;
  }

  /** The place of a point of a face, written to `target[at…]`. */
  writePoint(face: number, bary: ArrayLike<number>, target: Float32Array, at: number): void {
    for (let axis = 0; axis < 3; ++axis) {
      let sum = 0;
      for (let k = 0; k < 3; ++k) {
        sum += bary[k] * this.positions[3 * this.indices[3 * face + k] + axis];
      }
      target[at + axis] = sum;
    }
  }

  /** The value at a point of a face of a function given at the vertices. */
  interpolate(face: number, bary: ArrayLike<number>, values: ArrayLike<number>): number {
    const { indices } = this;
    return (
      bary[0] * values[indices[3 * face]] +
      bary[1] * values[indices[3 * face + 1]] +
      bary[2] * values[indices[3 * face + 2]]
    );
  }

  /** The shading normal of a face at a point of it, not normalised, written to `target[at…]`. */
  writeNormal(face: number, bary: ArrayLike<number>, target: Float32Array, at: number): void {
    const { normals } = this;
    const [b0, b1, b2] = [bary[0], bary[1], bary[2]];
    const corner = 9 * face;
    for (let axis = 0; axis < 3; ++axis) {
      target[at + axis] =
        b0 * normals[corner + axis] +
        b1 * normals[corner + 3 + axis] +
        b2 * normals[corner + 6 + axis];
    }
  }

  /**
   * Barycentric coordinates, clamped to the face, of the point of its plane nearest to (x, y, z).
   */
  barycentric(face: number, x: number, y: number, z: number): [number, number, number] {
    const bary: [number, number, number] = [1, 0, 0];
    this.writeBarycentric(face, x, y, z, bary);
    return bary;
  }

  /** Like `barycentric`, but writes to `target`: called for every corner, it must not allocate. */
  writeBarycentric(
    face: number,
    x: number,
    y: number,
    z: number,
    target: { [i: number]: number },
  ): void {
    const { positions, indices } = this;
    const a = 3 * indices[3 * face];
    const b = 3 * indices[3 * face + 1];
    const c = 3 * indices[3 * face + 2];
    const [ax, ay, az] = [positions[a], positions[a + 1], positions[a + 2]];
    const [ux, uy, uz] = [positions[b] - ax, positions[b + 1] - ay, positions[b + 2] - az];
    const [vx, vy, vz] = [positions[c] - ax, positions[c + 1] - ay, positions[c + 2] - az];
    const [px, py, pz] = [x - ax, y - ay, z - az];
    const uu = ux * ux + uy * uy + uz * uz;
    const uv = ux * vx + uy * vy + uz * vz;
    const vv = vx * vx + vy * vy + vz * vz;
    const pu = px * ux + py * uy + pz * uz;
    const pv = px * vx + py * vy + pz * vz;
    const determinant = uu * vv - uv * uv;
    const isFlat = !(determinant > 0);
    const second = isFlat ? 0 : Math.max(0, (vv * pu - uv * pv) / determinant);
    const third = isFlat ? 0 : Math.max(0, (uu * pv - uv * pu) / determinant);
    const excess = Math.max(1, second + third);
    target[0] = Math.max(0, 1 - (second + third) / excess);
    target[1] = second / excess;
    target[2] = third / excess;
  }
}
