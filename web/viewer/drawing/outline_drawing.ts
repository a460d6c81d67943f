// SPDX-License-Identifier: MIT
//
// The bold outline of one region.

import type { DiagramData } from 'geodesic-voronoi';
import type { Object3D } from 'three';
import { FatLines, outlineEnds } from './lines.js';
import type { SceneMesh } from '../buffers/scene_mesh.js';

type Loops = Pick<DiagramData, 'points' | 'loops'>;

export class OutlineDrawing {
  readonly #mesh: SceneMesh;
  readonly #lines = new FatLines({ width: 4.5 });
  /** The loops when the whole diagram was drawn; `#changed` has those of regions changed since. */
  #loops: Loops | undefined;
  readonly #changed = new Map<number, Float32Array>();
  #label = -1;

  constructor(mesh: SceneMesh) {
    this.#mesh = mesh;
  }

  get object(): Object3D {
    return this.#lines.object;
  }

  set colour(colour: number) {
    this.#lines.colour = colour;
  }

  /** The loops of a whole diagram; no outline is drawn. */
  setLoops(loops: Loops | undefined): void {
    this.#loops = loops;
    this.#changed.clear();
    this.show(-1);
  }

  /** The loops of the labels that a change made different; no outline is drawn. */
  changeLoops(labels: Iterable<number>, part: Loops): void {
    for (const label of labels) this.#changed.set(label, outlineEnds(this.#mesh, part, label));
    this.show(-1);
  }

  /** Draws the outline of a region; -1 for none. */
  show(label: number): void {
    if (label === this.#label) return;
    this.#label = label;
    this.#lines.set(label < 0 ? new Float32Array() : this.#endsOf(label));
  }

  dispose(): void {
    this.#lines.dispose();
  }

  #endsOf(label: number): Float32Array {
    const changed = this.#changed.get(label);
    if (changed || !this.#loops) return changed ?? new Float32Array();
    return outlineEnds(this.#mesh, this.#loops, label);
  }
}
