// SPDX-License-Identifier: MIT
//
// The WebAssembly modules, from wherever they are.

import { isA, show } from './checks.js';
import { GeodesicVoronoiError, invalidArgument } from '../api/errors.js';
import type { CompiledModule, WasmSource } from '../api/options.js';

/** Compiles the module at an address; how depends on where the library runs. */
export type CompileAddress = (address: URL | string) => Promise<CompiledModule>;

/** Compiles a source, or throws 'load-failed'. `name` is the option's, for errors. */
export async function compile(
  name: string,
  source: WasmSource | undefined,
  compileAddress: CompileAddress,
): Promise<CompiledModule> {
  if (isA(source, 'WebAssembly.Module')) return source;
  try {
    if (isAddress(source)) return await awake(() => compileAddress(source));
    if (isA(source, 'Response')) return await awake(() => compileResponse(source));
    const bytes = bytesOf(source);
    if (bytes) return await awake(() => WebAssembly.compile(bytes));
  } catch (cause) {
    const what = isAddress(source) ? String(source) : 'the WebAssembly module';
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new GeodesicVoronoiError('load-failed', `${what} cannot be loaded: ${why}`, { cause });
  }
  throw invalidArgument(
    `${name} is ${show(source)}, not an address, bytes, a Response or a WebAssembly.Module`,
  );
}

/** Waits for the import of a script of this library, or throws 'load-failed'. */
export async function imported<Script>(script: Promise<Script>): Promise<Script> {
  try {
    return await script;
  } catch (cause) {
    const why = (cause as Error).message;
    throw new GeodesicVoronoiError('load-failed', `a script cannot be loaded: ${why}`, { cause });
  }
}

/**
 * Compiles or instantiates a module while a timer keeps the event loop busy. With nothing else to wait
 * for, Node 20 blocks the thread until its background tasks end: for ever, if one of them, which
 * optimizes JavaScript, needs this thread to collect garbage.
 */
export async function awake<Result>(work: () => Promise<Result>): Promise<Result> {
  const timer = setInterval(() => {}, 1000);
  try {
    return await work();
  } finally {
    clearInterval(timer);
  }
}

export async function compileFromWeb(address: URL | string): Promise<CompiledModule> {
  return compileResponse(await fetch(address));
}

async function compileResponse(response: Response): Promise<CompiledModule> {
  if (!response.ok) throw new Error(`the server answers ${response.status} ${response.statusText}`);
  // Streaming compilation needs exactly this media type, which some servers do not send.
  return response.headers.get('Content-Type') === 'application/wasm'
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

export function isAddress(source: unknown): source is URL | string {
  return typeof source === 'string' || isA(source, 'URL');
}

function bytesOf(source: unknown): Uint8Array<ArrayBuffer> | undefined {
  if (isA(source, 'ArrayBuffer')) return new Uint8Array(source);
  if (!ArrayBuffer.isView(source)) return undefined;
  return new Uint8Array(source.buffer as ArrayBuffer, source.byteOffset, source.byteLength);
}
