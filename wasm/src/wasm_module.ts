// SPDX-License-Identifier: MIT
import { GeodesicVoronoiError, outOfMemory } from './errors.js';
import type { ErrorCode } from './types.js';

/** The functions that every module of ours exports: `abi.h`. Pointers are numbers. */
interface Abi {
  memory: WebAssembly.Memory;
  _initialize(): void;
  allocate(bytes: number): number;
  release(pointer: number): void;
  errorCode(): number;
  errorMessage(): number;
  errorMessageLength(): number;
  arrayCount(arrays: number): number;
  arrayRows(arrays: number): number;
  freeArrays(arrays: number): void;
}

export type WasmArray = Int32Array | Float64Array | string;

/** Copies an array into the module's memory for the length of one call; returns its address. */
export type CopyIn = (array: Int32Array | Uint32Array | Float64Array | Uint8Array) => number;

/** `Failure` of `abi.h`, in its order. */
const errorCodes: readonly ErrorCode[] = [
  'internal', // no failure
  'invalid-mesh',
  'invalid-gltf',
  'invalid-point',
  'invalid-argument',
  'out-of-memory',
  'internal',
];

const utf8 = new TextDecoder();

/**
 * What a standalone module asks of its host. Ours read no files, no environment and no clock: what
 * the C library asks for all the same is answered with "nothing there".
 */
function hostFunctions(
  memory: () => WebAssembly.Memory,
): Record<string, (...args: number[]) => number> {
  const badFileDescriptor = 8;
  return {
    'env.emscripten_notify_memory_growth': () => 0,
    'wasi_snapshot_preview1.environ_sizes_get': (count = 0, size = 0) => {
      const view = new DataView(memory().buffer);
      view.setUint32(count >>> 0, 0, true);
      view.setUint32(size >>> 0, 0, true);
      return 0;
    },
    'wasi_snapshot_preview1.environ_get': () => 0,
    'wasi_snapshot_preview1.fd_close': () => badFileDescriptor,
    'wasi_snapshot_preview1.fd_seek': () => badFileDescriptor,
    'wasi_snapshot_preview1.fd_write': () => badFileDescriptor,
    'wasi_snapshot_preview1.proc_exit': (status) => {
      throw new WebAssembly.RuntimeError(`exit with status ${status}`);
    },
  };
}

/** The functions a module imports; a module that wants anything else is not one of ours. */
function importsFor(
  module: WebAssembly.Module,
  memory: () => WebAssembly.Memory,
): WebAssembly.Imports {
  const host = hostFunctions(memory);
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const { module: namespace, name } of WebAssembly.Module.imports(module)) {
    const hostFunction = host[`${namespace}.${name}`];
    if (!hostFunction) {
      throw new GeodesicVoronoiError(
        'load-failed',
        `the WebAssembly module imports ${namespace}.${name}: it is not one of this library's`,
      );
    }
    (imports[namespace] ??= {})[name] = hostFunction;
  }
  return imports;
}

/** An instance of one of our modules: calls with arrays in and arrays out, failures as errors. */
export class WasmModule<Functions> {
  readonly #exports: Abi & Functions;
  #stopped = false;

  private constructor(exports: Abi & Functions) {
    this.#exports = exports;
  }

  static async instantiate<Functions>(module: WebAssembly.Module): Promise<WasmModule<Functions>> {
    const imports = importsFor(module, () => exports.memory);
    let exports: Abi & Functions;
    try {
      const instance = await WebAssembly.instantiate(module, imports);
      exports = instance.exports as unknown as Abi & Functions;
      exports._initialize();
    } catch (cause) {
      throw new GeodesicVoronoiError(
        'load-failed',
        `the WebAssembly module does not start: ${cause}`,
        { cause },
      );
    }
    return new WasmModule(exports);
  }

  /**
   * Calls a function of the module; 0 is its failure and becomes an error. What `copyIn` copied is
   * released afterwards.
   */
  call(f: (functions: Functions, copyIn: CopyIn) => number): number {
    if (this.#stopped) {
      throw new GeodesicVoronoiError(
        'internal',
        'the library has stopped after a fault: load it again',
      );
    }
    const copies: number[] = [];
    try {
      const result = f(this.#exports, (array) => {
        const pointer = this.#copyIn(array);
        copies.push(pointer);
        return pointer;
      });
      if (result === 0) throw this.#failure();
      return result;
    } catch (error) {
      throw this.#orFault(error);
    } finally {
      if (!this.#stopped) for (const pointer of copies) this.#exports.release(pointer);
    }
  }

  /** Like `call`, of a function that returns `Arrays`: copies of them, in their order. */
  arrays(f: (functions: Functions, copyIn: CopyIn) => number): WasmArray[] {
    const arrays = this.call(f);
    try {
      return this.#copyOut(arrays);
    } catch (cause) {
      throw outOfMemory(cause);
    } finally {
      this.#exports.freeArrays(arrays);
    }
  }

  /** Calls a function that cannot fail. After a fault nothing is called: there is nothing to free. */
  run<T>(f: (functions: Functions) => T): T | undefined {
    return this.#stopped ? undefined : f(this.#exports);
  }

  /** A text that the module holds, ended by a zero. */
  text(f: (functions: Functions) => number): string {
    const bytes = new Uint8Array(this.#exports.memory.buffer);
    const start = f(this.#exports) >>> 0;
    return utf8.decode(bytes.subarray(start, bytes.indexOf(0, start)));
  }

  #copyIn(array: Int32Array | Uint32Array | Float64Array | Uint8Array): number {
    if (array.length === 0) return 0;
    const pointer = this.#exports.allocate(array.byteLength) >>> 0;
    if (pointer === 0) throw outOfMemory();
    // The memory's buffer is asked for anew each time: growing replaces it.
    new Uint8Array(this.#exports.memory.buffer, pointer, array.byteLength).set(
      new Uint8Array(array.buffer, array.byteOffset, array.byteLength),
    );
    return pointer;
  }

  #copyOut(arrays: number): WasmArray[] {
    const { buffer } = this.#exports.memory;
    const count = this.#exports.arrayCount(arrays);
    const rows = new Uint32Array(buffer, this.#exports.arrayRows(arrays) >>> 0, 3 * count);
    return Array.from({ length: count }, (_, i) => {
      const [address, length, type] = rows.subarray(3 * i);
      if (type === 0) return copyOf(Int32Array, buffer, address, length);
      if (type === 1) return copyOf(Float64Array, buffer, address, length);
      return utf8.decode(new Uint8Array(buffer, address, length));
    });
  }

  #failure(): GeodesicVoronoiError {
    const code = errorCodes[this.#exports.errorCode()] ?? 'internal';
    if (code === 'out-of-memory') return outOfMemory();
    const message = utf8.decode(
      new Uint8Array(
        this.#exports.memory.buffer,
        this.#exports.errorMessage() >>> 0,
        this.#exports.errorMessageLength(),
      ),
    );
    return new GeodesicVoronoiError(code, message);
  }

  /** A trap leaves the module's memory in an unknown state: nothing may be called any more. */
  #orFault(error: unknown): unknown {
    if (error instanceof GeodesicVoronoiError) return error;
    this.#stopped = true;
    return new GeodesicVoronoiError('internal', `the library has stopped: ${error}`, {
      cause: error,
    });
  }
}

function copyOf<T>(
  type: new (
    buffer: ArrayBuffer | SharedArrayBuffer,
    offset: number,
    length: number,
  ) => { slice(): T },
  buffer: ArrayBuffer,
  address: number,
  length: number,
): T {
  // An empty vector has no address worth the name.
  return new type(buffer, length === 0 ? 0 : address, length).slice();
}
