// SPDX-License-Identifier: MIT
//
// The command in a folder of its own, which has a few small files before each test.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { apart, glb, grid, octahedron } from './meshes.mjs';
import { temporaryFolder } from './temporary_folder.mjs';

const main = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));
export const folder = temporaryFolder();
beforeEach(() => {
  rmSync(folder, { recursive: true });
  mkdirSync(folder);
  write('shape.glb', glb(octahedron()));
  write('two.glb', glb(apart(octahedron(), grid(1))));
  write('sites.json', '{"vertex": [0, 3]}');
  write('points.json', '{"face": [0, 1], "bary": [1, 0, 0, 0, 1, 0]}');
});

export const write = (name, content) => writeFileSync(join(folder, name), content);
export const read = (name) => readFileSync(join(folder, name), 'utf8');

/** Runs the command in the folder; `input` goes to its standard input. */
export function run(args, input) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [main, ...args.split(' ')], {
    cwd: folder,
    input,
    encoding: 'utf8',
  });
  return { status, stdout, stderr };
}

export function succeeds(args, input) {
  const { status, stdout, stderr } = run(args, input);
  assert.equal(status, 0, stderr);
  return { stdout, stderr };
}

/** One line on standard error, nothing on standard output, no file that was not there. */
export function fails(status, args, message, input) {
  const before = readdirSync(folder);
  const result = run(args, input);
  assert.match(result.stderr, /^geodesic-voronoi: [^\n]+\n$/);
  assert.match(result.stderr, message);
  assert.equal(result.status, status, result.stderr);
  assert.equal(result.stdout, '');
  assert.deepEqual(readdirSync(folder), before);
}
