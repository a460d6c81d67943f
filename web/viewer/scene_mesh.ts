// SPDX-License-Identifier: MIT
import type { Mesh } from 'geodesic-voronoi';
import { cornerNormals } from './corner_normals.js';
import { ModelFrame } from './model_frame.js';

/** A model's triangles as the scene has them; faces keep the numbers of the input. */
export class SceneMesh {
  readonly frame: ModelFrame;
  /** Per input vertex. */
  readonly positions: Float32Array;
  readonly indices: Int32Array;
  /** Per corner of every face. */
  readonly normals: Float32Array;

  constructor({ positions, indices }: Pick<Mesh, 'positions' | 'indices'>) {
    this.frame = ModelFrame.around(positions, indices);
    this.positions = this.frame.toScene(positions);
    this.indices = indices;
    this.normals = cornerNormals(this.positions, indices);
  }

  get faceCount(): number {
    return this.indices.length / 3;
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
    for (let axis = 0; axis < 3; ++axis) {
      let sum = 0;
      for (let k = 0; k < 3; ++k) sum += bary[k] * this.normals[9 * face + 3 * k + axis];
      target[at + axis] = sum;
    }
  }

  /** Barycentric coordinates, clamped to the face, of the point of its plane nearest to (x, y, z). */
  barycentric(face: number, x: number, y: number, z: number): [number, number, number] {
    const { positions, indices } = this;
    const a = 3 * indices[3 * face];
    const b = 3 * indices[3 * face + 1];
    const c = 3 * indices[3 * face + 2];
    const point = [x, y, z];
    let uu = 0;
    let uv = 0;
    let vv = 0;
    let pu = 0;
    let pv = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const u = positions[b + axis] - positions[a + axis];
      const v = positions[c + axis] - positions[a + axis];
      const p = point[axis] - positions[a + axis];
      uu += u * u;
      uv += u * v;
      vv += v * v;
      pu += p * u;
      pv += p * v;
    }
    const determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) return [1, 0, 0];
    const second = Math.max(0, (vv * pu - uv * pv) / determinant);
    const third = Math.max(0, (uu * pv - uv * pu) / determinant);
    const excess = Math.max(1, second + third);
    return [Math.max(0, 1 - (second + third) / excess), second / excess, third / excess];
  }
}
