// SPDX-License-Identifier: MIT
//
// Checks of what callers pass. Each names the argument, says what it is, and what it should be.

import type { AttributeSource } from './attributes.js';
import { invalidArgument } from './errors.js';
import type { TaskOptions } from './types.js';

/** Options, none if they are left out. */
export function toOptions<Options extends object>(options: Options | undefined): Options {
  if (options === undefined) return {} as Options;
  if (isObject(options) && !Array.isArray(options)) return options;
  throw invalidArgument(`options is ${show(options)}, not an object`);
}

export function toTask(options: TaskOptions | undefined): TaskOptions {
  const { onProgress, signal } = toOptions(options);
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw invalidArgument(`onProgress is ${show(onProgress)}, not a function`);
  if (signal !== undefined && !isSignal(signal))
    throw invalidArgument(`signal is ${show(signal)}, not an AbortSignal`);
  return { onProgress, signal };
}

/** Also one of another realm. */
function isSignal(value: unknown): value is AbortSignal {
  return Object.prototype.toString.call(value) === '[object AbortSignal]';
}

export function toOneOf<Name extends string>(
  what: string,
  name: Name,
  names: readonly Name[],
): Name {
  if (names.includes(name)) return name;
  throw invalidArgument(`${what} is ${show(name)}, not one of ${names.join(', ')}`);
}

export function toBoolean(name: string, value: boolean): boolean {
  if (typeof value === 'boolean') return value;
  throw invalidArgument(`${name} is ${show(value)}, not true or false`);
}

export function toInteger(name: string, value: number, least: number, most: number): number {
  if (Number.isInteger(value) && value >= least && value <= most) return value;
  throw invalidArgument(`${name} is ${show(value)}, not an integer from ${least} to ${most}`);
}

/** Colours as linear RGB; one that is left out is undefined. */
export function toColours(
  name: string,
  colours: readonly (readonly number[] | undefined)[],
): readonly (readonly number[] | undefined)[] {
  if (!Array.isArray(colours)) throw invalidArgument(`${name} is ${show(colours)}, not a list`);
  for (const [i, colour] of colours.entries()) {
    const isColour =
      Array.isArray(colour) &&
      colour.length === 3 &&
      colour.every((x) => typeof x === 'number' && x >= 0 && x <= 1);
    if (!isColour && colour !== undefined) {
      throw invalidArgument(
        `${name}[${i}] is ${show(colour)}, not a list of three numbers from 0 to 1`,
      );
    }
  }
  return colours;
}

export function toFloat64(name: string, values: ArrayLike<number>): Float64Array {
  requireNumbers(name, values);
  return new Float64Array(values);
}

export function toInt32(name: string, values: ArrayLike<number>): Int32Array {
  requireNumbers(name, values);
  const integers = new Int32Array(values);
  for (let i = 0; i < integers.length; ++i) {
    if (integers[i] !== values[i])
      throw invalidArgument(`${name}[${i}] is ${show(values[i])}, not an index`);
  }
  return integers;
}

/** Arrays of numbers, typed or not. */
function requireNumbers(name: string, values: ArrayLike<number>): void {
  const isTyped = ArrayBuffer.isView(values) && 'length' in values;
  if (!(isTyped || Array.isArray(values)) || isBigInts(values))
    throw invalidArgument(`${name} is ${show(values)}, not an array of numbers`);
  if (isTyped) return;
  for (let i = 0; i < values.length; ++i) {
    if (typeof values[i] !== 'number')
      throw invalidArgument(`${name}[${i}] is ${show(values[i])}, not a number`);
  }
}

function isBigInts(values: unknown): boolean {
  return values instanceof BigInt64Array || values instanceof BigUint64Array;
}

/** Something that this library gave out: at least an object with its fields. */
export function toResult<Result extends object>(
  name: string,
  value: Result,
  ...fields: (keyof Result & string)[]
): Result {
  if (!isObject(value)) throw invalidArgument(`${name} is ${show(value)}, not an object`);
  const missing = fields.find((field) => !isObject(value[field]));
  if (missing === undefined) return value;
  throw invalidArgument(`${name}.${missing} is ${show(value[missing])}, not an object`);
}

/** What lengths are multiplied with. */
export function toScale(scale: number): number {
  if (Number.isFinite(scale) && scale > 0) return scale;
  throw invalidArgument(`scale is ${show(scale)}, not a positive number`);
}

/** The options of a file's writer. */
export function toFileOptions<Options extends { mesh?: AttributeSource; scale?: number }>(
  options: Options | undefined,
): Options & { scale: number } {
  const { mesh, scale = 1 } = toOptions(options);
  if (mesh !== undefined) toAttributeSource(mesh);
  return { ...(options as Options), scale: toScale(scale) };
}

export function toAttributeSource(mesh: AttributeSource): AttributeSource {
  return toResult('mesh', mesh, 'positions', 'indices', 'normals', 'uvs');
}

export function requireBytes(name: string, bytes: Uint8Array): void {
  if (!(bytes instanceof Uint8Array))
    throw invalidArgument(`${name} is ${show(bytes)}, not a Uint8Array`);
}

export function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null;
}

/** A value as a sentence shows it. */
export function show(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'function') return 'a function';
  if (typeof value === 'bigint') return `${value}n`;
  if (!isObject(value)) return String(value);
  const kind = value.constructor;
  return `of type ${(typeof kind === 'function' && kind.name) || 'object'}`;
}
