// SPDX-License-Identifier: MIT
//
// The edges of a mesh, as its wireframe has them.

/** Both vertices of every edge; an edge inside the surface once if its two faces share vertices. */
export function meshEdges(indices: Int32Array): Uint32Array {
  const vertexCount = indices.reduce((most, v) => Math.max(most, v), -1) + 1;
  // A typed array is sorted by its numbers, and quicker than a set is filled.
  const sides = new Float64Array(indices.length);
  for (let i = 0; i < indices.length; ++i) {
    const tail = indices[i];
    const tip = indices[i % 3 === 2 ? i - 2 : i + 1];
    sides[i] = Math.min(tail, tip) * vertexCount + Math.max(tail, tip);
  }
  sides.sort();
  const edges = new Uint32Array(2 * sides.length);
  let count = 0;
  for (let i = 0; i < sides.length; ++i) {
    if (sides[i] === sides[i - 1]) continue;
    edges[count++] = Math.floor(sides[i] / vertexCount);
    edges[count++] = sides[i] % vertexCount;
  }
  return edges.slice(0, count);
}
