// SPDX-License-Identifier: MIT
//
// Calls of our WebAssembly modules: plain values and arrays in, copies out, failures as errors.
// Functions are called by their C++ names (see `abi.h`); only those of `abi.cpp` are known here.

import { awake } from './compile.js';
import type { CompiledModule } from '../api/options.js';
import { GeodesicVoronoiError, outOfMemory, type ErrorCode } from '../api/errors.js';
import type { SlicedWork } from './slices.js';

/** What a function takes: a string as UTF-8, an array as a copy for the length of the call. */
export type Argument = number | boolean | Memory;
type Memory = string | Int32Array | Float64Array | Uint8Array | readonly Memory[];

/** The functions of `abi.cpp` that are called directly, without a look at their parameters. */
interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  allocate(bytes: number): number;
  release(pointer: number): void;
  errorCode(): number;
  errorMessage(): number;
  answerRowCount(answer: number): number;
  answerRows(answer: number): number;
}

/** A slice of work has ended, and with it the work: `SliceEnd` in `abi.h`. */
const sliceDone = 2;

/** Units of work between two looks at the clock: far less than a slice, far more than a look. */
const unitsPerStep = 256;
/** Bytes of a result that are copied between two looks at the clock. */
const bytesPerStep = 2 ** 18;

/**
 * The functions that a standalone module imports from its host. Ours read no files, environment or
 * clock: where the C library asks for one nevertheless, the answer is "nothing there".
 */
function hostFunctions(
  memory: () => WebAssembly.Memory,
): Record<string, (...args: number[]) => number> {
  const badFileDescriptor = 8;
  return {
    'env.emscripten_notify_memory_growth': () => growAhead(memory()),
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

/**
 * The C library grows its memory by 64 KB at a time, and each time takes the host a millisecond.
 * Growing ahead, by a share of the memory, makes that a few times instead of thousands.
 */
function growAhead(memory: WebAssembly.Memory): number {
  const pageBytes = 2 ** 16;
  const share = 1 / 8;
  try {
    memory.grow(Math.ceil((share * memory.buffer.byteLength) / pageBytes));
  } catch {
    // The host has no more memory, but enough for what is needed now.
  }
  return 0;
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

export class WasmModule {
  readonly #exports: Exports;
  #stopped = false;

  private constructor(exports: Exports) {
    this.#exports = exports;
  }

  static async instantiate(module: CompiledModule): Promise<WasmModule> {
    const imports = importsFor(module, () => exports.memory);
    let exports: Exports;
    try {
      const instance = await awake(() => WebAssembly.instantiate(module, imports));
      exports = instance.exports as unknown as Exports;
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

  /** Calls a function that returns an address or another number; throws its error if that is 0. */
  call(name: string, ...args: readonly Argument[]): number {
    if (this.#stopped) {
      throw new GeodesicVoronoiError(
        'internal',
        'the library has stopped after a fault: load it again',
      );
    }
    const f = this.#function(name, args.length);
    const copies: number[] = [];
    try {
      const result = f(...args.map((argument) => this.#toNumber(argument, copies)));
      if (result === 0) throw this.#failure();
      return result;
    } catch (error) {
      throw this.#orFault(error);
    } finally {
      if (!this.#stopped) for (const pointer of copies) this.#exports.release(pointer);
    }
  }

  /**
   * Copies an argument that has to outlive a call, and returns the address that stands for it. The
   * copy is never freed: this is for instances that are used once.
   */
  keep(argument: Memory): number {
    return this.#toNumber(argument, []);
  }

  /**
   * Works on an `Answer` in steps, then copies it; the caller frees it. `requireOpen` throws when the
   * work should not go on. Nothing comes between the last step and a copy of a few numbers: if one of
   * them is the address of an object, the caller gets it, and else nobody could free the object.
   */
  *answering<Result>(answer: number, requireOpen: () => unknown = () => {}): SlicedWork<Result> {
    for (;;) {
      requireOpen();
      if (this.call('stepAnswer', answer, unitsPerStep) === sliceDone) break;
      yield this.run('answerProgress', answer) ?? 0;
    }
    return yield* this.copying<Result>(answer);
  }

  /** Copies a finished `Answer` in steps, from the rows of its `Record`. */
  *copying<Result>(answer: number): SlicedWork<Result> {
    const { memory } = this.#exports;
    const count = this.#exports.answerRowCount(answer);
    const start = this.#exports.answerRows(answer) >>> 0;
    const decoder = new TextDecoder(); // one for all texts, of which there may be many
    const rows = new Uint32Array(memory.buffer, start, 5 * count).slice();
    const result = {};
    for (let i = 0; i < count; ++i) {
      const [nameAddress, nameLength, address, length, type] = rows.subarray(5 * i);
      const bytes = new Uint8Array(memory.buffer, nameAddress, nameLength);
      const name = decoder.decode(bytes);
      setValue(result, name, yield* valueAt(memory, address, length, type, decoder));
    }
    return result as Result;
  }

  /**
   * Calls a function that cannot fail. After a fault nothing is called: there is nothing to free.
   */
  run(name: string, ...args: readonly number[]): number | undefined {
    return this.#stopped ? undefined : this.#function(name, args.length)(...args);
  }

  /** Calls a function that returns a text. */
  text(name: string): string {
    return this.#textAt(this.#function(name, 0)());
  }

  /** Finds a function and checks that both sides agree on the number of its parameters. */
  #function(name: string, parameters: number): (...args: number[]) => number {
    const f = (this.#exports as unknown as Record<string, unknown>)[name];
    if (typeof f === 'function' && f.length === parameters) return f as () => number;
    throw new GeodesicVoronoiError(
      'internal',
      `the WebAssembly module has no function ${name} of ${parameters} parameters: ` +
        'it is not of the same version as the JavaScript',
    );
  }

  /** Arrays are passed by the address of an `Array` of `abi.h`: where it is and how long. */
  #toNumber(argument: Argument, copies: number[]): number {
    if (typeof argument === 'number' || typeof argument === 'boolean') return Number(argument);
    return this.#copyIn(Uint32Array.from(this.#arrayOf(argument, copies)), copies);
  }

  #arrayOf(memory: Memory, copies: number[]): [address: number, length: number] {
    if (Array.isArray(memory)) {
      const rows = (memory as Memory[]).flatMap((each) => this.#arrayOf(each, copies));
      return [this.#copyIn(Uint32Array.from(rows), copies), memory.length];
    }
    const array =
      typeof memory === 'string' ? new TextEncoder().encode(memory) : (memory as Uint8Array);
    return [this.#copyIn(array, copies), array.length];
  }

  #copyIn(array: Uint8Array | Uint32Array, copies: number[]): number {
    if (array.length === 0) return 0;
    const pointer = this.#exports.allocate(array.byteLength) >>> 0;
    if (pointer === 0) throw outOfMemory();
    copies.push(pointer);
    // The memory's buffer is asked for anew each time: growing replaces it.
    new Uint8Array(this.#exports.memory.buffer, pointer, array.byteLength).set(
      new Uint8Array(array.buffer, array.byteOffset, array.byteLength),
    );
    return pointer;
  }

  #failure(): GeodesicVoronoiError {
    const code = this.#textAt(this.#exports.errorCode()) as ErrorCode;
    if (code === 'out-of-memory') return outOfMemory();
    return new GeodesicVoronoiError(code, this.#textAt(this.#exports.errorMessage()));
  }

  /** A text that ends with a zero. */
  #textAt(address: number): string {
    const bytes = new Uint8Array(this.#exports.memory.buffer);
    const start = address >>> 0;
    return new TextDecoder().decode(bytes.subarray(start, bytes.indexOf(0, start)));
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

/** Sets what a dotted name leads to; where that is a list, the value is its next element. */
function setValue(object: object, dotted: string, value: unknown): void {
  const path = dotted.split('.');
  const last = path.pop()!;
  let inner = object as Record<string, any>;
  for (const name of path) inner = inner[name] ??= {};
  if (Array.isArray(inner[last])) inner[last].push(value);
  else inner[last] = value;
}

/** A copy of a value, by its type as `Record` of `abi.h` numbers them. */
function* valueAt(
  memory: WebAssembly.Memory,
  address: number,
  length: number,
  type: number,
  decoder: TextDecoder,
): SlicedWork<unknown> {
  const at = length === 0 ? 0 : address; // the address of an empty vector may be anything
  const number = () => new Float64Array(memory.buffer, at, 1)[0];
  switch (type) {
    case 0:
      return yield* copied(memory, at, new Int32Array(length));
    case 1:
      return yield* copied(memory, at, new Float64Array(length));
    case 2:
      yield 1; // there may be as many texts as a file has parts
      return decoder.decode(new Uint8Array(memory.buffer, at, length));
    case 3:
      return number();
    case 4:
      return number() === 1;
    default:
      return [];
  }
}

/** Fills an array with the numbers at an address, some at a time. */
function* copied<Array extends Int32Array | Float64Array>(
  memory: WebAssembly.Memory,
  address: number,
  array: Array,
): SlicedWork<Array> {
  const bytes = new Uint8Array(array.buffer);
  for (let at = 0; at < bytes.length; at += bytesPerStep) {
    if (at > 0) yield 1;
    // The memory's buffer is asked for anew each time: growing replaces it.
    const part = Math.min(bytesPerStep, bytes.length - at);
    bytes.set(new Uint8Array(memory.buffer, address + at, part), at);
  }
  return array;
}
