// SPDX-License-Identifier: MIT
//
// A coarse closed mesh made fine and smooth.

/**
 * One round of subdivision of a closed triangle mesh, {positions, indices}: each triangle becomes four
 * (Charles Loop. Smooth Subdivision Surfaces Based on Triangles. 1987).
 */
export function subdivide({ positions, indices }) {
  const count = positions.length / 3;
  const neighbours = Array.from({ length: count }, () => new Set());
  const edges = new Map();
  const keyOf = (a, b) => Math.min(a, b) * count + Math.max(a, b);
  for (let i = 0; i < indices.length; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const [a, b, c] = [0, 1, 2].map((n) => indices[i + ((k + n) % 3)]);
      neighbours[a].add(b);
      neighbours[b].add(a);
      const edge = edges.get(keyOf(a, b)) ?? { ends: [a, b], opposite: [] };
      edge.opposite.push(c);
      edges.set(keyOf(a, b), edge);
    }
  }
  const mean = (vertices, axis) =>
    vertices.reduce((sum, v) => sum + positions[3 * v + axis], 0) / vertices.length;
  const refined = [];
  neighbours.forEach((around, v) => {
    // Loop's weight of a vertex with n neighbours.
    const cosine = Math.cos((2 * Math.PI) / around.size);
    const weight = 5 / 8 - (3 / 8 + cosine / 4) ** 2;
    for (let axis = 0; axis < 3; ++axis) {
      refined.push((1 - weight) * positions[3 * v + axis] + weight * mean([...around], axis));
    }
  });
  for (const edge of edges.values()) {
    edge.vertex = refined.length / 3;
    for (let axis = 0; axis < 3; ++axis) {
      refined.push(0.75 * mean(edge.ends, axis) + 0.25 * mean(edge.opposite, axis));
    }
  }
  const corners = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.slice(i, i + 3);
    const [ab, bc, ca] = [
      [a, b],
      [b, c],
      [c, a],
    ].map((ends) => edges.get(keyOf(...ends)).vertex);
    corners.push(a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca);
  }
  return { positions: refined, indices: corners };
}
