// SPDX-License-Identifier: MIT
//
// Checks of what callers pass. Each names the argument, says what it is, and what it should be.

import { invalidArgument, outOfMemory } from '../api/errors.js';
import type { CompiledModule, TaskOptions } from '../api/options.js';

/** The default of every option; undefined for an option without one, or that has to be given. */
export type DefaultsOf<Options> = { [Name in keyof Required<Options>]: Options[Name] | undefined };
/** Options with defaults filled in: only those without a default may be undefined. */
export type Complete<Options, Defaults> = {
  [Name in keyof Defaults & keyof Options]: undefined extends Defaults[Name]
    ? Options[Name]
    : Exclude<Options[Name], undefined>;
};

/**
 * The options of a call, with defaults for those left out. Refuses one that the call does not know.
 */
export function toOptions<Options extends object, const Defaults extends DefaultsOf<Options>>(
  options: Options | undefined,
  defaults: Defaults,
): Complete<Options, Defaults> {
  const given = options ?? {};
  if (options === null || !isObject(given) || Array.isArray(given))
    throw invalidArgument(`options is ${show(options)}, not an object`);
  const known = Object.keys(defaults);
  const unknownName = Object.keys(given)
    .find((name) => !known.includes(name))
    ?.slice(0, 40);
  if (unknownName !== undefined) {
    const nearest = nearestName(unknownName, known);
    throw invalidArgument(
      `there is no option ${show(unknownName)} here: ` +
        (nearest === undefined
          ? `there ${known.length === 1 ? 'is only' : 'are'} ${known.join(', ')}`
          : `the nearest is ${show(nearest)}`),
    );
  }
  const values = Object.entries(defaults).map(([name, value]) => {
    const own = given[name];
    return [name, own === undefined ? value : own];
  });
  return Object.fromEntries(values) as Complete<Options, Defaults>;
}

/** The options of a task, checked likewise: every task also has `onProgress` and `signal`. */
export function toTaskOptions<
  Options extends TaskOptions,
  const Defaults extends DefaultsOf<Omit<Options, keyof TaskOptions>>,
>(options: Options | undefined, defaults: Defaults): Complete<Options, Defaults> & TaskOptions {
  const all = toOptions<TaskOptions, DefaultsOf<TaskOptions>>(options, {
    ...defaults,
    onProgress: undefined,
    signal: undefined,
  });
  const { onProgress, signal } = all;
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw invalidArgument(`onProgress is ${show(onProgress)}, not a function`);
  if (signal !== undefined && !isA(signal, 'AbortSignal'))
    throw invalidArgument(`signal is ${show(signal)}, not an AbortSignal`);
  return all as Complete<Options, Defaults> & TaskOptions;
}

/** The options of a call that takes only those of a task. */
export function toTask(options: TaskOptions | undefined): TaskOptions {
  return toTaskOptions(options, {});
}

/** The classes of the language and the platform that are told apart here. */
interface Kinds {
  AbortSignal: AbortSignal;
  ArrayBuffer: ArrayBuffer;
  BigInt64Array: BigInt64Array;
  BigUint64Array: BigUint64Array;
  Object: Record<string, unknown>;
  Promise: Promise<unknown>;
  Response: Response;
  Uint8Array: Uint8Array;
  URL: URL;
  'WebAssembly.Module': CompiledModule;
}

/** `instanceof`, also for objects of other frames, which are no instances of this frame's class. */
export function isA<Kind extends keyof Kinds>(value: unknown, kind: Kind): value is Kinds[Kind] {
  return Object.prototype.toString.call(value) === `[object ${kind}]`;
}

export function toFloat64(name: string, values: ArrayLike<number>): Float64Array<ArrayBuffer> {
  requireNumbers(name, values);
  return copied(name, () => new Float64Array(values));
}

export function toInt32(name: string, values: ArrayLike<number>): Int32Array<ArrayBuffer> {
  requireNumbers(name, values);
  const integers = copied(name, () => new Int32Array(values));
  if (values instanceof Int32Array) return integers;
  for (let i = 0; i < integers.length; ++i) {
    if (integers[i] !== values[i])
      throw invalidArgument(`${name}[${i}] is ${show(values[i])}, not an index`);
  }
  return integers;
}

/** A copy of an array, which fails if the array was transferred, or if there is no memory for it. */
function copied<Copy>(name: string, copy: () => Copy): Copy {
  try {
    return copy();
  } catch (cause) {
    if (cause instanceof RangeError) throw outOfMemory(cause);
    if (!(cause instanceof TypeError)) throw cause;
    throw invalidArgument(`${name} is an array that was transferred: it has no numbers any more`);
  }
}

/** Arrays of numbers, typed or not. */
function requireNumbers(name: string, values: ArrayLike<number>): void {
  const isTyped = ArrayBuffer.isView(values) && 'length' in values;
  if (!(isTyped || Array.isArray(values)) || isBigInts(values)) {
    // JSON has no typed arrays.
    const isStringified = isObject(values) && '0' in values && !isBigInts(values);
    throw invalidArgument(
      `${name} is ${show(values)}, not an array of numbers` +
        (isStringified ? ': pointsJson gives points a form for JSON' : ''),
    );
  }
  if (isTyped) return;
  for (let i = 0; i < values.length; ++i) {
    if (Array.isArray(values[i]))
      throw invalidArgument(`${name}[${i}] is a list: all numbers go into one flat list`);
    if (typeof values[i] !== 'number')
      throw invalidArgument(`${name}[${i}] is ${show(values[i])}, not a number`);
  }
}

function isBigInts(values: unknown): boolean {
  return isA(values, 'BigInt64Array') || isA(values, 'BigUint64Array');
}

/** A result of this library that is passed back to it: an object with at least these fields. */
export function toResult<Result extends object>(
  name: string,
  value: Result,
  ...fields: (keyof Result & string)[]
): Result {
  if (!isObject(value)) throw invalidArgument(`${name} is ${show(value)}, not an object`);
  if (isA(value, 'Promise')) throw invalidArgument(`${name} is a promise: await it`);
  const missing = fields.find((field) => !isObject(value[field]));
  if (missing === undefined) return value;
  if (value[missing] !== undefined)
    throw invalidArgument(
      `${name}.${missing} is ${show(value[missing])}, not an object or an array`,
    );
  throw invalidArgument(`${name} has no ${missing}: it needs ${fields.join(', ')}`);
}

export function requireBytes(name: string, bytes: Uint8Array): void {
  if (!isA(bytes, 'Uint8Array'))
    throw invalidArgument(`${name} is ${show(bytes)}, not a Uint8Array`);
}

/** The name at the least Levenshtein distance, unless more than a third of the letters differ. */
export function nearestName(name: string, names: readonly string[]): string | undefined {
  const distances = names.map((other) => letterDistance(name.toLowerCase(), other.toLowerCase()));
  const least = Math.min(...distances);
  const nearest = names[distances.indexOf(least)];
  return 3 * least <= Math.max(name.length, nearest.length) ? nearest : undefined;
}

/** The Levenshtein distance, row by row. */
function letterDistance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j) {
      const replaced = row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j] + 1, next[j - 1] + 1));
    }
    row = next;
  }
  return row[b.length];
}

/** Whether a value has fields, of which nothing is known yet. */
export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null;
}

/** How much of a string a sentence shows: it may be the content of a file. */
const mostLetters = 60;

/** A value as a sentence shows it. */
export function show(value: unknown): string {
  if (typeof value === 'string')
    return JSON.stringify(value.length > mostLetters ? `${value.slice(0, mostLetters)}…` : value);
  if (typeof value === 'function') return 'a function';
  if (typeof value === 'bigint') return `${value}n`;
  if (!isObject(value)) return String(value);
  const kind = value.constructor;
  return `of type ${(typeof kind === 'function' && kind.name) || 'object'}`;
}
