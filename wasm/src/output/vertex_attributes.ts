// SPDX-License-Identifier: MIT
//
// Normals and texture coordinates of the input, interpolated at points of the surface.

import { invalidArgument } from '../api/errors.js';
import type { AttributeSource } from './file_options.js';
import type { Partition } from '../api/results.js';
import { counted } from '../base/sentences.js';

/** Vertices of a file: the point of each, and its attributes, absent where the input has none. */
export interface FileVertices {
  points: Int32Array;
  normals?: Float32Array;
  uvs?: Float32Array;
}

/** Values at points given by a face and barycentric coordinates. */
class Interpolator {
  readonly #source: AttributeSource;
  /** The values at one point: its normal, then its texture coordinates, if there are any. */
  readonly values: Float32Array;

  constructor(source: AttributeSource) {
    this.#source = source;
    this.values = new Float32Array(
      (source.normals.length > 0 ? 3 : 0) + (source.uvs.length > 0 ? 2 : 0),
    );
  }

  /** Sets `values` to those at the point with coordinates `bary[at] … bary[at + 2]`. */
  moveTo(face: number, bary: Float64Array, at: number): void {
    const { normals, uvs } = this.#source;
    if (3 * face >= this.#source.indices.length)
      throw invalidArgument(
        `mesh has ${counted(this.#source.indices.length / 3, 'triangle')}: it is not the one of the result, which has a point in triangle ${face}`,
      );
    let k = 0;
    if (normals.length > 0) {
      const mean = [0, 1, 2].map((axis) => this.#mean(normals, 3, axis, face, bary, at));
      // Where normals cancel out, or there are none, that of the face.
      const normal = directionOf(mean, 1e-6) ?? directionOf(this.#faceNormal(face)) ?? upward;
      for (const x of normal) this.values[k++] = x;
    }
    if (uvs.length > 0)
      for (const axis of [0, 1])
        this.values[k++] = finite(this.#mean(uvs, 2, axis, face, bary, at));
  }

  #mean(
    values: Float64Array,
    size: number,
    axis: number,
    face: number,
    bary: Float64Array,
    at: number,
  ): number {
    const { indices } = this.#source;
    let sum = 0;
    for (let i = 0; i < 3; ++i) {
      const share = bary[at + i];
      if (share !== 0) sum += share * values[size * indices[3 * face + i] + axis];
    }
    return sum;
  }

  #faceNormal(face: number): number[] {
    const { positions, indices } = this.#source;
    const [a, b, c] = [0, 1, 2].map((i) => {
      const vertex = indices[3 * face + i];
      return positions.subarray(3 * vertex, 3 * vertex + 3);
    });
    const side = (to: Float64Array, axis: number) => to[axis] - a[axis];
    return [0, 1, 2].map((axis) => {
      const [y, z] = [(axis + 1) % 3, (axis + 2) % 3];
      return side(b, y) * side(c, z) - side(b, z) * side(c, y);
    });
  }
}

/** Splits an interpolator's rows into normals and texture coordinates. */
function columnsOf(source: AttributeSource, rows: number[]): Omit<FileVertices, 'points'> {
  const normalSize = source.normals.length > 0 ? 3 : 0;
  const uvSize = source.uvs.length > 0 ? 2 : 0;
  const size = normalSize + uvSize;
  const column = (first: number, width: number) =>
    Float32Array.from(
      { length: (rows.length / size) * width },
      (_, i) => rows[Math.floor(i / width) * size + first + (i % width)],
    );
  return {
    ...(normalSize > 0 && { normals: column(0, normalSize) }),
    ...(uvSize > 0 && { uvs: column(normalSize, uvSize) }),
  };
}

/** A run of triangles of a partition: `first` … `last - 1`. */
export interface TriangleRun {
  first: number;
  last: number;
}

/** The vertices of runs of triangles, one run after the other. */
interface RunVertices {
  vertices: FileVertices;
  /** The vertex of each corner of the partition's triangles. */
  corners: Uint32Array<ArrayBuffer>;
  /** Run i has the vertices `offset[i] … offset[i + 1] - 1`. */
  offset: number[];
}

/**
 * Vertices for each run of triangles. A point has one vertex there, or several on a seam of the
 * input's normals or texture coordinates.
 */
export function partitionVertices(
  { triangles, points }: Partition,
  source: AttributeSource | undefined,
  runs: readonly TriangleRun[],
): RunVertices {
  const interpolator = source && new Interpolator(source);
  const values = interpolator?.values ?? new Float32Array();
  /** Per point the last vertex of the run made there, -1 for none. */
  const newest = new Int32Array(points.face.length).fill(-1);
  /** Per vertex the one before at its point. */
  const before: number[] = [];
  const at: number[] = [];
  const rows: number[] = [];
  const corners = new Uint32Array(triangles.points.length);
  const offset = [0];
  for (const { first, last } of runs) {
    for (let corner = 3 * first; corner < 3 * last; ++corner) {
      const point = triangles.points[corner];
      interpolator?.moveTo(triangles.face[Math.floor(corner / 3)], triangles.bary, 3 * corner);
      let vertex = newest[point];
      while (vertex >= 0 && !values.every((x, k) => x === rows[vertex * values.length + k]))
        vertex = before[vertex];
      if (vertex < 0) {
        vertex = at.length;
        at.push(point);
        before.push(newest[point]);
        newest[point] = vertex;
        rows.push(...values);
      }
      corners[corner] = vertex;
    }
    // Not by a new array: there may be as many runs as points.
    for (let vertex = offset.at(-1)!; vertex < at.length; ++vertex) newest[at[vertex]] = -1;
    offset.push(at.length);
  }
  const columns = source && values.length > 0 ? columnsOf(source, rows) : {};
  return { vertices: { points: Int32Array.from(at), ...columns }, corners, offset };
}

/** The vertices `begin … end - 1`. */
export function someVertices(
  { points, normals, uvs }: FileVertices,
  begin: number,
  end: number,
): FileVertices {
  return {
    points: points.subarray(begin, end),
    ...(normals && { normals: normals.subarray(3 * begin, 3 * end) }),
    ...(uvs && { uvs: uvs.subarray(2 * begin, 2 * end) }),
  };
}

/** One vertex per point. */
export function pointVertices(
  { face, bary }: { face: Int32Array; bary: Float64Array },
  source: AttributeSource | undefined,
): FileVertices {
  const points = Int32Array.from(face, (_, i) => i);
  if (!source || source.normals.length + source.uvs.length === 0) return { points };
  const interpolator = new Interpolator(source);
  const rows: number[] = [];
  for (let i = 0; i < face.length; ++i) {
    interpolator.moveTo(face[i], bary, 3 * i);
    rows.push(...interpolator.values);
  }
  return { points, ...columnsOf(source, rows) };
}

/** The vertices of the input themselves. */
export function inputVertices({ positions, normals, uvs }: AttributeSource): FileVertices {
  const points = Int32Array.from({ length: positions.length / 3 }, (_, i) => i);
  return {
    points,
    ...(normals.length > 0 && { normals: unitVectors(normals) }),
    ...(uvs.length > 0 && { uvs: Float32Array.from(uvs, finite) }),
  };
}

function unitVectors(vectors: Float64Array): Float32Array {
  const units = new Float32Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3)
    units.set(directionOf(vectors.subarray(i, i + 3)) ?? upward, i);
  return units;
}

/** The normal where there is nothing to go by. */
const upward = [0, 0, 1];

/** A vector at length 1; undefined unless it is longer than `least` and finite. */
function directionOf(vector: ArrayLike<number>, least = 0): number[] | undefined {
  const parts = Array.from(vector);
  const length = Math.hypot(...parts);
  return length > least && length < Infinity ? parts.map((x) => x / length) : undefined;
}

/** A number as files have it, of 32 bits; 0 for one that is not finite there. */
function finite(x: number): number {
  const rounded = Math.fround(x);
  return Number.isFinite(rounded) ? rounded : 0;
}
