// SPDX-License-Identifier: MIT
//
// How the library is loaded; where files are read from is for `index.ts` and `node.ts` to say.

import { toOptions } from './base/checks.js';
import { compile, type CompileAddress } from './base/compile.js';
import { Library } from './library/library.js';
import { LocalEngine } from './engine/local_engine.js';
import type { CompiledModule, WasmSource } from './api/options.js';
import type { GeodesicVoronoi } from './api/types.js';

export interface LoadOptions {
  /** core.wasm; by default the one beside this file, which only an ES module finds. */
  wasm?: WasmSource | undefined;
  /** gltf.wasm, loaded with the first glTF file; by default the one beside this file. */
  gltfWasm?: WasmSource | undefined;
  /** draco.wasm, loaded with the first model that Draco has compressed; by default the one beside this file. */
  dracoWasm?: WasmSource | undefined;
}

/** Where the modules that every glTF needs are; by default beside this file. */
export type CompileOptions = Pick<LoadOptions, 'wasm' | 'gltfWasm'>;

/** The two modules that every glTF needs, compiled: options of `load` and `loadWorker`. */
export type Modules = Record<'wasm' | 'gltfWasm', CompiledModule>;

/** Where the modules are by default. The addresses are written so that bundlers see them. */
const beside = () => ({
  wasm: known(() => new URL('./core.wasm', import.meta.url)),
  gltfWasm: known(() => new URL('./gltf.wasm', import.meta.url)),
});

/** A bundle that is no ES module does not know its own address: there, these have to be given. */
function known(address: () => URL): URL | undefined {
  try {
    return address();
  } catch {
    return undefined;
  }
}

/** The options of loading, where they are left out. */
export const loadDefaults = () => ({
  ...beside(),
  dracoWasm: known(() => new URL('./draco.wasm', import.meta.url)),
});

export async function compileSources(
  options: CompileOptions | undefined,
  compileAddress: CompileAddress,
): Promise<Modules> {
  const sources = toOptions(options, beside());
  const [wasm, gltfWasm] = await Promise.all([
    compile('wasm', sources.wasm, compileAddress),
    compile('gltfWasm', sources.gltfWasm, compileAddress),
  ]);
  return { wasm, gltfWasm };
}

export async function loadLocal(
  options: LoadOptions | undefined,
  compileAddress: CompileAddress,
): Promise<GeodesicVoronoi> {
  return new Library(await LocalEngine.load(toOptions(options, loadDefaults()), compileAddress));
}
