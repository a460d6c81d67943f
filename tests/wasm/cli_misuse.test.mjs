// SPDX-License-Identifier: MIT
//
// Whatever is wrong on the command line or in a file is told in one line, with the right exit
// status, and leaves no file behind.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { glb, octahedron } from './meshes.mjs';

const main = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));

const withSites = ['diagram', 'locate', 'distances', 'cvt', 'partition', 'dual', 'remesh'];
const all = ['info', 'path', ...withSites];
/** What a command needs besides a mesh, and something it may have. */
const needed = {
  info: '',
  path: '--from one.json --to one.json',
  locate: '--sites 2 --points one.json',
};
const call = (command) => `${command} mesh.glb ${needed[command] ?? '--sites 2'} -o out.json`;

/** Status 2: the command line is wrong. */
const misuses = [
  '',
  '-x',
  '--nonsense',
  'help me',
  'help diagram mesh.glb',
  'Info mesh.glb',
  'toString mesh.glb',
  ...['path', ...withSites].map((command) => `${call(command)} other.glb`),
  ...all.flatMap((command) => [
    command,
    `${call(command)} --nonsense`,
    `${call(command)} --quiet=yes`,
    `${call(command)} --units parsec`,
    `${call(command)} --weld 2`,
    `${call(command)} --orientation up`,
    `${call(command)} --min-component=-1`,
    `${call(command)} --output`,
  ]),
  ...withSites.flatMap((command) => [
    `${command} mesh.glb --points one.json -o out`,
    `${call(command)} --sites 0`,
    `${call(command)} --sites -3`,
    `${call(command)} --sites=1e99`,
    `${call(command)} --seed x`,
    `${call(command)} --sampling even`,
    `${call(command)} --radius 1`,
    `${call(command)} --per-component few`,
    `${call(command)} --metric euclid`,
  ]),
  ...['diagram', 'partition'].flatMap((command) => [
    `${call(command)} --detail=-1`,
    `${call(command)} --detail 1.5`,
    `${call(command)} --detail 99`,
  ]),
  ...['cvt', 'remesh'].flatMap((command) => [
    `${call(command)} --iterations few`,
    `${call(command)} --iterations -1`,
    `${call(command)} --method newton`,
    `${call(command)} --density --fixed-sites`,
    `${call(command)} --density one.json --iterations 0 --sampling size`,
  ]),
  ...all.map((command) => `${call(command)} --format docx`),
  `${call('partition')} --layout tree`,
  `${call('partition')} --layout regions`,
  `${call('diagram')} --density curvature`,
  'cvt - --sites 2 --fixed-sites - -o out.json',
  'diagram - --sites - -o out.json',
  'path mesh.glb --from one.json -o out.json',
  'path mesh.glb --to one.json -o out.json',
  'locate mesh.glb --sites 2 -o out.json',
];

/** Status 1: what the command line names is wrong. */
const badInputs = [
  ...all.flatMap((command) => [
    call(command).replace('mesh.glb', 'nowhere.glb'),
    call(command).replace('mesh.glb', 'folder.json'),
    call(command).replace('mesh.glb', 'one.json'),
    call(command).replace('-o out', '-o nowhere/out'),
    call(command).replace('-o out', '-o folder'),
  ]),
  ...withSites.flatMap((command) => [
    `${call(command)} --sites nowhere.json`,
    `${call(command)} --sites mesh.glb`,
    `${call(command)} --sites beyond.json`,
    `${call(command)} --sites list.json`,
    `${call(command)} --per-component 3`,
  ]),
  ...['cvt', 'remesh'].flatMap((command) => [
    `${call(command)} --density nowhere.json`,
    `${call(command)} --density one.json`,
    `${call(command)} --density list.json`,
    `${call(command)} --fixed-sites beyond.json`,
    `${call(command)} --fixed-sites list.json`,
  ]),
  `${call('path')} --from beyond.json`,
  `${call('path')} --to list.json`,
  `${call('locate')} --points list.json`,
  `${call('locate')} --points places.json`,
  `${call('path')} --to places.json`,
  `${call('diagram')} --sites places.json`,
  `dual mesh.glb --sites 1 -o out.json --check`,
];

let folder;
let contents;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  mkdirSync(join(folder, 'folder.json'));
  writeFileSync(join(folder, 'mesh.glb'), glb(octahedron()));
  writeFileSync(join(folder, 'one.json'), '{"vertex": [0]}');
  writeFileSync(join(folder, 'beyond.json'), '{"vertex": [99]}');
  writeFileSync(join(folder, 'list.json'), '[7]');
  writeFileSync(join(folder, 'places.json'), '{"position": [0, 0]}');
  contents = readdirSync(folder);
});
after(() => rmSync(folder, { recursive: true }));

function run(args) {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [main, ...args.split(' ').filter(Boolean)], {
      cwd: folder,
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    const texts = { stdout: '', stderr: '' };
    for (const name of ['stdout', 'stderr']) {
      child[name].setEncoding('utf8').on('data', (text) => (texts[name] += text));
    }
    child.on('error', reject).on('close', (status) => resolve({ status, ...texts }));
  });
}

async function assertFails(args, expected) {
  const { status, stdout, stderr } = await run(args);
  const what = `geodesic-voronoi ${args}\n${stderr}`;
  assert.equal(status, expected, what);
  assert.match(stderr, /^geodesic-voronoi: [^\n]{4,300}\n$/, what);
  assert.equal(stdout, '', what);
  assert.deepEqual(readdirSync(folder), contents, what);
}

for (const [what, status, lines] of [
  ['a wrong command line', 2, misuses],
  ['a wrong file', 1, badInputs],
]) {
  test(`${what}: status ${status} and one line (${lines.length} ways)`, async () => {
    const left = [...lines];
    const work = async () => {
      while (left.length > 0) await assertFails(left.shift(), status);
    };
    await Promise.all([work(), work()]);
  });
}
