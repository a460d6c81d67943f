// SPDX-License-Identifier: MIT
//
// The exploded view: the regions as patches that move, shown instead of the whole model.

import {
  BufferAttribute,
  BufferGeometry,
  type Data3DTexture,
  DoubleSide,
  Group,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { occlude } from './occlusion.js';
import { wholeScene } from './record_buffer.js';
import type { PartTriangles } from '../buffers/part_triangles.js';

/** The farthest that a part at distance 1 moves, in radii of the model. */
export const widestSpread = 1;

/** The most triangles that one frame uploads. */
const trianglesPerUpload = 40_000;

/** Parts are moved by the graphics card: no movement uploads anything. */
export class ExplodedParts {
  readonly object = new Group();
  readonly triangleCount: number;
  readonly #triangles: PartTriangles;
  readonly #material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
  readonly #spread = { value: 0 };
  #uploaded = 0;

  constructor(triangles: PartTriangles, occlusion: Data3DTexture) {
    this.#triangles = triangles;
    this.triangleCount = triangles.position.length / 9;
    this.#material.onBeforeCompile = (shader) => {
      shader.uniforms.spread = this.#spread;
      shader.vertexShader = shader.vertexShader
        .replace(
          '#include <common>',
          '#include <common>\nuniform float spread;\nattribute vec3 direction;',
        )
        .replace(
          '#include <begin_vertex>',
          '#include <begin_vertex>\ntransformed += spread * direction;',
        );
    };
    // three.js tells programs apart by the text of `onBeforeCompile`: the same for all of
    // `occlude`.
    this.#material.customProgramCacheKey = () => 'exploded parts';
    occlude(this.#material, occlusion);
  }

  /** Has the next drawing upload more triangles, without showing them; false once all are there. */
  uploadMore(): boolean {
    if (this.#uploaded >= this.triangleCount) return false;
    const first = 9 * this.#uploaded;
    this.#uploaded += trianglesPerUpload;
    const end = 9 * this.#uploaded;
    const { position, direction, normal, colour } = this.#triangles;
    const geometry = new BufferGeometry()
      .setAttribute('position', new BufferAttribute(position.subarray(first, end), 3))
      .setAttribute('direction', new BufferAttribute(direction.subarray(first, end), 3, true))
      .setAttribute('normal', new BufferAttribute(normal.subarray(first, end), 3, true))
      .setAttribute('color', new BufferAttribute(colour.subarray(first, end), 3, true));
    geometry.setDrawRange(0, 0);
    geometry.boundingSphere = wholeScene;
    const some = new Mesh(geometry, this.#material);
    some.frustumCulled = false;
    this.object.add(some);
    return true;
  }

  /** Shows what has been uploaded, its colours multiplied by this factor. */
  show(shade: number): void {
    this.shade = shade;
    for (const { geometry } of this.object.children as Mesh[]) geometry.setDrawRange(0, Infinity);
  }

  /** The factor that colours are multiplied by. */
  set shade(shade: number) {
    this.#material.color.setScalar(shade);
  }

  /** 0: in their places, 1: as far as they go. */
  spread(share: number): void {
    this.#spread.value = widestSpread * share;
  }

  dispose(): void {
    this.object.removeFromParent();
    for (const { geometry } of this.object.children as Mesh[]) geometry.dispose();
    this.#material.dispose();
  }
}
