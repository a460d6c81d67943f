// SPDX-License-Identifier: MIT
//
// The entry of dist/standalone.js: the element with everything that it needs, for pages without a
// bundler. Its workers run the same file and know their task by their name. core.wasm, gltf.wasm
// and draco.wasm have to lie beside it.

// Types alone: this script exports nothing.
export type * from './element.js';

const parts: Readonly<Record<string, () => Promise<unknown>>> = {
  'geodesic-voronoi': () => import('geodesic-voronoi/worker'),
  'geodesic-voronoi-drawing': () => import('./buffers/drawing_worker.js'),
};

// Not awaited: a worker that waits here might miss its first message.
if (globalThis.document) void import('./element.js');
else void parts[(globalThis as { name?: string }).name ?? '']?.();
