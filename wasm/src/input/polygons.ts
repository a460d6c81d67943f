// SPDX-License-Identifier: MIT
//
// Polygons of a file, cut into triangles. Every side of a polygon stays a side of one of its triangles,
// also where corners lie in a line: else the faces beside it would not fit any more.

import earcut from 'earcut';
import type { SlicedWork } from '../slices.js';
import { GrowingArray } from './growing_array.js';
import { requireCorners, requireTriangles, type SizeLimits } from './limits.js';

export class Polygons {
  readonly #limits: SizeLimits;
  /** All corners, polygon after polygon, and where each one's end. */
  readonly #corners = new GrowingArray(Int32Array);
  readonly #ends = new GrowingArray(Int32Array);
  #lastEnd = 0;
  #triangles = 0;

  constructor(limits: SizeLimits) {
    this.#limits = limits;
  }

  get count(): number {
    return this.#ends.length;
  }

  addCorner(vertex: number): void {
    this.#corners.push(vertex);
    requireCorners(this.#corners.length - this.#lastEnd);
  }

  /** Ends a polygon of three corners at least. */
  endPolygon(): void {
    const size = this.#corners.length - this.#lastEnd;
    this.#triangles += size - 2;
    requireTriangles(this.#triangles, this.#limits);
    this.#lastEnd = this.#corners.length;
    this.#ends.push(this.#lastEnd);
  }

  /** Gives up three vertices per triangle, and a sentence about what was cut. */
  *take(positions: Float64Array): SlicedWork<{ indices: Int32Array; notes: string[] }> {
    const corners = yield* this.#corners.take();
    if (this.#triangles === this.#ends.length) return { indices: corners, notes: [] };
    const indices = new Int32Array(3 * this.#triangles);
    let at = 0;
    let cut = 0;
    let start = 0;
    for (const end of yield* this.#ends.take()) {
      yield 1;
      const polygon = corners.subarray(start, end);
      const triangles = polygon.length === 3 ? polygon : cutPolygon(polygon, positions);
      indices.set(triangles, at);
      at += triangles.length;
      cut += polygon.length === 3 ? 0 : 1;
      start = end;
    }
    const what = cut === 1 ? '1 polygon was' : `${cut} polygons were`;
    return { indices, notes: cut > 0 ? [`${what} cut into triangles`] : [] };
  }
}

/** The vertices of the triangles of a polygon: always two fewer than it has corners. */
function cutPolygon(polygon: Int32Array, positions: Float64Array): Int32Array {
  const places = projected(polygon, positions);
  const fan = fanOf(polygon.length);
  if (isUpright(fan, places)) return fan.map((corner) => polygon[corner]);
  const ears = Int32Array.from(earcut(places));
  // Fewer are left where the polygon crosses itself or is flat: then a fan is as good as anything.
  const corners = ears.length === fan.length ? turned(ears, places) : fan;
  return corners.map((corner) => polygon[corner]);
}

/** All triangles at the first corner. */
function fanOf(count: number): Int32Array {
  return Int32Array.from({ length: 3 * (count - 2) }, (_, i) =>
    i % 3 === 0 ? 0 : Math.floor(i / 3) + (i % 3),
  );
}

/** x and y of each corner in a plane in which the polygon is counterclockwise, if it is planar. */
function projected(polygon: Int32Array, positions: Float64Array): Float64Array {
  const normal = [0, 0, 0]; // by Newell's formula: of corners that are not in a plane, the mean one
  const first = 3 * polygon[0];
  for (let i = 0; i < polygon.length; ++i) {
    const p = 3 * polygon[i];
    const q = 3 * polygon[(i + 1) % polygon.length];
    for (let k = 0; k < 3; ++k) {
      const [y, z] = [(k + 1) % 3, (k + 2) % 3];
      const height = positions[p + z] + positions[q + z] - 2 * positions[first + z];
      normal[k] += (positions[p + y] - positions[q + y]) * height;
    }
  }
  const sizes = normal.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const others = [(axis + 1) % 3, (axis + 2) % 3];
  if (normal[axis] < 0) others.reverse();
  return Float64Array.from(
    { length: 2 * polygon.length },
    (_, i) => positions[3 * polygon[i >> 1] + others[i % 2]],
  );
}

function isUpright(triangles: Int32Array, places: Float64Array): boolean {
  for (let t = 0; t < triangles.length; t += 3) if (!(area(triangles, t, places) > 0)) return false;
  return true;
}

/** Counterclockwise, as the polygon is. */
function turned(triangles: Int32Array, places: Float64Array): Int32Array {
  for (let t = 0; t < triangles.length; t += 3) {
    if (area(triangles, t, places) >= 0) continue;
    [triangles[t + 1], triangles[t + 2]] = [triangles[t + 2], triangles[t + 1]];
  }
  return triangles;
}

/** Twice the signed area. */
function area(triangles: Int32Array, t: number, places: Float64Array): number {
  const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
  return (
    (places[b] - places[a]) * (places[c + 1] - places[a + 1]) -
    (places[c] - places[a]) * (places[b + 1] - places[a + 1])
  );
}
