// SPDX-License-Identifier: MIT
import { compile, type CompileAddress, type WasmSource } from './compile.js';
import { LocalEngine, type EngineSources } from './engine.js';
import { Library } from './library.js';
import type { GeodesicVoronoi } from './types.js';

export interface LoadOptions {
  /** core.wasm; by default the one beside this file. */
  wasm?: WasmSource;
  /** gltf.wasm, loaded with the first glTF file; by default the one beside this file. */
  gltfWasm?: WasmSource;
}

/** Both modules, compiled: options of `load` and `loadWorker`. */
export type Modules = Record<keyof LoadOptions, WebAssembly.Module>;

/** Where the modules are. The addresses are written so that bundlers see them. */
export function sourcesOf(options: LoadOptions): EngineSources {
  return {
    wasm: options.wasm ?? new URL('./core.wasm', import.meta.url),
    gltfWasm: options.gltfWasm ?? new URL('./gltf.wasm', import.meta.url),
  };
}

export async function compileSources(
  options: LoadOptions,
  compileAddress: CompileAddress,
): Promise<Modules> {
  const sources = sourcesOf(options);
  const [wasm, gltfWasm] = await Promise.all([
    compile(sources.wasm, compileAddress),
    compile(sources.gltfWasm, compileAddress),
  ]);
  return { wasm, gltfWasm };
}

export async function loadLocal(
  options: LoadOptions,
  compileAddress: CompileAddress,
): Promise<GeodesicVoronoi> {
  return new Library(await LocalEngine.load(sourcesOf(options), compileAddress));
}
