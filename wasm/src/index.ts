// SPDX-License-Identifier: MIT
//
// geodesic-voronoi in a page or a worker. Importing it does nothing; `node.ts` is its face in Node.

import { compileFromWeb, type WasmSource } from './compile.js';
import { GeodesicVoronoiError } from './errors.js';
import { Library } from './library.js';
import { compileSources, loadLocal, sourcesOf, type LoadOptions, type Modules } from './load.js';
import type { GeodesicVoronoi } from './types.js';
import { WorkerEngine } from './worker_engine.js';

export type * from './types.js';
export type { LoadOptions, Modules, WasmSource };
export { GeodesicVoronoiError };
export { gltfResourceUris } from './gltf.js';
export { diagramGlb, diagramJson, diagramObj } from './formats.js';
export { distancesGlb, distancesJson, distancesPly, pathsJson, pathsObj } from './distance_formats.js';
export type { PartitionFileOptions, PartitionGlbOptions } from './partition_formats.js';
export type { PolygonFileOptions } from './polygon_formats.js';
export { partitionGlb, partitionJson, partitionObj, partitionPly } from './partition_formats.js';
export { polygonGlb, polygonJson, polygonObj, polygonPly } from './polygon_formats.js';

/** The library on the calling thread. Long work is done in slices of about 12 ms. */
export function load(options: LoadOptions = {}): Promise<GeodesicVoronoi> {
  return loadLocal(options, compileFromWeb);
}

/** Both modules, compiled: with them as options, any number of workers start without compiling again. */
export function compileModules(options: LoadOptions = {}): Promise<Modules> {
  return compileSources(options, compileFromWeb);
}

/** The library in a module worker of its own; `dispose()` ends it. */
export async function loadWorker(options: LoadOptions = {}): Promise<GeodesicVoronoi> {
  if (typeof Worker === 'undefined') {
    throw new GeodesicVoronoiError('load-failed', 'there are no module workers here: use load()');
  }
  const worker = new Worker(new URL('./worker.js', import.meta.url), {
    type: 'module',
    name: 'geodesic-voronoi',
  });
  const { wasm, gltfWasm } = sourcesOf(options);
  return new Library(
    await WorkerEngine.start(worker, { wasm: absolute(wasm), gltfWasm: absolute(gltfWasm) }),
  );
}

/** An address as the page means it: the worker's own base is another. */
function absolute(source: WasmSource): WasmSource {
  const isAddress = typeof source === 'string' || source instanceof URL;
  return isAddress ? new URL(source, globalThis.document?.baseURI ?? location.href).href : source;
}
