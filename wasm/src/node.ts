// SPDX-License-Identifier: MIT
//
// geodesic-voronoi in Node: as in a page, but modules are read from the disk.

import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { compileFromWeb } from './compile.js';
import { compileSources, loadLocal, type LoadOptions, type Modules } from './load.js';
import type { GeodesicVoronoi } from './types.js';

export * from './index.js';

/** The library on the calling thread. Long work is done in slices of about 12 ms. */
export function load(options?: LoadOptions): Promise<GeodesicVoronoi> {
  return loadLocal(options, compileFromDisk);
}

/** Both modules, compiled: with them as options, any number of libraries start without compiling again. */
export function compileModules(options?: LoadOptions): Promise<Modules> {
  return compileSources(options, compileFromDisk);
}

/** A path or an address. */
async function compileFromDisk(address: URL | string): Promise<WebAssembly.Module> {
  const url = new URL(address, pathToFileURL('./'));
  return url.protocol === 'file:' ? WebAssembly.compile(await readFile(url)) : compileFromWeb(url);
}
