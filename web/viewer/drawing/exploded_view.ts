// SPDX-License-Identifier: MIT
//
// The exploded view: the parts that are shown instead of the whole model.

import { type Data3DTexture, Group } from 'three';
import type { PartTriangles } from '../buffers/part_triangles.js';
import { ExplodedParts } from './exploded_parts.js';

export class ExplodedView {
  readonly object = new Group();
  readonly #whole: Group;
  readonly #occlusion: Data3DTexture;
  #shade = 1;
  #shown: ExplodedParts | undefined;

  /** Parts are shown instead of `whole`. */
  constructor(whole: Group, occlusion: Data3DTexture) {
    this.#whole = whole;
    this.#occlusion = occlusion;
  }

  /** Makes parts to be uploaded before they are shown; whoever never shows them disposes of them. */
  prepare(triangles: PartTriangles): ExplodedParts {
    const parts = new ExplodedParts(triangles, this.#occlusion);
    this.object.add(parts.object);
    return parts;
  }

  /** Shows prepared parts; undefined for none. */
  show(parts: ExplodedParts | undefined): void {
    this.#shown?.dispose();
    this.#shown = parts;
    this.shade = this.#shade;
    parts?.show();
    this.#whole.visible = !parts;
  }

  /** The factor that colours are multiplied by. */
  set shade(shade: number) {
    this.#shade = shade;
    if (this.#shown) this.#shown.shade = shade;
  }

  /** How far the parts have moved, 0 … 1. */
  spread(share: number): void {
    this.#shown?.spread(share);
  }

  dispose(): void {
    this.show(undefined);
  }
}
