// SPDX-License-Identifier: MIT
//
// Checks the form of what callers pass, and copies it. Whether it makes sense on the surface is
// checked by the core.

import { isA, isObject, show, toFloat64, toInt32 } from '../base/checks.js';
import {
  boolean,
  integers,
  length,
  oneOf,
  positive,
  requireAllowed,
  share,
  string,
  type Rule,
} from '../base/rules.js';
import type { FileInput } from '../input/read_model.js';
import { invalidArgument } from '../api/errors.js';
import {
  cvtMethods,
  metrics,
  orientations,
  samplings,
  worstRegions,
  type Sampling,
  type SurfacePoints,
  type WorstRegion,
} from '../api/results.js';
import type { Triangles } from '../base/triangles.js';
import {
  gltfLimitNames,
  type Density,
  type GltfLimits,
  type MeshArrays,
  type MeshOptions,
  type MeshSource,
  type ModelFile,
  type ModelFiles,
  type SurfacePointsInput,
  type ThreeAttribute,
  type ThreeGeometry,
} from '../api/options.js';
import { counted, integer } from '../base/sentences.js';

/** Each level about doubles the segments: ten levels make a thousand of one. */
export const maxDetail = 10;

/** The core counts in 32 bits. */
export const maxCount = 2 ** 31 - 1;

/** A module's memory has no more bytes than this. */
const maxBytes = 2 ** 32 - 1;

/** The limits of the glTF reader. */
export const limitRule = integers(0, maxBytes);

const counts = integers(0, maxCount);
const positiveCounts = integers(1, maxCount);

/** What options and arguments may be, by their names. */
export const rules = {
  maxEdge: share,
  weld: share,
  orientation: oneOf(orientations),
  minComponent: counts,
  metric: oneOf(metrics),
  detail: integers(0, maxDetail),
  count: positiveCounts,
  radius: positive,
  seed: integers(0, Number.MAX_SAFE_INTEGER),
  sampling: oneOf([...samplings, ...worstRegions]),
  perComponent: counts,
  method: oneOf(cvtMethods),
  iterations: counts,
  energyTolerance: share,
  moveTolerance: length,
  data: boolean,
  diagrams: boolean,
  maxAdded: counts,
  samples: positiveCounts,
  leaveOutIndifferent: boolean,
  leaveOutUnreachable: boolean,
  primal: boolean,
  label: counts,
  worst: oneOf(worstRegions),
} as const satisfies Record<string, Rule>;

type Unruled<Values> = Exclude<keyof Values, keyof typeof rules>;

/** Options and arguments, each checked by the rule of its name. */
export function checked<Values extends object>(
  values: Values & Record<Unruled<Values>, never>,
): Values {
  for (const [name, value] of Object.entries(values))
    requireAllowed(name, value, rules[name as keyof typeof rules]);
  return values;
}

export const meshDefaults = {
  limits: {},
  file: undefined,
  maxEdge: 0,
  weld: 0,
  orientation: orientations[0],
  minComponent: 0,
} as const;

export const diagramDefaults = { metric: metrics[0], detail: 0 } as const;

/** The default of `sampling` depends on whether a radius is given. */
export const samplingDefaults = { seed: 1, perComponent: 0, density: [] } as const;

/** The triangles of a mesh, or the files to read them from. */
export function toMeshInput(
  source: MeshSource,
  { limits, file }: Pick<MeshOptions, 'file'> & { limits: GltfLimits },
): Triangles | FileInput {
  const reading = { limits: toLimits(limits), file: toFileName(file) };
  if (isThreeGeometry(source)) return toTriangles(arraysOf(source));
  return isMeshArrays(source) ? toTriangles(source) : { files: toFiles(source), ...reading };
}

/** Without indices, bytes may also be a file of that name. */
function isMeshArrays(source: MeshSource): source is MeshArrays {
  if (!isObject(source) || !('positions' in source)) return false;
  return 'indices' in source || !isModelFile(source.positions);
}

function isThreeGeometry(source: MeshSource): source is ThreeGeometry {
  return isObject(source) && 'isBufferGeometry' in source;
}

function arraysOf({ attributes, index }: ThreeGeometry): MeshArrays {
  const { position, normal, uv } = attributes ?? {};
  return {
    positions: valuesOf('position', position, 3),
    indices: index ? valuesOf('index', index, 1) : undefined,
    normals: normal && valuesOf('normal', normal, 3),
    uvs: uv && valuesOf('uv', uv, 2),
  };
}

/** The first numbers of each vertex, `size` of them, wherever they are stored and in which unit. */
function valuesOf(name: string, given: object, size: number): Float64Array {
  const getters = (['getX', 'getY', 'getZ'] as const).slice(0, size);
  const attribute = given as ThreeAttribute;
  if (!isObject(attribute) || getters.some((get) => typeof attribute[get] !== 'function'))
    throw invalidArgument(
      `the geometry's ${name} is ${show(attribute)}, not an attribute of three.js`,
    );
  const mostThatFit = Math.floor(maxBytes / (size * Float64Array.BYTES_PER_ELEMENT));
  requireAllowed(`the geometry's ${name}.count`, attribute.count, integers(0, mostThatFit));
  const values = new Float64Array(size * attribute.count);
  for (let i = 0; i < values.length; ++i)
    values[i] = attribute[getters[i % size]](Math.floor(i / size));
  return values;
}

/** The path of the model to open, if one is given. */
export function toFileName(file: string | undefined): string | undefined {
  if (file !== undefined) requireAllowed('file', file, string);
  return file;
}

function toTriangles(source: MeshArrays): Triangles {
  const { positions: places, indices, normals, uvs, density } = source;
  const positions = toFloat64('positions', places);
  if (indices === undefined) {
    requireNoOtherIndices(source);
    if (positions.length % 9 !== 0)
      throw invalidArgument(
        `positions has ${counted(positions.length, 'number')}: without indices, every triangle needs nine`,
      );
  }
  return {
    positions,
    indices:
      indices === undefined
        ? new Int32Array(positions.length / 3).map((_, v) => v)
        : toInt32('indices', indices),
    normals: toAttribute('normals', normals, positions.length),
    uvs: toAttribute('uvs', uvs, (positions.length / 3) * 2),
    density: toAttribute('density', density, positions.length / 3),
  };
}

/** Indices by another name would be missed in silence, and every three vertices be a triangle. */
function requireNoOtherIndices(source: MeshArrays): void {
  const known = ['positions', 'indices', 'normals', 'uvs', 'density'];
  const unknownName = Object.keys(source).find((name) => !known.includes(name));
  if (unknownName === undefined) return;
  throw invalidArgument(
    `positions come with ${show(unknownName)}, but without indices: the fields are ${known.join(', ')}`,
  );
}

export function toFiles(source: unknown): ModelFiles {
  if (isModelFile(source)) return { '': source };
  if (isA(source, 'ArrayBuffer')) return { '': toBytes(source) };
  const advice = adviceOn(source);
  if (isA(source, 'Object') && advice === '') {
    const files = { ...source };
    if (Object.values(files).every(isModelFile)) return files as ModelFiles;
  }
  throw invalidArgument(
    `a mesh is made from the bytes of a file, from files by their paths, or from { positions, indices }; this is ${show(source)}${advice}`,
  );
}

/** All bytes of a buffer, which has none any more if it was transferred. */
function toBytes(buffer: ArrayBuffer): Uint8Array {
  try {
    return new Uint8Array(buffer);
  } catch {
    throw invalidArgument('the bytes of the file were transferred: there are none any more');
  }
}

/** What is nearly a mesh: a file's text, address, stream or bytes to come, or an object of three.js. */
function adviceOn(source: unknown): string {
  if (typeof source === 'string' && source.includes('\n')) return ': encode it as bytes';
  if (typeof source === 'string' || isA(source, 'URL')) return ': fetch or read the file';
  if (isA(source, 'Promise')) return ': await it';
  if (isObject(source) && 'isMesh' in source) return ': pass its geometry';
  if (isObject(source) && Symbol.asyncIterator in source)
    return ': await new Response(stream).arrayBuffer()';
  return '';
}

function isModelFile(value: unknown): value is ModelFile {
  if (isA(value, 'Uint8Array')) return true;
  return isObject(value) && 'arrayBuffer' in value && typeof value.arrayBuffer === 'function';
}

function toLimits(limits: GltfLimits): GltfLimits {
  if (!isObject(limits)) throw invalidArgument(`limits is ${show(limits)}, not an object`);
  const given = Object.entries(limits).filter(([, most]) => most !== undefined);
  for (const [name, most] of given) {
    requireAllowed('the name of a limit', name, oneOf(gltfLimitNames));
    requireAllowed(`limits.${name}`, most, limitRule);
  }
  return Object.fromEntries(given);
}

/** Points by triangles and coordinates, by vertices, or by places in space, as copies. */
export type GivenPoints = SurfacePoints | { vertex: Int32Array } | { position: Float64Array };

export function toPoints(name: string, points: SurfacePointsInput): GivenPoints {
  if (isObject(points)) {
    requireOneForm(name, points);
    if ('vertex' in points) return { vertex: toIndices(`${name}.vertex`, points.vertex) };
    if ('face' in points && 'bary' in points) return toBarycentric(name, points);
    if ('position' in points) return { position: toPlaces(`${name}.position`, points.position) };
  }
  throw invalidArgument(`${name} is ${notPoints(points)}`);
}

/** One point. */
export function toPoint(name: string, point: SurfacePointsInput): GivenPoints {
  const points = toPoints(name, point);
  const count =
    'vertex' in points
      ? points.vertex.length
      : 'position' in points
        ? points.position.length / 3
        : points.face.length;
  if (count === 1) return points;
  throw invalidArgument(`${name} is a list of ${integer(count)} points where one is needed`);
}

/** Refuses vertices beside another form. Triangles may come with the places of the same points. */
function requireOneForm(name: string, points: object): void {
  const other = ['face', 'bary', 'position'].find((form) => form in points);
  if ('vertex' in points && other !== undefined)
    throw invalidArgument(
      `${name} has both vertex and ${other}: only one can say where points are`,
    );
}

/** Says what a value is that is no points. */
function notPoints(value: unknown): string {
  if (isA(value, 'Promise')) return 'a promise: await it';
  if (isObject(value) && Symbol.asyncIterator in value)
    return 'what cvt gives: loop over it, and pass the sites of a state';
  if (isObject(value) && 'sites' in value) return 'a result: pass its sites';
  return (
    `${show(value)}, not points: { face: [i, …], bary: [b0, b1, b2, …] }, { vertex: [i, …] } ` +
    'or { position: [x, y, z, …] }'
  );
}

function toBarycentric(
  name: string,
  points: Extract<SurfacePointsInput, { face: unknown }>,
): SurfacePoints {
  const face = toIndices(`${name}.face`, points.face);
  const bary = toFloat64(`${name}.bary`, points.bary);
  if (bary.length === 3 * face.length) return { face, bary };
  throw invalidArgument(
    `${name}.bary has ${counted(bary.length, 'number')}, not ${integer(3 * face.length)}: three for each of ${name}.face`,
  );
}

function toIndices(name: string, indices: number | ArrayLike<number>): Int32Array<ArrayBuffer> {
  return toInt32(name, typeof indices === 'number' ? [indices] : indices);
}

/** Places in space: three finite numbers each. */
export function toPlaces(name: string, positions: ArrayLike<number>): Float64Array {
  const numbers = toFloat64(name, positions);
  if (numbers.length % 3 !== 0)
    throw invalidArgument(`${name} has ${counted(numbers.length, 'number')}, not three per place`);
  const wrong = numbers.findIndex((x) => !Number.isFinite(x));
  if (wrong < 0) return numbers;
  throw invalidArgument(`${name}[${wrong}] is ${numbers[wrong]}, not a finite number`);
}

/** Numbers per vertex, or none. */
function toAttribute(name: string, values: ArrayLike<number> = [], expected: number): Float64Array {
  const numbers = toFloat64(name, values);
  if (numbers.length === 0 || numbers.length === expected) return numbers;
  throw invalidArgument(
    `${name} has ${counted(numbers.length, 'number')}, not ${integer(expected)}`,
  );
}

export function isWorstFirst(sampling: Sampling): sampling is WorstRegion {
  return worstRegions.some((name) => name === sampling);
}

export const tessellationDefaults = {
  method: 'lbfgs',
  metric: diagramDefaults.metric,
  iterations: 50,
  energyTolerance: 0,
  moveTolerance: 0,
  density: [],
  fixedSites: [],
} as const;

/** A density as it was given: numbers, as a copy, or that of the curvature, which is computed later. */
export type GivenDensity = Float64Array | 'curvature';

/** `attribute` is the density that the mesh came with. */
export function toDensity(density: Density, attribute: Float64Array): GivenDensity {
  if (density === 'curvature') return density;
  if (typeof density === 'string' && density !== 'attribute')
    throw invalidArgument(
      `density is ${show(density)}, not "attribute", "curvature" or an array of numbers`,
    );
  const numbers = density === 'attribute' ? attribute : toFloat64('density', density);
  if (density === 'attribute' && numbers.length === 0)
    throw invalidArgument(
      'the mesh came without a density: a glTF has it as the vertex attribute _DENSITY, a PLY as the property density, arrays as density',
    );
  if (numbers.length > 0 && numbers.every((x) => x === 0))
    throw invalidArgument('the density is zero all over the surface');
  return numbers;
}

/** The options of a repair unless others are given. */
export const repairDefaults = { maxAdded: 1000 };
