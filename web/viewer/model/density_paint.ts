// SPDX-License-Identifier: MIT
//
// A density painted on a model.

import type { Brush } from '../attributes/attribute_values.js';
import type { SurfaceHit } from './picking.js';
import type { DrawingBuilder } from '../buffers/drawing_builder.js';
import { type Adjacency, adjacencyOf } from '../buffers/places.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

/** The densities that a brush paints with lie between this and its inverse. */
export const greatestDensity = 1000;

/** The share of the way to the brush's density that one dab goes at its centre. */
const flow = 0.5;

/**
 * A density painted on the surface, per input vertex. A dab reaches what is connected to its centre
 * within its radius: not the other side of a thin part.
 */
export class DensityPaint {
  readonly #mesh: SceneMesh;
  /** Logarithms as shares of the greatest's: -1 … 1, 0 where nothing is painted. */
  readonly #tints: Float32Array;
  #adjacency: Adjacency | undefined;
  #isPrepared = false;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
    this.#tints = new Float32Array(mesh.positions.length / 3);
  }

  /** Per input vertex, -1 … 1; undefined if nothing is painted. */
  get tints(): Float32Array | undefined {
    return this.#tints.some((tint) => tint !== 0) ? this.#tints : undefined;
  }

  set tints(tints: Float32Array | undefined) {
    if (tints) this.#tints.set(tints);
    else this.#tints.fill(0);
  }

  /** Per input vertex; undefined if nothing is painted. */
  get density(): Float64Array | undefined {
    if (!this.tints) return undefined;
    const density = new Float64Array(this.#tints.length).fill(1);
    this.#tints.forEach((tint, v) => {
      if (tint !== 0) density[v] = greatestDensity ** tint;
    });
    return density;
  }

  set density(density: ArrayLike<number> | undefined) {
    if (density) this.#check(density);
    for (let v = 0; v < this.#tints.length; ++v) this.#tints[v] = tintOf(density?.[v] ?? 1);
  }

  #check(density: ArrayLike<number>): void {
    const count = this.#tints.length;
    if (density.length !== count)
      throw new RangeError(
        `density has the length ${density.length}, and the model ${count} vertices.`,
      );
    const wrong = Array.prototype.findIndex.call(density, (value) => !(value >= 0));
    if (wrong >= 0)
      throw new RangeError(`density is ${density[wrong]} at vertex ${wrong}, not 0 or above.`);
  }

  /** To be called before the first dab: what all dabs need is made in a worker then. */
  async prepare(builder: DrawingBuilder): Promise<void> {
    if (this.#isPrepared) return;
    this.#isPrepared = true;
    this.#adjacency ??= await builder.ask('adjacency');
  }

  /** Returns whether any vertex is within reach: where triangles are large, there may be none. */
  dab({ face, place }: SurfaceHit, { radius, density }: Brush): boolean {
    let reaches = false;
    const adjacency = (this.#adjacency ??= adjacencyOf(this.#mesh));
    const { positions, indices } = this.#mesh;
    const target = tintOf(density);
    flood(face, { indices, ...adjacency }, (v) => {
      const distance = Math.hypot(
        positions[3 * v] - place.x,
        positions[3 * v + 1] - place.y,
        positions[3 * v + 2] - place.z,
      );
      if (!(distance < radius)) return false;
      const share = flow * (1 - (distance / radius) ** 2);
      const tint = this.#tints[v] + share * (target - this.#tints[v]);
      // Without this, the tint would approach its target forever.
      this.#tints[v] = Math.abs(tint - target) < 0.01 ? target : tint;
      reaches = true;
      return true;
    });
    return reaches;
  }
}

function tintOf(density: number): number {
  const tint = Math.log(density) / Math.log(greatestDensity);
  return Math.min(1, Math.max(-1, tint));
}

/** Visits the vertices connected to a face by vertices that `accept` accepts, each once. */
function flood(
  startFace: number,
  { indices, place, offset, corners }: Adjacency & { indices: Int32Array },
  accept: (vertex: number) => boolean,
): void {
  const accepted = new Map<number, boolean>();
  const seen = new Set([startFace]);
  for (const face of seen) {
    for (let corner = 3 * face; corner < 3 * face + 3; ++corner) {
      const v = indices[corner];
      if (accepted.has(v)) continue;
      const isInside = accept(v);
      accepted.set(v, isInside);
      if (!isInside) continue;
      const p = place[v];
      // The loop over the set also visits faces added here.
      for (let i = offset[p]; i < offset[p + 1]; ++i) seen.add(Math.floor(corners[i] / 3));
    }
  }
}
