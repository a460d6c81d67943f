// SPDX-License-Identifier: MIT
//
// Polygons of a file, cut into triangles. Every side of a polygon stays a side of one of its
// triangles, also where corners lie in a line: else the faces beside it would not fit any more.

import earcut, { refine } from 'earcut';
import { counted } from '../base/sentences.js';
import type { SlicedWork } from '../base/slices.js';
import { copyTo, GrowingArray } from '../base/growing_array.js';
import { requireCorners, requireTriangles, type SizeLimits } from './limits.js';

/** How far corners are moved, as a share of the polygon: more than rounding, less than any detail. */
const jitter = 2 ** -36;

export class Polygons {
  readonly #limits: SizeLimits;
  /** The corners of all polygons, one after the other. */
  readonly #corners: GrowingArray<Int32Array>;
  /** Polygons of more than three corners: the index of the first in `#corners`, and the number. */
  readonly #larger = new GrowingArray(Int32Array);
  /** Where the corners of the next polygon begin. */
  #start = 0;
  #count = 0;
  #passedOver = 0;

  /** Exactly the `expected` number of triangles takes the least memory. */
  constructor(limits: SizeLimits, expected = 0) {
    this.#limits = limits;
    this.#corners = new GrowingArray(Int32Array, 3 * expected);
  }

  get count(): number {
    return this.#count;
  }

  addCorner(vertex: number): void {
    this.#corners.push(vertex);
    requireCorners(this.#corners.length - this.#start);
  }

  /** Ends a polygon of three corners at least. */
  endPolygon(): void {
    const size = this.#corners.length - this.#start;
    if (size > 3) {
      this.#larger.push(this.#start);
      this.#larger.push(size);
    }
    ++this.#count;
    this.#start += size;
    requireTriangles(this.#triangles, this.#limits);
  }

  /** Every polygon has two fewer of them than corners. */
  get #triangles(): number {
    return this.#start - 2 * this.#count;
  }

  /** Counts a line or a point: a polygon of fewer corners, or what the file calls so. */
  passOver(): void {
    ++this.#passedOver;
  }

  /** Gives up three vertices per triangle, and sentences about what was cut or passed over. */
  *take(positions: Float64Array): SlicedWork<{ indices: Int32Array; notes: string[] }> {
    const corners = yield* this.#corners.take();
    const larger = yield* this.#larger.take();
    const notes = notesOf(larger.length / 2, this.#passedOver);
    if (larger.length === 0) return { indices: corners, notes };
    const indices = new Int32Array(3 * this.#triangles);
    // How many of the indices are there, and of which corners.
    let [at, taken] = [0, 0];
    for (let i = 0; i <= larger.length; i += 2) {
      const isLast = i === larger.length;
      const start = isLast ? corners.length : larger[i];
      yield* copyTo(indices, at, corners.subarray(taken, start)); // triangles
      at += start - taken;
      taken = start;
      if (isLast) break;
      const polygon = corners.subarray(start, start + larger[i + 1]);
      indices.set(cutPolygon(polygon, positions), at);
      at += 3 * (polygon.length - 2);
      taken += polygon.length;
      yield 1;
    }
    return { indices, notes };
  }
}

function notesOf(cut: number, passedOver: number): string[] {
  const be = (count: number) => (count === 1 ? 'was' : 'were');
  const notes: string[] = [];
  if (cut > 0) notes.push(`${counted(cut, 'polygon')} ${be(cut)} cut into triangles`);
  if (passedOver > 0)
    notes.push(
      `${counted(passedOver, 'line or point', 'lines and points')} ${be(passedOver)} passed over`,
    );
  return notes;
}

/** The vertices of the triangles of a polygon: always two fewer than it has corners. */
function cutPolygon(polygon: Int32Array, positions: Float64Array): Int32Array {
  const places = projected(polygon, positions);
  const ears = earcut(jittered(places));
  refine(ears, places); // Delaunay: no triangle is flat where corners lie in a line
  // Fewer are left where the polygon crosses itself: then a fan is as good as anything.
  const corners = ears.length === 3 * (polygon.length - 2) ? ears : fanOf(polygon.length);
  return Int32Array.from(corners, (corner) => polygon[corner]);
}

/** All triangles at the first corner. */
function fanOf(count: number): number[] {
  return Array.from({ length: 3 * (count - 2) }, (_, i) => i % 3 && Math.floor(i / 3) + (i % 3));
}

/** Places with no three in a line: cutting ears would drop the one between the others. */
function jittered(places: Float64Array): Float64Array {
  const size = places.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  return places.map((x, i) => x + size * jitter * ((i * i * Math.SQRT2) % 1));
}

/**
 * x and y of each corner, from the first one, in a plane in which the polygon is counterclockwise, if
 * it is planar.
 */
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
    (_, i) => positions[3 * polygon[i >> 1] + others[i % 2]] - positions[first + others[i % 2]],
  );
}
