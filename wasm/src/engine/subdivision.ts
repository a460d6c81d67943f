// SPDX-License-Identifier: MIT
//
// What belongs to vertices and triangles, carried over to subdivided ones.

import type { MeshPart } from '../api/results.js';
import type { Model } from '../input/read_model.js';
import { counted, integer } from '../base/sentences.js';
import type { Subdivision, Triangles } from '../base/triangles.js';

/** The answer of `subdivideMeshArrays` (subdivision.h). */
interface SubdividedArrays extends Pick<Subdivision, 'indices' | 'parents' | 'ends'> {
  /** The given vertices, then the midpoints. */
  positions: Float64Array<ArrayBuffer>;
}

/** A model of the children of its triangles. */
export function subdivided(model: Model, arrays: SubdividedArrays): Model {
  const { triangles, parts, notes, origin } = model;
  const [count, children] = [triangles.indices.length / 3, arrays.indices.length / 3];
  const note = `long edges were halved: ${counted(count, 'triangle')} became ${integer(children)}`;
  return {
    triangles: subdividedTriangles(triangles, arrays),
    parts: subdividedParts(parts, arrays),
    notes: children === count ? notes : [...notes, note],
    origin,
  };
}

/** The children of triangles; attributes of midpoints are the means of those at their ends. */
function subdividedTriangles(
  { positions: { length }, indices: whole, normals, uvs, density }: Triangles,
  { positions, indices, parents, ends }: SubdividedArrays,
): Triangles {
  return {
    positions,
    indices,
    subdivision: { indices, parents, ends, whole, vertexCount: length / 3 },
    normals: unitVectors(extended(normals, 3, ends), normals.length),
    uvs: extended(uvs, 2, ends),
    density: extended(density, 1, ends),
  };
}

/** The primitives of a glTF, with triangles numbered as after subdivision. */
function subdividedParts(parts: readonly MeshPart[], { parents }: SubdividedArrays): MeshPart[] {
  const firstOf = (triangle: number) => firstChildOf(triangle, parents);
  return parts.map((part) => {
    const firstTriangle = firstOf(part.firstTriangle);
    const end = firstOf(part.firstTriangle + part.triangleCount);
    return { ...part, firstTriangle, triangleCount: end - firstTriangle };
  });
}

/** The first child of a triangle: every one has some. Past the last triangle, the number of children. */
export function firstChildOf(triangle: number, parents: Int32Array): number {
  let [low, high] = [0, parents.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (parents[middle] < triangle) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Values per vertex, `size` numbers each, with those of the midpoints. */
export function extended(values: Float64Array, size: number, ends: Int32Array): Float64Array {
  if (values.length === 0) return values;
  const all = new Float64Array(values.length + (size * ends.length) / 2);
  all.set(values);
  for (let i = 0, at = values.length; i < ends.length; i += 2) {
    for (let k = 0; k < size; ++k) {
      all[at++] = (all[size * ends[i] + k] + all[size * ends[i + 1] + k]) / 2;
    }
  }
  return all;
}

/** Gives the vectors from `begin` on the length 1; opposite normals have no mean, and keep 0. */
function unitVectors(vectors: Float64Array, begin: number): Float64Array {
  for (let i = begin; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i], vectors[i + 1], vectors[i + 2]];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    for (let k = i; k < i + 3; ++k) vectors[k] /= length;
  }
  return vectors;
}
