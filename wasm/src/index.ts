// SPDX-License-Identifier: MIT
//
// geodesic-voronoi in a page or a worker; Node has `node.ts` instead. Importing it does nothing.

import { isA, isObject, show, toOptions } from './base/checks.js';
import { compile, compileFromWeb, isAddress } from './base/compile.js';
import { GeodesicVoronoiError, invalidArgument, type ErrorCode } from './api/errors.js';
import { Library } from './library/library.js';
import {
  compileSources,
  loadDefaults,
  loadLocal,
  type CompileOptions,
  type LoadOptions,
  type Modules,
} from './load.js';
import type { WasmSource } from './api/options.js';
import type { GeodesicVoronoi } from './api/types.js';
import { startWorkerEngine } from './engine/worker_engine.js';

export type * from './api/options.js';
export type * from './api/results.js';
export { mostMislabelled } from './api/results.js';
export type * from './api/types.js';
export type { CompileOptions, ErrorCode, LoadOptions, Modules };
export { GeodesicVoronoiError };
export { gltfResourceUris } from './input/gltf_document.js';
export * from './library/find_model.js';
export type { LengthsJson, PlacedPointsJson, SurfacePointsJson } from './output/json_forms.js';
export { pointsJson } from './output/json_forms.js';
export * from './output/diagram_formats.js';
export * from './output/distance_formats.js';
export type {
  AttributeSource,
  FileOptions,
  JsonOptions,
  PartitionLayout,
  SurfaceFileOptions,
} from './output/file_options.js';
export * from './output/partition_formats.js';
export * from './output/polygon_formats.js';
export { repairSentences } from './base/sentences.js';

/**
 * The library on the calling thread. Long work is done in slices of about 12 ms; the guide names what
 * blocks the thread longer.
 */
export function load(options?: LoadOptions): Promise<GeodesicVoronoi> {
  return loadLocal(options, compileFromWeb);
}

/**
 * The modules that every glTF needs, compiled: with them as options of `load` and `loadWorker`, any
 * number of libraries start without compiling again.
 */
export function compileModules(options?: CompileOptions): Promise<Modules> {
  return compileSources(options, compileFromWeb);
}

/** A `Worker` of a page. That name is one of the DOM's types, which a project for Node need not have. */
export interface PageWorker {
  onerror: ((event: never) => unknown) | null;
  addEventListener(type: 'messageerror', listener: () => void): void;
  postMessage(message: unknown): void;
  terminate(): void;
}

export interface LoadWorkerOptions extends LoadOptions {
  /**
   * A module worker that runs `geodesic-voronoi/worker`, or the address of that script; by default
   * the one beside this file.
   */
  worker?: PageWorker | URL | string | undefined;
}

/**
 * The library in a module worker of its own; `dispose()` ends it.
 *
 * Vite and webpack find the worker's script and the modules by themselves. A bundler that
 * does not follow `new URL(…, import.meta.url)`, such as esbuild, has to be told: make
 * `geodesic-voronoi/worker` an entry point beside the app, have `geodesic-voronoi/core.wasm` and
 * `geodesic-voronoi/gltf.wasm` copied (esbuild's loader `file`), and pass their addresses:
 *
 *     import wasm from 'geodesic-voronoi/core.wasm';
 *     import gltfWasm from 'geodesic-voronoi/gltf.wasm';
 *     const gvd = await loadWorker({ worker: '/worker.js', wasm, gltfWasm });
 *
 * Models compressed by Draco need `geodesic-voronoi/draco.wasm`, too: the option `dracoWasm`.
 */
export async function loadWorker(options?: LoadWorkerOptions): Promise<GeodesicVoronoi> {
  const { worker, wasm, gltfWasm, dracoWasm } = toOptions(options, {
    worker: undefined,
    ...loadDefaults(),
  });
  requireWorker(worker);
  const sources = {
    wasm: await toPost('wasm', wasm),
    gltfWasm: await toPost('gltfWasm', gltfWasm),
    dracoWasm: await toPost('dracoWasm', dracoWasm),
  };
  // The worker starts last: none is left behind by a source that cannot be posted.
  return new Library(await startWorkerEngine(startWorker(worker), sources, nameOf(worker)));
}

function isWorker(worker: unknown): worker is PageWorker {
  return isObject(worker) && 'terminate' in worker && 'addEventListener' in worker;
}

/** What errors call a worker: by its address, unless the caller has started it. */
function nameOf(worker: LoadWorkerOptions['worker']): string {
  return isWorker(worker)
    ? 'the worker'
    : `the worker ${JSON.stringify(String(worker ?? 'worker.js'))}`;
}

function requireWorker(worker: LoadWorkerOptions['worker']): void {
  if (isWorker(worker)) return;
  if (worker !== undefined && !isAddress(worker))
    throw invalidArgument(`worker is ${show(worker)}, neither a web worker nor an address`);
  if (typeof Worker === 'undefined')
    throw new GeodesicVoronoiError(
      'load-failed',
      'there are no module workers here (as in Node, within whose workers load() works): use load()',
    );
}

function startWorker(worker: LoadWorkerOptions['worker']): Worker {
  if (isWorker(worker)) return worker as Worker;
  try {
    if (worker === undefined)
      return new Worker(new URL('./worker.js', import.meta.url), {
        type: 'module',
        name: 'geodesic-voronoi',
      });
    return new Worker(worker, { type: 'module', name: 'geodesic-voronoi' });
  } catch (cause) {
    throw new GeodesicVoronoiError(
      'load-failed',
      `${nameOf(worker)} cannot be started: ${(cause as Error).message}`,
      { cause },
    );
  }
}

/** Makes a source fit to be posted: resolves addresses here, since the worker has another base. */
async function toPost(
  name: string,
  source: WasmSource | undefined,
): Promise<WasmSource | undefined> {
  if (!isAddress(source))
    return isA(source, 'Response') ? compile(name, source, compileFromWeb) : source;
  try {
    return new URL(source, globalThis.document?.baseURI ?? globalThis.location?.href).href;
  } catch {
    throw invalidArgument(`${name} is ${show(source)}, not an address`);
  }
}
