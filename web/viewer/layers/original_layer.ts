// SPDX-License-Identifier: MIT
//
// The model's own material, read from its files while the layer is shown.

import type { DrawingPlace } from './derived_drawings.js';
import type { Emit } from '../events.js';
import type { OriginalMaterial } from '../drawing/original_material.js';
import type { OpenModel } from '../model/open_model.js';

export class OriginalLayer {
  readonly #place: DrawingPlace;
  readonly #emit: Emit;
  /** The model whose material was last asked for. */
  #shown: OpenModel | undefined;
  /** Of the last reading; aborted when its material is not wanted any more. */
  #reading = new AbortController();

  constructor(place: DrawingPlace, emit: Emit) {
    this.#place = place;
    this.#emit = emit;
  }

  /** Shows the material if the attributes ask for it. */
  async update(): Promise<void> {
    const { attributes, model } = this.#place;
    const wanted = attributes.layers.includes('original') ? model : undefined;
    if (wanted === this.#shown) return;
    this.#shown = wanted;
    this.#reading.abort();
    this.#reading = new AbortController();
    const { signal } = this.#reading;
    let problem: string | undefined;
    const material = await this.#read(wanted, signal).catch((error: Error) => {
      problem = error.message;
      return undefined;
    });
    if (signal.aborted) {
      material?.dispose();
      return;
    }
    model?.drawing.setOriginal(material);
    this.#place.stage.invalidate();
    const textures = material?.textures ?? 0;
    this.#emit('original', wanted ? { isFound: material !== undefined, textures, problem } : null);
  }

  dispose(): void {
    this.#reading.abort();
  }

  async #read(
    model: OpenModel | undefined,
    signal: AbortSignal,
  ): Promise<OriginalMaterial | undefined> {
    if (!model) return undefined;
    const { originalMaterial } = await import('../drawing/original_material.js');
    const { files, drawing, builder } = model;
    const material = await originalMaterial(files, drawing.mesh.frame, builder, signal);
    if (material) await this.#place.stage.compile(material.object);
    return material;
  }
}
