// SPDX-License-Identifier: MIT
//
// Whatever is wrong on the command line or in a file is an error of the kind that decides the exit
// status, is told in one line, and leaves no file behind. All of it is run on this thread, which takes a
// second where a process for each line took half a minute; other tests of the command run processes.

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { GeodesicVoronoiError } from 'geodesic-voronoi';
import { parseCommandLine } from '../../dist/cli/command_line.js';
import { execute } from '../../dist/cli/commands.js';
import { fail } from '../../dist/cli/failure.js';
import { FileError } from '../../dist/cli/files.js';
import { UsageError } from '../../dist/cli/values.js';
import { glb, octahedron } from './meshes.mjs';
import { temporaryFolder } from './temporary_folder.mjs';

const withSites = ['diagram', 'locate', 'distances', 'cvt', 'partition', 'dual', 'remesh'];
const all = ['info', 'path', ...withSites];
/** What a command needs besides a mesh and sites, and something it may have. */
const needed = {
  path: '--from one.json --to one.json',
  locate: '--points one.json',
};
const call = (command, sites = withSites.includes(command) ? '--sites 2' : '') =>
  `${command} mesh.glb ${sites} ${needed[command] ?? ''} -o out.json`;

/** What is wrong with the command line. */
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
    call(command).replace('-o out.json', '--output'),
    call(command).replace('-o out.json', '--output='),
  ]),
  ...withSites.flatMap((command) => [
    `${command} mesh.glb --points one.json -o out`,
    `${call(command)} --sites 2`,
    call(command, '--sites='),
    call(command, '--sites 0'),
    call(command, '--sites -3'),
    call(command, '--sites=1e99'),
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

/** What is wrong with the files that it names. */
const badInputs = [
  ...all.flatMap((command) => [
    call(command).replace('mesh.glb', 'nowhere.glb'),
    call(command).replace('mesh.glb', 'folder.json'),
    call(command).replace('mesh.glb', 'one.json'),
    call(command).replace('-o out', '-o nowhere/out'),
    call(command).replace('-o out', '-o folder'),
  ]),
  ...withSites.flatMap((command) => [
    call(command, '--sites nowhere.json'),
    call(command, '--sites mesh.glb'),
    call(command, '--sites beyond.json'),
    call(command, '--sites list.json'),
    `${call(command)} --per-component 3`,
  ]),
  ...['cvt', 'remesh'].flatMap((command) => [
    `${call(command)} --density nowhere.json`,
    `${call(command)} --density one.json`,
    `${call(command)} --density list.json`,
    `${call(command)} --fixed-sites beyond.json`,
    `${call(command)} --fixed-sites list.json`,
  ]),
  call('path').replace('--from one', '--from beyond'),
  call('path').replace('--to one', '--to list'),
  call('locate').replace('--points one', '--points list'),
  call('locate').replace('--points one', '--points places'),
  call('path').replace('--to one', '--to places'),
  call('diagram', '--sites places.json'),
  `dual mesh.glb --sites 1 -o out.json --check`,
];

const home = process.cwd();
after(() => process.chdir(home));
process.chdir(temporaryFolder());
mkdirSync('folder.json');
writeFileSync('mesh.glb', glb(octahedron()));
writeFileSync('one.json', '{"vertex": [0]}');
writeFileSync('beyond.json', '{"vertex": [99]}');
writeFileSync('list.json', '[7]');
writeFileSync('places.json', '{"position": [0, 0]}');
const contents = readdirSync('.');

const run = async (args) => execute(parseCommandLine(args.split(' ').filter(Boolean), ''));

for (const [what, status, kinds, lines] of [
  ['a wrong command line', 2, [UsageError], misuses],
  ['a wrong file', 1, [FileError, GeodesicVoronoiError], badInputs],
]) {
  test(`${what}: status ${status} and one line (${lines.length} ways)`, async ({ mock }) => {
    const written = [];
    mock.method(process.stderr, 'write', (text) => written.push(text) > 0);
    for (const line of lines) {
      const error = await run(line).then(
        () => undefined,
        (thrown) => thrown,
      );
      const isRight = kinds.some((kind) => error instanceof kind);
      assert.ok(isRight, `${line}: ${error?.stack ?? 'no error'}`);
      fail(error);
      const told = written.splice(0).join('');
      const exitCode = process.exitCode;
      process.exitCode = undefined; // that of the tests
      assert.equal(exitCode, status, line);
      assert.match(told, /^geodesic-voronoi: [^\n]{4,300}\n$/, line);
      assert.deepEqual(readdirSync('.'), contents, line);
    }
  });
}
