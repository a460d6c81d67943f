// SPDX-License-Identifier: MIT
//
// The surface of a PLY file with the colours of its vertices. Of a large file it takes a while: a worker
// makes it where there is one.

import type { TypedArray } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

/** Three numbers per vertex; whether their largest stands for 1. */
interface VertexNumbers {
  array: TypedArray;
  normalized: boolean;
}

export interface PlySurface {
  position: VertexNumbers;
  normal: VertexNumbers;
  /** Linear RGB. */
  color: VertexNumbers;
  /** Three vertices per triangle; without, they are in this order. */
  index: TypedArray | undefined;
}

/** Null if its vertices have no colours. */
export function plySurface(bytes: Uint8Array): PlySurface | null {
  const geometry = new PLYLoader().parse(bytes.slice().buffer);
  if (!geometry.hasAttribute('color')) return null;
  if (!geometry.hasAttribute('normal')) geometry.computeVertexNormals();
  const numbers = (name: string) => {
    const { array, normalized } = geometry.getAttribute(name);
    return { array, normalized };
  };
  return {
    position: numbers('position'),
    normal: numbers('normal'),
    color: numbers('color'),
    index: geometry.index?.array,
  };
}
