// SPDX-License-Identifier: MIT
import { GeodesicVoronoiError } from './errors.js';

/** Where a WebAssembly module comes from: an address, its bytes, or the module itself. */
export type WasmSource = URL | string | ArrayBuffer | Uint8Array | WebAssembly.Module;

/** Compiles the module at an address; how depends on where the library runs. */
export type CompileAddress = (address: URL | string) => Promise<WebAssembly.Module>;

/** The module of a source; 'load-failed' if it is not to be had. */
export async function compile(
  source: WasmSource,
  compileAddress: CompileAddress,
): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  const isAddress = typeof source === 'string' || source instanceof URL;
  try {
    return await (isAddress ? compileAddress(source) : WebAssembly.compile(source as BufferSource));
  } catch (cause) {
    const what = isAddress ? String(source) : 'the WebAssembly module';
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new GeodesicVoronoiError('load-failed', `${what} cannot be loaded: ${why}`, { cause });
  }
}

export async function compileFromWeb(address: URL | string): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the server answers ${response.status} ${response.statusText}`);
  // Compiling while it arrives is refused for any other media type, and some servers know none.
  return response.headers.get('Content-Type')?.startsWith('application/wasm')
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}
