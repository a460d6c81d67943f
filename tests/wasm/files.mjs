// SPDX-License-Identifier: MIT
//
// What others make of our files: the Khronos glTF validator, three's loader, and readers of OBJ and
// PLY as simple as the formats are.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { triples } from './meshes.mjs';

const validator = createRequire(import.meta.url)('gltf-validator');

/** Fails on any error or warning. */
export async function assertValidGlb(bytes) {
  const { issues } = await validator.validateBytes(bytes);
  const messages = issues.messages.filter(({ severity }) => severity <= 1);
  assert.deepEqual(messages, []);
}

/** The meshes of a scene as three loads it: name, what it is told of, and geometry. */
export async function threeMeshes(bytes) {
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const { scene } = await new GLTFLoader().parseAsync(buffer, '');
  const meshes = [];
  scene.traverse((object) => {
    if (object.isMesh) meshes.push(object);
  });
  return meshes;
}

/** Corner by corner, the positions of a three geometry. */
export function trianglesOf({ index, attributes: { position } }) {
  return Array.from({ length: index.count / 3 }, (_, t) =>
    [0, 1, 2].map((i) => {
      const vertex = index.getX(3 * t + i);
      return [position.getX(vertex), position.getY(vertex), position.getZ(vertex)];
    }),
  );
}

/** Corner by corner, the positions of the triangles of a partition. */
export function placedTriangles({ points, triangles }) {
  const places = triples(points.position);
  return triples(triangles.points).map((corners) => corners.map((point) => places[point]));
}

/** The area of a polygon in space. */
export function areaOf(corners) {
  const sum = [0, 0, 0];
  for (let i = 1; i + 1 < corners.length; ++i) {
    const [p, q] = [corners[i], corners[i + 1]].map((corner) =>
      corner.map((x, k) => x - corners[0][k]),
    );
    for (let k = 0; k < 3; ++k) {
      const [y, z] = [(k + 1) % 3, (k + 2) % 3];
      sum[k] += (p[y] * q[z] - p[z] * q[y]) / 2;
    }
  }
  return Math.hypot(...sum);
}

/** A list of lists, as lists. */
export const listsOf = ({ offset, points }) =>
  Array.from({ length: offset.length - 1 }, (_, i) => [
    ...points.subarray(offset[i], offset[i + 1]),
  ]);

/** The JSON of a GLB. */
export function jsonOf(glb) {
  const bytes = Buffer.from(glb.buffer, glb.byteOffset, glb.byteLength);
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)));
}

export const total = (values) => values.reduce((sum, value) => sum + value, 0);

/**
 * V - E + F, the number of sides without a face beyond them, of the closed curves that these make up
 * (NaN if they meet elsewhere), and whether each side is used at most once in each direction.
 */
export function surfaceOf(polygons) {
  const sides = new Set();
  let repeated = 0;
  for (const polygon of polygons) {
    polygon.forEach((from, i) => {
      const side = `${from} ${polygon[(i + 1) % polygon.length]}`;
      repeated += sides.has(side);
      sides.add(side);
    });
  }
  const pairs = [...sides].map((side) => side.split(' '));
  const open = pairs.filter(([from, to]) => !sides.has(`${to} ${from}`));
  const vertices = new Set(polygons.flat()).size;
  const edges = (sides.size + open.length) / 2;
  return {
    euler: vertices - edges + polygons.length,
    open: open.length,
    loops: closedCurves(open),
    isOriented: repeated === 0,
  };
}

/** How many closed curves sides make up, each with the next one's start as its end. */
function closedCurves(sides) {
  const next = new Map(sides);
  if (next.size < sides.length) return NaN;
  let count = 0;
  for (const start of next.keys()) {
    ++count;
    for (let at = start, to; (to = next.get(at)) !== undefined; at = to) next.delete(at);
  }
  return count;
}

/** Vertices, and faces with their corners' indices (from 0) and group. */
export function readObj(text) {
  const file = { v: [], vt: [], vn: [], faces: [] };
  let group = '';
  for (const line of text.split('\n')) {
    const [key, ...words] = line.split(' ');
    if (key === 'g') [group] = words;
    else if (key === 'f') {
      const corners = words.map((word) => word.split('/').map((n) => (n ? Number(n) - 1 : -1)));
      file.faces.push({ group, corners });
    } else if (key in file) file[key].push(words.map(Number));
  }
  return file;
}

const plyTypes = {
  uchar: [1, 'getUint8'],
  int: [4, 'getInt32'],
  float: [4, 'getFloat32'],
  double: [8, 'getFloat64'],
};

/** Elements as lists of rows, a row by the names of its properties. */
export function readPly(bytes) {
  const end = 'end_header\n';
  const header = Buffer.from(bytes).toString('latin1').split(end)[0];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let offset = header.length + end.length;
  const take = (type) => {
    const [size, getter] = plyTypes[type];
    const value = view[getter](offset, true);
    offset += size;
    return value;
  };
  const lines = header.trim().split('\n');
  assert.deepEqual(lines.slice(0, 2), ['ply', 'format binary_little_endian 1.0']);
  const elements = [];
  for (const line of lines) {
    const [key, ...words] = line.split(' ');
    if (key === 'element') elements.push({ name: words[0], count: Number(words[1]), columns: [] });
    if (key === 'property') elements.at(-1).columns.push(words);
  }
  const file = {};
  for (const { name, count, columns } of elements) {
    file[name] = Array.from({ length: count }, () =>
      Object.fromEntries(
        columns.map((words) => {
          if (words[0] !== 'list') return [words[1], take(words[0])];
          return [words[3], Array.from({ length: take(words[1]) }, () => take(words[2]))];
        }),
      ),
    );
  }
  assert.equal(offset, bytes.length);
  return file;
}
