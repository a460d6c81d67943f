// SPDX-License-Identifier: MIT
//
// What callers pass, checked in form and copied. Whether it makes sense on the surface is for the
// core to say.

import { isObject, requireBytes, show, toFloat64, toInt32, toInteger, toOneOf } from './checks.js';
import type { CvtSettings, GltfFile } from './engine.js';
import { invalidArgument } from './errors.js';
import {
  cvtMethods,
  metrics,
  samplings,
  type Metric,
  type Sampling,
  type SurfacePoints,
} from './results.js';
import type { Triangles } from './triangles.js';
import {
  gltfLimitNames,
  type CvtOptions,
  type GltfLimits,
  type GltfResources,
  type MeshOptions,
  type MeshSource,
  type SurfacePointsInput,
} from './types.js';

/** Each level doubles the segments; ten of them turn a face into a million. */
export const maxDetail = 10;

/** The core counts in 32 bits. */
export const maxCount = 2 ** 31 - 1;

/** Of a limit of the glTF reader: its memory has no more bytes than this. */
export const maxLimit = 2 ** 32 - 1;

export function toTriangles(source: MeshSource, options: MeshOptions): Triangles | GltfFile {
  if (source instanceof Uint8Array) return toGltfFile(source, options);
  if (source instanceof ArrayBuffer) return toGltfFile(new Uint8Array(source), options);
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

function toGltfFile(bytes: Uint8Array, { resources = {}, limits = {} }: MeshOptions): GltfFile {
  return { bytes, resources: toResources(resources), limits: toLimits(limits) };
}

function toResources(resources: GltfResources): GltfResources {
  if (!isObject(resources)) throw invalidArgument(`resources is ${show(resources)}, not an object`);
  for (const [uri, bytes] of Object.entries(resources))
    requireBytes(`resources[${show(uri)}]`, bytes);
  return resources;
}

function toLimits(limits: GltfLimits): GltfLimits {
  if (!isObject(limits)) throw invalidArgument(`limits is ${show(limits)}, not an object`);
  for (const [name, most] of Object.entries(limits)) {
    toOneOf('the name of a limit', name, gltfLimitNames);
    toInteger(`limits.${name}`, most, 0, maxLimit);
  }
  return limits;
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
function toAttribute(name: string, values: ArrayLike<number> = [], expected: number): Float64Array {
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
