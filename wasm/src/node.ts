// SPDX-License-Identifier: MIT
//
// geodesic-voronoi in Node: as in a page, but modules are read from the disk.

import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { compileFromWeb } from './base/compile.js';
import {
  compileSources,
  loadLocal,
  type CompileOptions,
  type LoadOptions,
  type Modules,
} from './load.js';
import type { CompiledModule } from './api/options.js';
import type { GeodesicVoronoi } from './api/types.js';

export * from './index.js';

/** As in a page. */
export function load(options?: LoadOptions): Promise<GeodesicVoronoi> {
  return loadLocal(options, compileFromDisk);
}

/** As in a page. */
export function compileModules(options?: CompileOptions): Promise<Modules> {
  return compileSources(options, compileFromDisk);
}

/** An address, or a path, in which # and ? and % are letters as any others. */
async function compileFromDisk(address: URL | string): Promise<CompiledModule> {
  const isPath =
    typeof address === 'string' && !/^([a-z][a-z\d+.-]*:\/\/|data:|blob:)/i.test(address);
  const url = isPath ? pathToFileURL(address) : new URL(address);
  return url.protocol === 'file:' ? WebAssembly.compile(await readFile(url)) : compileFromWeb(url);
}
