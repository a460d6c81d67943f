// SPDX-License-Identifier: MIT
//
// The vertices of triangles by the place where they are, which may have several of them.

/** For every vertex the first vertex at the very same position. */
function firstAtPlace(positions: Float32Array): Int32Array {
  const count = positions.length / 3;
  // Adding zero turns -0 into +0, which is the same place.
  const bits = new Uint32Array(positions.map((x) => x + 0).buffer);
  let capacity = 16;
  while (capacity < 2 * count) capacity *= 2;
  const table = new Int32Array(capacity).fill(-1);
  const place = new Int32Array(count);
  for (let v = 0; v < count; ++v) {
    const x = bits[3 * v];
    const y = bits[3 * v + 1];
    const z = bits[3 * v + 2];
    let hash = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    hash ^= hash >>> 15;
    let slot = hash & (capacity - 1);
    let other = table[slot];
    while (
      other >= 0 &&
      (bits[3 * other] !== x || bits[3 * other + 1] !== y || bits[3 * other + 2] !== z)
    ) {
      slot = (slot + 1) & (capacity - 1);
      other = table[slot];
    }
    if (other < 0) table[slot] = v;
    place[v] = other < 0 ? v : other;
  }
  return place;
}

/** Which corners of triangles meet at each place, even where the input has several vertices there. */
export interface Adjacency {
  /** Per vertex; see `firstAtPlace`. */
  place: Int32Array;
  /** See `cornersByPlace`. */
  offset: Int32Array;
  corners: Int32Array;
}

/** A quarter of a second of work for a million triangles. */
export function adjacencyOf({
  positions,
  indices,
}: {
  positions: Float32Array;
  indices: Int32Array;
}): Adjacency {
  const place = firstAtPlace(positions);
  return { place, ...cornersByPlace(indices, place) };
}

/**
 * The corners of triangles by the place (see `firstAtPlace`) of their vertex. Those at place p are
 * `corners[offset[p]] … corners[offset[p + 1] - 1]`.
 */
function cornersByPlace(indices: Int32Array, place: Int32Array) {
  const offset = new Int32Array(place.length + 1);
  for (const v of indices) ++offset[place[v] + 1];
  for (let p = 0; p < place.length; ++p) offset[p + 1] += offset[p];
  const end = offset.slice();
  const corners = new Int32Array(indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    corners[end[place[indices[corner]]]++] = corner;
  }
  return { offset, corners };
}
