// SPDX-License-Identifier: MIT
//
// The regions as patches that move apart.

import {
  BufferAttribute,
  BufferGeometry,
  type Data3DTexture,
  DoubleSide,
  Mesh,
  MeshLambertMaterial,
} from 'three';
import { occlude } from './occlusion.js';
import type { PartTriangles } from './part_triangles.js';

/** How far, in radii of the model, a part at distance 1 moves at most. */
export const widestSpread = 1;

/** Parts are moved by the graphics card: going apart uploads nothing. */
export class ExplodedParts {
  readonly object: Mesh<BufferGeometry, MeshLambertMaterial>;
  readonly #spread = { value: 0 };

  constructor({ position, direction, normal, colour }: PartTriangles, occlusion: Data3DTexture) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(position, 3));
    geometry.setAttribute('direction', new BufferAttribute(direction, 3));
    geometry.setAttribute('normal', new BufferAttribute(normal, 3));
    geometry.setAttribute('color', new BufferAttribute(colour, 3, true));
    const material = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.spread = this.#spread;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nuniform float spread;\nattribute vec3 direction;')
        .replace('#include <begin_vertex>', '#include <begin_vertex>\ntransformed += spread * direction;');
    };
    occlude(material, occlusion);
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
  }

  /** What colours are multiplied by. */
  set shade(shade: number) {
    this.object.material.color.setScalar(shade);
  }

  /** 0: together, 1: as far apart as they go. */
  spread(share: number): void {
    this.#spread.value = widestSpread * share;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
