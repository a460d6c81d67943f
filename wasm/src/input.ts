// SPDX-License-Identifier: MIT
//
// What callers pass, checked in form and copied. Whether it makes sense on the surface is for the
// core to say.

import { cvtMethods, metrics, samplings, type CvtSettings } from './core.js';
import type { GltfFile } from './engine.js';
import { GeodesicVoronoiError } from './errors.js';
import type { Triangles } from './triangles.js';
import type {
  CvtOptions,
  GltfResources,
  MeshSource,
  Metric,
  PartitionOptions,
  Sampling,
  SurfacePoints,
  SurfacePointsInput,
} from './types.js';

/** Each level doubles the segments; ten of them turn a face into a million. */
export const maxDetail = 10;

/** The core counts in 32 bits. */
export const maxCount = 2 ** 31 - 1;

export function toTriangles(
  source: MeshSource,
  resources: GltfResources = {},
): Triangles | GltfFile {
  if (source instanceof Uint8Array) return { bytes: source, resources };
  if (source instanceof ArrayBuffer) return { bytes: new Uint8Array(source), resources };
  if (isObject(source) && 'positions' in source && 'indices' in source) {
    const positions = toFloat64('positions', source.positions);
    return {
      positions,
      indices: toInt32('indices', source.indices),
      normals: toAttribute('normals', source.normals, positions.length),
      uvs: toAttribute('uvs', source.uvs, (positions.length / 3) * 2),
    };
  }
  throw invalidArgument(
    'a mesh is made from the bytes of a glTF file or from {positions, indices}',
  );
}

/** A list of points, as faces and coordinates of the same length or as vertices. */
export function toPoints(
  name: string,
  points: SurfacePointsInput,
): SurfacePoints | { vertex: Int32Array } {
  if (isObject(points) && 'vertex' in points)
    return { vertex: toInt32(`${name}.vertex`, points.vertex) };
  if (!isObject(points) || !('face' in points) || !('bary' in points)) {
    throw invalidArgument(`${name} is a list of points: {face, bary} or {vertex}`);
  }
  const face = toInt32(`${name}.face`, points.face);
  const bary = toFloat64(`${name}.bary`, points.bary);
  if (bary.length !== 3 * face.length) {
    throw invalidArgument(
      `${name}.bary has ${bary.length} numbers: the ${face.length} points of ${name}.face need three each`,
    );
  }
  return { face, bary };
}

/** Numbers per vertex, or none. */
function toAttribute(
  name: string,
  values: ArrayLike<number> = [],
  expected: number,
): Float64Array {
  const numbers = toFloat64(name, values);
  if (numbers.length === 0 || numbers.length === expected) return numbers;
  throw invalidArgument(`${name} has ${numbers.length} numbers, not ${expected}`);
}

export function toMetric(metric: Metric): Metric {
  return toOneOf('metric', metric, metrics);
}

export function toSampling(sampling: Sampling): Sampling {
  return toOneOf('sampling', sampling, samplings);
}

/** Whether density and fixed sites fit mesh and sites is for the core to say. */
export function toCvtSettings({
  method = 'lbfgs',
  metric = metrics[0],
  iterations = 50,
  energyTolerance = 0,
  moveTolerance = 0,
  density = [],
  fixedSites = [],
}: CvtOptions): CvtSettings {
  return {
    method: toOneOf('method', method, cvtMethods),
    metric: toMetric(metric),
    iterations: toInteger('iterations', iterations, 0, maxCount),
    energyTolerance: toTolerance('energyTolerance', energyTolerance),
    moveTolerance: toTolerance('moveTolerance', moveTolerance),
    density: toFloat64('density', density),
    fixedSites: toInt32('fixedSites', fixedSites),
  };
}

function toTolerance(name: string, value: number): number {
  if (typeof value === 'number' && value >= 0) return value;
  throw invalidArgument(`${name} is ${show(value)}, not a number from 0`);
}

function toOneOf<Name extends string>(what: string, name: Name, names: readonly Name[]): Name {
  if (names.includes(name)) return name;
  throw invalidArgument(`${what} is ${show(name)}, not one of ${names.join(', ')}`);
}

export function toPartitionOptions({
  leaveOutIndifferent = false,
  leaveOutUnreachable = false,
}: PartitionOptions): Required<PartitionOptions> {
  return { leaveOutIndifferent, leaveOutUnreachable };
}

export function toMaxAdded(maxAdded: number): number {
  return toInteger('maxAdded', maxAdded, 0, maxCount);
}

export function toDetail(detail: number): number {
  return toInteger('detail', detail, 0, maxDetail);
}

export function toCount(count: number): number {
  return toInteger('count', count, 1, maxCount);
}

export function toLabel(label: number): number {
  return toInteger('label', label, 0, maxCount);
}

export function toSeed(seed: number): number {
  return toInteger('seed', seed, 0, Number.MAX_SAFE_INTEGER);
}

function toInteger(name: string, value: number, least: number, most: number): number {
  if (Number.isInteger(value) && value >= least && value <= most) return value;
  throw invalidArgument(`${name} is ${show(value)}, not an integer from ${least} to ${most}`);
}

function toFloat64(name: string, values: ArrayLike<number>): Float64Array {
  requireList(name, values);
  return new Float64Array(values);
}

function toInt32(name: string, values: ArrayLike<number>): Int32Array {
  requireList(name, values);
  const integers = new Int32Array(values);
  for (let i = 0; i < integers.length; ++i) {
    if (integers[i] !== values[i]) {
      throw invalidArgument(`${name}[${i}] is ${show(values[i])}, not an index`);
    }
  }
  return integers;
}

function requireList(name: string, values: unknown): void {
  const isList = Array.isArray(values) || (ArrayBuffer.isView(values) && 'length' in values);
  if (!isList) throw invalidArgument(`${name} is ${show(values)}, not an array of numbers`);
}

function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null;
}

function show(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  return isObject(value) ? `of type ${value.constructor?.name ?? 'object'}` : String(value);
}

function invalidArgument(message: string): GeodesicVoronoiError {
  return new GeodesicVoronoiError('invalid-argument', message);
}
