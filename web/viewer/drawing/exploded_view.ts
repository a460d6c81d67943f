// SPDX-License-Identifier: MIT
//
// The exploded view: which parts are shown instead of the whole model, and which come next.

import { type Data3DTexture, Group } from 'three';
import type { PartTriangles } from '../buffers/part_triangles.js';
import { ExplodedParts } from './exploded_parts.js';

export class ExplodedView {
  readonly object = new Group();
  readonly #whole: Group;
  readonly #occlusion: Data3DTexture;
  #shade = 1;
  #shown: ExplodedParts | undefined;
  #coming: ExplodedParts | undefined;

  /** Parts are shown instead of `whole`. */
  constructor(whole: Group, occlusion: Data3DTexture) {
    this.#whole = whole;
    this.#occlusion = occlusion;
  }

  /** Makes parts to be uploaded before they are shown; drops earlier ones that were never shown. */
  prepare(triangles: PartTriangles): ExplodedParts {
    this.#discard(this.#coming);
    this.#coming = new ExplodedParts(triangles, this.#occlusion);
    this.#coming.shade = this.#shade;
    this.object.add(this.#coming.object);
    return this.#coming;
  }

  /** Shows prepared parts; undefined for none. */
  show(parts: ExplodedParts | undefined): void {
    if (this.#coming !== parts) this.#discard(this.#coming);
    this.#coming = undefined;
    this.#discard(this.#shown);
    this.#shown = parts;
    parts?.show();
    this.#whole.visible = !parts;
  }

  #discard(parts: ExplodedParts | undefined): void {
    if (parts) this.object.remove(parts.object);
    parts?.dispose();
  }

  /** The factor that colours are multiplied by. */
  set shade(shade: number) {
    this.#shade = shade;
    for (const parts of [this.#shown, this.#coming]) if (parts) parts.shade = shade;
  }

  /** How far the parts have moved, 0 … 1. */
  spread(share: number): void {
    this.#shown?.spread(share);
  }

  dispose(): void {
    this.show(undefined);
  }
}
