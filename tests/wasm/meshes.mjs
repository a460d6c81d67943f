// SPDX-License-Identifier: MIT
//
// Small meshes for the tests.

/** The unit square in n × n squares of two triangles. */
export function grid(n) {
  const positions = [];
  const indices = [];
  for (let y = 0; y <= n; ++y) for (let x = 0; x <= n; ++x) positions.push(x / n, y / n, 0);
  for (let y = 0; y < n; ++y) {
    for (let x = 0; x < n; ++x) {
      const a = y * (n + 1) + x;
      const b = a + n + 1;
      indices.push(a, a + 1, b, a + 1, b + 1, b);
    }
  }
  return { positions, indices };
}

/** The regular octahedron with vertices at distance 1 from the origin. */
export function octahedron() {
  return {
    positions: [1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1],
    indices: [0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5],
  };
}

/** Two meshes side by side, as one. */
export function apart(a, b) {
  const offset = a.positions.length / 3;
  return {
    positions: [...a.positions, ...b.positions.map((x, i) => (i % 3 === 0 ? x + 5 : x))],
    indices: [...a.indices, ...b.indices.map((i) => i + offset)],
  };
}

/** The same surface with triangle `f` turned over. */
export function withFlipped({ positions, indices }, f) {
  const flipped = [...indices];
  [flipped[3 * f + 1], flipped[3 * f + 2]] = [flipped[3 * f + 2], flipped[3 * f + 1]];
  return { positions, indices: flipped };
}

/** The same triangles with vertices of their own, apart from each other by a gap. */
export function torn({ positions, indices }, gap = 0) {
  const corners = triples(positions);
  return {
    positions: indices.flatMap((v, i) => corners[v].map((x) => x + gap * (i % 3))),
    indices: indices.map((_, i) => i),
  };
}

/** Numbers by threes, as those of a vertex or of a triangle. */
export const triples = (list) =>
  Array.from({ length: list.length / 3 }, (_, i) => [...list.slice(3 * i, 3 * i + 3)]);

/** One of several points, as a list. */
export const pointAt = ({ face, bary }, i) => ({
  face: face.slice(i, i + 1),
  bary: bary.slice(3 * i, 3 * i + 3),
});

/** Where a point of a mesh is; its coordinates are the first three of `bary`. */
export const placeOf = ({ positions, indices }, face, bary) =>
  [0, 1, 2].map((axis) =>
    [0, 1, 2].reduce((sum, c) => sum + bary[c] * positions[3 * indices[3 * face + c] + axis], 0),
  );

/** A diagram's sites without the labels of removed ones, and the labels of those that are there. */
export function presentSites({ face, bary }) {
  const labels = [...face.keys()].filter((label) => face[label] >= 0);
  const sites = {
    face: labels.map((label) => face[label]),
    bary: labels.flatMap((label) => [...bary.subarray(3 * label, 3 * label + 3)]),
  };
  return { sites, labels };
}

/** The JSON and the buffer of a glTF with one mesh, moved by `translation`. */
export function gltf({ positions, indices }, { translation = [0, 0, 0], uri } = {}) {
  const buffer = Buffer.concat([
    Buffer.from(Float32Array.from(positions).buffer),
    Buffer.from(Uint32Array.from(indices).buffer),
  ]);
  const split = 4 * positions.length;
  const axis = (k) => positions.filter((_, i) => i % 3 === k);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'Bläck', translation }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: positions.length / 3,
        type: 'VEC3',
        min: [0, 1, 2].map((k) => Math.fround(Math.min(...axis(k)))),
        max: [0, 1, 2].map((k) => Math.fround(Math.max(...axis(k)))),
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: split },
      { buffer: 0, byteOffset: split, byteLength: buffer.length - split },
    ],
    buffers: [{ byteLength: buffer.length, ...(uri && { uri }) }],
  };
  return { json, buffer };
}

/** The bytes of a GLB with one mesh. */
export function glb(mesh, options) {
  const { json, buffer } = gltf(mesh, options);
  return glbOf(json, buffer);
}

/** A GLB out of its JSON and its buffer. */
export function glbOf(json, buffer) {
  const padded = (bytes, filler) =>
    Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
  const chunks = [
    [0x4e4f534a, padded(Buffer.from(JSON.stringify(json)), ' ')],
    [0x004e4942, padded(Buffer.from(buffer), 0)],
  ];
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  const body = chunks.flatMap(([type, bytes]) => [words(bytes.length, type), bytes]);
  const length = body.reduce((sum, bytes) => sum + bytes.length, 12);
  return new Uint8Array(Buffer.concat([words(0x46546c67, 2, length), ...body]));
}

/** A closed surface around the origin, with hills and hollows: rings of vertices between two poles. */
export function bumpySphere(rings, spokes) {
  const positions = [];
  const indices = [];
  const add = (polar, azimuth) => {
    const radius =
      1 + 0.15 * Math.sin(3 * azimuth + 1) * Math.sin(polar) ** 2 + 0.1 * Math.cos(5 * polar);
    positions.push(
      radius * Math.sin(polar) * Math.cos(azimuth),
      radius * Math.sin(polar) * Math.sin(azimuth),
      radius * Math.cos(polar),
    );
  };
  add(0, 0);
  for (let ring = 1; ring < rings; ++ring) {
    for (let spoke = 0; spoke < spokes; ++spoke) {
      add((Math.PI * ring) / rings, (2 * Math.PI * (spoke + ring / 2)) / spokes);
    }
  }
  add(Math.PI, 0);
  const at = (ring, spoke) => 1 + (ring - 1) * spokes + (spoke % spokes);
  const last = positions.length / 3 - 1;
  for (let spoke = 0; spoke < spokes; ++spoke) {
    indices.push(0, at(1, spoke), at(1, spoke + 1));
    for (let ring = 1; ring < rings - 1; ++ring) {
      indices.push(at(ring, spoke), at(ring + 1, spoke), at(ring, spoke + 1));
      indices.push(at(ring + 1, spoke), at(ring + 1, spoke + 1), at(ring, spoke + 1));
    }
    indices.push(at(rings - 1, spoke), last, at(rings - 1, spoke + 1));
  }
  return { positions, indices };
}
