// SPDX-License-Identifier: MIT
//
// The page's sample models, made when the page is built: they come with npm packages or from
// formulas, and none is kept in the repository.

import { copyFileSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { bearingBlock, tangleCube, tripleTorus } from './implicit_shapes.mjs';
import { knot, moebiusStrip, ripples, torus } from './sample_shapes.mjs';
import { subdivide } from './subdivision.mjs';

const require = createRequire(import.meta.url);

/**
 * How each model of `samples.json` comes about: its triangles, or the path of a file in a package.
 */
const sources = {
  'bunny.ply': bunny,
  'hand.glb': '@webxr-input-profiles/assets/dist/profiles/generic-hand/left.glb',
  'bearing.glb': bearingBlock,
  'triple-torus.glb': tripleTorus,
  'tangle.glb': tangleCube,
  'torus.glb': torus,
  'knot.glb': knot,
  'ripples.glb': ripples,
  'moebius.glb': moebiusStrip,
};

/** Writes the models into a folder, and removes everything else from it. */
export function makeSamples(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const [file, source] of Object.entries(sources)) {
    const target = join(folder, file);
    if (typeof source === 'string') copyFileSync(require.resolve(source), target);
    else writeFileSync(target, file.endsWith('.ply') ? ply(source()) : glb(source()));
  }
}

/** A binary PLY of triangles. The first model is one, because reading it takes no other module. */
function ply({ positions, indices }) {
  const vertexCount = positions.length / 3;
  const faceCount = indices.length / 3;
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${vertexCount}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${faceCount}`,
    'property list uchar int vertex_indices',
    'end_header\n',
  ];
  const faceBytes = 13;
  const faces = Buffer.alloc(faceBytes * faceCount);
  indices.forEach((vertex, corner) => {
    const at = faceBytes * Math.floor(corner / 3);
    faces.writeUInt8(3, at);
    faces.writeInt32LE(vertex, at + 1 + 4 * (corner % 3));
  });
  const vertices = Buffer.from(Float32Array.from(positions).buffer);
  return Buffer.concat([Buffer.from(header.join('\n')), vertices, faces]);
}

/** The bunny of the package has 3,674 triangles; two rounds of subdivision make 58,784. */
function bunny() {
  const { positions, cells } = require('bunny');
  return subdivide(subdivide({ positions: positions.flat(), indices: cells.flat() }));
}

/** A binary glTF of one mesh. */
function glb({ positions, indices }) {
  const vertices = Float32Array.from(positions);
  const corners = Uint32Array.from(indices);
  const axis = (k) => vertices.filter((_, i) => i % 3 === k);
  const bounds = (pick) => [0, 1, 2].map((k) => axis(k).reduce((a, b) => pick(a, b)));
  const float = 5126;
  const unsignedInt = 5125;
  const json = Buffer.from(
    JSON.stringify({
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      accessors: [
        {
          bufferView: 0,
          componentType: float,
          count: vertices.length / 3,
          type: 'VEC3',
          min: bounds(Math.min),
          max: bounds(Math.max),
        },
        { bufferView: 1, componentType: unsignedInt, count: corners.length, type: 'SCALAR' },
      ],
      bufferViews: [
        { buffer: 0, byteOffset: 0, byteLength: vertices.byteLength },
        { buffer: 0, byteOffset: vertices.byteLength, byteLength: corners.byteLength },
      ],
      buffers: [{ byteLength: vertices.byteLength + corners.byteLength }],
    }),
  );
  const padding = Buffer.alloc(-json.length & 3, ' ');
  const data = [Buffer.from(vertices.buffer), Buffer.from(corners.buffer)];
  return Buffer.concat(withHeader([chunk('JSON', [json, padding]), chunk('BIN\0', data)]));
}

function chunk(type, parts) {
  const head = Buffer.alloc(8);
  head.writeUInt32LE(
    parts.reduce((sum, part) => sum + part.length, 0),
    0,
  );
  head.write(type, 4, 'latin1');
  return Buffer.concat([head, ...parts]);
}

function withHeader(chunks) {
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(
    chunks.reduce((sum, part) => sum + part.length, head.length),
    8,
  );
  return [head, ...chunks];
}
