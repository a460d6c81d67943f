// SPDX-License-Identifier: MIT
//
// Points moved from triangles to the smaller ones that these were subdivided into. Not by their
// places in space: where surfaces touch, other triangles are there, too.

import type { SurfacePoints } from '../api/results.js';
import type { Subdivision } from '../base/triangles.js';
import { firstChildOf } from '../engine/subdivision.js';

type Vector = [number, number, number];

/** One of the smaller triangles. */
interface Child {
  face: number;
  /** The matrix from coordinates in the triangle to those in the child. */
  rows: [Vector, Vector, Vector];
}

/** Each point in the child that it is the farthest inside of. Labels without a site keep face -1. */
export function pointsOnChildren(points: SurfacePoints, subdivision: Subdivision): SurfacePoints {
  const childrenOf = new Map<number, Child[]>();
  const found = { face: points.face.slice(), bary: points.bary.slice() };
  for (const [i, face] of points.face.entries()) {
    const children = childrenOf.get(face) ?? childrenOfTriangle(face, subdivision);
    childrenOf.set(face, children);
    const [x, y, z] = inside(points.bary.subarray(3 * i, 3 * i + 3));
    let deepest = -Infinity;
    for (const child of children) {
      const bary = child.rows.map((row) => row[0] * x + row[1] * y + row[2] * z);
      const depth = Math.min(...bary);
      if (!(depth > deepest)) continue;
      deepest = depth;
      found.face[i] = child.face;
      found.bary.set(bary, 3 * i);
    }
  }
  return found;
}

/** Coordinates without what the tolerance lets be negative: in a small child, that would be more. */
function inside(bary: Float64Array): Float64Array {
  if (bary.every((b) => b >= 0)) return bary;
  const clamped = bary.map((b) => Math.max(b, 0));
  const sum = clamped[0] + clamped[1] + clamped[2];
  return clamped.map((b) => b / sum);
}

function childrenOfTriangle(
  face: number,
  { whole, vertexCount, indices, parents, ends }: Subdivision,
): Child[] {
  const coordinates = new Map<number, Vector>([
    [whole[3 * face], [1, 0, 0]],
    [whole[3 * face + 1], [0, 1, 0]],
    [whole[3 * face + 2], [0, 0, 1]],
  ]);
  const coordinatesOf = (vertex: number): Vector => {
    const known = coordinates.get(vertex);
    if (known) return known;
    const midpoint = 2 * (vertex - vertexCount);
    const [a, b] = [coordinatesOf(ends[midpoint]), coordinatesOf(ends[midpoint + 1])];
    const middle: Vector = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
    coordinates.set(vertex, middle);
    return middle;
  };
  const children: Child[] = [];
  for (let t = firstChildOf(face, parents); parents[t] === face; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => coordinatesOf(indices[3 * t + k]));
    const area = dot(a, cross(b, c)); // of the triangle, the whole of which is 1
    const row = (u: Vector, v: Vector) => cross(u, v).map((w) => w / area) as Vector;
    children.push({ face: t, rows: [row(b, c), row(c, a), row(a, b)] });
  }
  return children;
}

function dot(u: Vector, v: Vector): number {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

function cross(u: Vector, v: Vector): Vector {
  return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
}
