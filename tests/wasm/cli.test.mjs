// SPDX-License-Identifier: MIT
//
// The command line: its help, models, options of meshes, and what it says of mistakes.

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { zipSync } from 'fflate';
import { parseCommandLine } from '../../dist/cli/command_line.js';
import { commands } from '../../dist/cli/options.js';
import { fails, folder, read, run, succeeds, write } from './command.mjs';
import { assertValidGlb } from './files.mjs';
import { glb, gltf, octahedron, torn, withFlipped } from './meshes.mjs';
import { meshBinaryStl, meshObj } from './model_files.mjs';
import { near } from './expectations.mjs';

test('--help and --version', () => {
  const overview = succeeds('--help').stdout;
  const analyses = ['info', 'diagram', 'locate', 'distances', 'path'];
  for (const command of [...analyses, 'cvt', 'partition', 'dual', 'remesh']) {
    assert.match(overview, new RegExp(`^  ${command} `, 'm'));
    assert.match(
      succeeds(`${command} --help`).stdout,
      new RegExp(`Usage: geodesic-voronoi ${command}`),
    );
  }
  const { version } = JSON.parse(
    readFileSync(new URL('../../package.json', import.meta.url), 'utf8'),
  );
  assert.equal(succeeds('--version').stdout, `${version}\n`);
});

test('the help: of a command in two ways, and in lines of 100 columns at most', () => {
  assert.equal(succeeds('help diagram').stdout, succeeds('diagram --help').stdout);
  for (const command of [[], ...Object.keys(commands).map((name) => [name])]) {
    const help = parseCommandLine(['help', ...command], '');
    assert.equal(help, parseCommandLine([...command, '--help'], ''));
    for (const line of help.split('\n')) assert.ok(line.length <= 100, line);
  }
});

test('a mesh without a name, as where a variable of the shell is not set, is missing', () => {
  assert.throws(() => parseCommandLine(['info', ''], ''), { message: 'a mesh is missing' });
});

test('an option that a command has not: the nearest, or whose it is', () => {
  fails(
    2,
    'diagram shape.glb --detial 2',
    /^[^:]*: diagram has no option --detial: the nearest is --detail\n$/,
  );
  const owners = /diagram has no option --densty: --density is an option of cvt, remesh\n$/;
  fails(2, 'diagram shape.glb --densty curvature', owners);
  fails(2, 'diagram shape.glb --sites -3', /--sites is '-3', not an integer/);
  fails(2, 'diagram shape.glb --sites --seed 3', /--sites needs a value\n$/);
  fails(2, 'diagram shape.glb -o', /-o needs a value\n$/);
  fails(2, 'diagram shape.glb --sites=', /--sites needs a value\n$/);
  fails(2, 'diagram shape.glb --sites 3 --quiet=no', /--quiet is 'no', and takes no value\n$/);
});

test('info, for people and as JSON', () => {
  const { stdout, stderr } = succeeds('info two.glb');
  assert.match(stdout, /components +2\n/);
  assert.match(stdout, /triangles +10 \(10 in the file\)\n/);
  assert.equal(stderr, '');
  const json = JSON.parse(succeeds('info two.glb --json').stdout);
  assert.equal(json.faces, 10);
  assert.equal(json.boundaryLoops, 1);
  assert.equal(json.parts[0].triangleCount, 10);
});

test('info of several meshes: all that can be read, and status 1 if one cannot', () => {
  const both = succeeds('info shape.glb two.glb');
  assert.match(both.stdout, /^shape\.glb\nformat [^]*\n\ntwo\.glb\nformat /);
  const list = JSON.parse(succeeds('info shape.glb two.glb --json').stdout);
  assert.deepEqual(
    list.map(({ mesh, faces }) => [mesh, faces]),
    [
      ['shape.glb', 8],
      ['two.glb', 10],
    ],
  );

  write('bad.glb', 'nothing');
  const none = run('info bad.glb nowhere.glb --json');
  assert.equal(none.status, 1);
  assert.deepEqual(
    JSON.parse(none.stdout).map(({ mesh, error }) => [mesh, typeof error]),
    [
      ['bad.glb', 'string'],
      ['nowhere.glb', 'string'],
    ],
  );
  assert.equal(run('info bad.glb nowhere.glb').stdout, '');
  const args = 'info shape.glb bad.glb nowhere.glb two.glb';
  const some = run(args);
  assert.equal(some.status, 1);
  assert.match(
    some.stderr,
    /^geodesic-voronoi: bad\.glb: .*\ngeodesic-voronoi: nowhere\.glb .*\n$/,
  );
  assert.equal(some.stdout, both.stdout);
  const { status, stdout } = run(`${args} --json`);
  assert.equal(status, 1);
  const [first, bad, nowhere] = JSON.parse(stdout);
  assert.deepEqual(first, list[0]);
  assert.deepEqual(Object.keys(bad), ['mesh', 'error']);
  assert.match(nowhere.error, /no such file/);

  assert.equal(run('info bad.glb nowhere.glb -o report.txt').status, 1);
  assert.ok(!readdirSync(folder).includes('report.txt'));
});

test('--max-edge, --weld, --orientation and --min-component: how the mesh is made', async () => {
  const { positions, indices } = octahedron();
  write('torn.obj', meshObj(torn(octahedron(), 1e-6)));
  const { stdout } = succeeds('info torn.obj --weld 1e-5');
  assert.match(stdout, /components +1\n[^]*repair: 18 vertices welded/);
  assert.match(succeeds('info torn.obj').stdout, /components +8\n/);
  const many = Array.from({ length: 1250 }, () => indices).flat();
  write('many.glb', glb({ positions, indices: many }));
  const report = succeeds('info many.glb').stdout;
  assert.match(report, /8 \(10,000 in the file\)[^]*repair: 9,992 triangles given twice/);

  write('turned.glb', glb(withFlipped(octahedron(), 2)));
  assert.match(succeeds('info turned.glb').stdout, /repair: 1 triangle turned over/);
  assert.match(
    succeeds('info turned.glb --orientation keep').stdout,
    /repair: 3 edges cut because their two triangles disagree in orientation: no path leads across\n/,
  );

  const finer = succeeds('info shape.glb --max-edge 0.2').stdout;
  assert.match(
    finer,
    /triangles +128 \(128 in the subdivided file\)[^]*note: long edges were halved: 8 triangles became 128/,
  );
  fails(2, 'info shape.glb --max-edge=2', /^geodesic-voronoi: --max-edge/);
  fails(
    1,
    'info shape.glb --max-edge 1e-9',
    /: with no edge longer than 1e-9 of the diagonal, there would be more than 16777216 triangles$/m,
  );

  // Sites of the whole mesh stay where they are; others are refused.
  const placesOf = (file) => JSON.parse(read(file)).position;
  succeeds('cvt shape.glb --sites 3 --iterations 0 -o whole.json');
  succeeds('cvt shape.glb --sites whole.json --max-edge 0.2 --iterations 0 -o finer.json');
  placesOf('finer.json').forEach((x, i) => {
    near(x, placesOf('whole.json')[i], 1e-12);
  });
  fails(1, 'diagram two.glb --sites finer.json --max-edge 0.2', /belong to another mesh/);

  const large = succeeds('info two.glb --min-component 3').stdout;
  assert.match(large, /components +1\n[^]*repair: 1 component .*\nrepair: 2 triangles of these/);
  succeeds('partition two.glb --min-component 3 --sites 3 --sampling farthest -o parts.glb');
  await assertValidGlb(readFileSync(join(folder, 'parts.glb')));
  fails(1, 'info shape.glb --min-component 9', /no component has 9 triangles/);
  for (const wrong of [
    '--weld=-1',
    '--weld=x',
    '--weld=1.5',
    '--min-component=1.5',
    '--orientation=up',
  ])
    fails(2, `info shape.glb ${wrong}`, /^geodesic-voronoi: --/);
});

test('edges that are cut are told of', () => {
  write('fin.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n');
  const { stderr } = succeeds('distances fin.obj --sites {"vertex":[2]} -o d.json');
  assert.match(
    stderr,
    /^note: 1 edge of three or more triangles, where components are cut apart: no path leads across\n/,
  );

  write('turned.glb', glb(withFlipped(octahedron(), 2)));
  const note =
    /^note: 3 edges cut because their two triangles disagree in orientation: no path leads across\n/;
  for (const command of [
    'distances turned.glb --sites {"vertex":[2]}',
    'path turned.glb --from {"vertex":0} --to {"vertex":3}',
  ]) {
    assert.match(succeeds(`${command} --orientation keep -o d.json`).stderr, note);
    assert.doesNotMatch(succeeds(`${command} -o d.json`).stderr, /note/);
    assert.equal(succeeds(`${command} --orientation keep -o d.json -q`).stderr, '');
  }

  // Two tetrahedra with a corner in common.
  const one = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];
  const other = one.map((v) => (v === 0 ? 0 : v + 3));
  const x = (sign) => [1, 0, 0, 0, 1, 0, 0, 0, 1].map((c) => sign * c);
  write(
    'hourglass.glb',
    glb({ positions: [0, 0, 0, ...x(1), ...x(-1)], indices: [...one, ...other] }),
  );
  const touching = succeeds('distances hourglass.glb --sites 2 -o d.json').stderr;
  assert.match(
    touching,
    /^note: 1 vertex split where separate fans of triangles touch: no path leads across\n/m,
  );
  const none = succeeds(
    'path hourglass.glb --from {"vertex":0} --to {"vertex":[1,4]} -o p.json',
  ).stderr;
  assert.match(none, /no path between 1 pair of points: .* \(info tells where it is cut apart\)/);
});

test('a hole where a corner is not finite is told of', () => {
  const ply = (x) =>
    `ply\nformat ascii 1.0\nelement vertex 4\n${['x', 'y', 'z'].map((axis) => `property float ${axis}\n`).join('')}` +
    `element face 2\nproperty list uchar int vertex_indices\nend_header\n` +
    `0 0 0\n1 0 0\n0 1 0\n${x} 1 0\n3 0 1 2\n3 1 3 2\n`;
  write('hole.ply', ply('nan'));
  write('whole.ply', ply('1'));
  const distances = (model) =>
    succeeds(`distances ${model} --sites {"vertex":[0]} -o d.json`).stderr;
  assert.match(
    distances('hole.ply'),
    /^note: 1 triangle with a corner that is not finite, dropped: the surface may have a hole there\n/,
  );
  assert.doesNotMatch(distances('whole.ply'), /note/);
});

test('a path that does not exist is told of', () => {
  const { stderr } = succeeds(
    'path two.glb --from {"vertex":[0,0]} --to {"vertex":[1,6]} -o path.json',
  );
  assert.match(stderr, /^warning: there is no path between 1 pair of points.*\n1 path, of length /);
});

test('--units: a unit of length, or a factor', () => {
  const area = (units) =>
    JSON.parse(succeeds(`info shape.glb --json --units ${units}`).stdout).area;
  const { scale, unit, ...facts } = JSON.parse(succeeds('info shape.glb --json').stdout);
  assert.deepEqual([scale, unit, facts.area], [1, 'm', area('m')]);
  near(area('cm') / area('m'), 1e4, 1e-6);
  near(area('0.5') / area('m'), 0.25, 1e-9);
  for (const units of ['parsec', '0', '-1', 'Infinity', 'toString']) {
    fails(2, `info shape.glb --units=${units}`, /--units/);
  }
});

test('--limits: what a glTF may ask for', () => {
  fails(1, 'info shape.glb --limits maxTriangles=7', /raise the limit maxTriangles/);
  succeeds('info shape.glb --limits maxTriangles=8,maxVertices=6');
  fails(2, 'info shape.glb --limits maxTriangles=8=9', /--limits maxTriangles.*8=9/);
  for (const limits of ['triangles=7', 'maxTriangles', 'maxTriangles=', 'maxTriangles=-1', '7'])
    fails(2, `info shape.glb --limits=${limits}`, /--limits/);
});

test('- is standard input, for one file', () => {
  const bytes = glb(octahedron());
  assert.match(succeeds('info -', bytes).stdout, /^format +glTF\ntriangles +8/);
  succeeds('diagram shape.glb --sites -', '{"vertex": [1]}');
  fails(2, 'diagram - --sites -', /standard input/, bytes);
});

test('a .gltf finds its buffer in its folder, and nothing outside', () => {
  const put = (name, uri) => {
    const { json, buffer } = gltf(octahedron(), { uri });
    write(name, JSON.stringify(json));
    return buffer;
  };
  mkdirSync(join(folder, 'data'));
  write('data/a shape.bin', put('shape.gltf', 'data/a%20shape.bin'));
  assert.match(succeeds('info shape.gltf').stdout, /triangles +8/);
  assert.match(run('info -', read('shape.gltf')).stderr, /data\/a%20shape\.bin/);
  write('__proto__', put('shape.gltf', '__proto__'));
  assert.match(succeeds('info shape.gltf').stdout, /triangles +8/);

  write('secret.bin', put('data/shape.gltf', '../secret.bin'));
  fails(1, 'info data/shape.gltf', /\.\.\/secret\.bin.*outside/);
  put('data/shape.gltf', '%2e%2e/secret.bin');
  fails(1, 'info data/shape.gltf', /outside/);
  put('data/shape.gltf', join(folder, 'secret.bin'));
  fails(1, 'info data/shape.gltf', /outside/);
  put('data/shape.gltf', 'https://example.com/shape.bin');
  fails(1, 'info data/shape.gltf', /outside/);
  put('data/shape.gltf', 'missing.bin');
  fails(1, 'info data/shape.gltf', /missing\.bin.*missing/);
});

test('a model of another format, a folder, a zip', () => {
  write('shape.stl', meshBinaryStl(octahedron()));
  write('shape.obj', meshObj(octahedron()));
  const distances = (args) => JSON.parse(succeeds(`distances ${args} --sites sites.json`).stdout);
  const { unit, ...known } = distances('shape.glb');
  assert.equal(unit, 'm');
  assert.deepEqual(distances('shape.obj'), known, 'an OBJ has no unit');
  assert.deepEqual(distances('shape.obj --units m'), { ...known, unit });
  assert.equal(distances('shape.glb --units 100').unit, undefined);
  assert.match(succeeds('info shape.glb').stdout, /diagonal +3\.4641 m\n/);
  assert.match(succeeds('info shape.obj').stdout, /diagonal +3\.4641\n/);
  const inCentimetres = succeeds('info shape.obj --units cm');
  assert.match(inCentimetres.stdout, /diagonal +346\.41 cm\n/);
  assert.match(inCentimetres.stderr, /^note: OBJ has no unit: .* taken for metres/);
  succeeds('partition shape.stl --sites 3 -o parts.glb');
  assert.match(succeeds('info shape.stl').stdout, /^format +STL \(shape\.stl\)\n/);
  assert.match(succeeds('info -', meshObj(octahedron())).stdout, /^format +OBJ/);

  const { json, buffer } = gltf(octahedron(), { uri: 'data/shape.bin' });
  const files = {
    'model/scene.gltf': Buffer.from(JSON.stringify(json)),
    'model/data/shape.bin': buffer,
  };
  mkdirSync(join(folder, 'model', 'data'), { recursive: true });
  for (const [name, content] of Object.entries(files)) write(name, content);
  write('model.zip', zipSync(files));
  assert.match(succeeds('info model').stdout, /^format +glTF \(scene\.gltf\)\n.*triangles +8/s);
  assert.match(succeeds('info model.zip').stdout, /^format +glTF \(model\/scene\.gltf\)\n/);
  write('stored.zip', zipSync({ 'shape.obj': [meshObj(octahedron()), { level: 0 }] }));
  assert.match(succeeds('info stored.zip').stdout, /^format +OBJ \(shape\.obj\)\n.*triangles +8/s);

  // Links lead anywhere.
  rmSync(join(folder, 'model', 'data', 'shape.bin'));
  symlinkSync(join(folder, 'shape.glb'), join(folder, 'model', 'data', 'shape.bin'));
  fails(1, 'info model/scene.gltf', /shape\.bin is a link to a place outside the model's folder/);
  fails(1, 'info model', /needs the file "data\/shape\.bin".*missing/);
  write('broken.zip', zipSync(files).subarray(50));
  fails(1, 'info broken.zip', /broken\.zip: .*zip/);
});

test('a wrong command line: status 2', () => {
  fails(2, 'draw shape.glb', /draw.*info, diagram, locate/);
  fails(2, 'info', /mesh/);
  fails(2, 'dual shape.glb two.glb --sites 3', /two\.glb/);
  fails(2, 'info shape.glb --sites 3', /--sites/);
  fails(2, 'diagram shape.glb', /--sites/);
  fails(2, 'diagram shape.glb --sites', /--sites/);
  for (const count of ['0', '-3', '1.5', 'Infinity']) {
    fails(2, `diagram shape.glb --sites=${count}`, /--sites/);
  }
  fails(2, 'diagram shape.glb --sites 3 --seed -1', /--seed/);
  fails(2, 'diagram shape.glb --sites 3 --seed=-1', /--seed/);
  fails(2, 'diagram shape.glb --sites 3 --detail 11', /--detail/);
  fails(2, 'diagram shape.glb --sites 3 --metric euclid', /euclid.*exact, dgpc/);
  fails(2, 'diagram shape.glb --sites 3 --sampling blue', /blue.*random, farthest, poisson/);
  fails(2, 'cvt shape.glb --sites 3 --method newton', /newton.*lloyd, lbfgs/);
  fails(2, 'cvt shape.glb --sites 3 --metric far', /far.*exact, dgpc/);
  fails(2, 'cvt shape.glb --sites 3 --iterations -1', /--iterations/);
  fails(2, 'cvt shape.glb', /--sites N\|FILE or --radius LENGTH is missing/);
  fails(2, 'diagram shape.glb --sites 3 -o d.stl', /d\.stl.*\.json, \.obj, \.glb/);
  fails(2, 'partition shape.glb --sites 3 --layout heap -o d.glb', /heap.*regions, features/);
  fails(2, 'partition shape.glb --sites 3 -o d.off', /d\.off.*\.json, \.glb, \.obj, \.ply, \.stl/);
  fails(2, 'remesh shape.glb --sites 3 --detail 2', /--detail/);
  fails(2, 'dual shape.glb --sites 3 --max-added 2', /--max-added.*--repair is missing/);
  fails(2, 'info shape.glb -o x.ply', /the ending of 'x\.ply' is not one of \.json, \.txt/);
  fails(2, 'remesh shape.glb', /--sites N\|FILE or --radius LENGTH is missing/);
  fails(2, 'locate shape.glb --sites 3', /--points/);
  fails(2, 'distances shape.glb', /--sites N\|FILE or --radius LENGTH is missing/);
  fails(2, 'distances shape.glb --sites 3 -o d.obj', /d\.obj.*\.json, \.csv, \.ply, \.glb/);
  fails(2, 'distances shape.glb --sites 3 --detail 1', /--detail/);
  fails(2, 'path shape.glb --from sites.json', /--to is missing/);
  fails(2, 'path shape.glb --from sites.json --to sites.json -o p.glb', /p\.glb.*\.json, \.obj/);
});

test('bad input: status 1, one line, no file', () => {
  write('broken.glb', glb(octahedron()).subarray(0, 300));
  write('sites.txt', 'one, two');
  write('many.json', '[1, 2]');
  write('outside.json', '{"face": [8], "bary": [1, 0, 0]}');
  fails(1, 'info nowhere.glb', /nowhere\.glb.*no such file/);
  fails(
    1,
    'info .',
    /shape\.glb and two\.glb are several models: choose one by its path, as \.#PATH\n$/,
  );
  const { json } = gltf(octahedron(), { uri: '.' });
  fails(1, 'info -', /the file cannot be read: it refers to itself/, JSON.stringify(json));
  mkdirSync(join(folder, 'empty'));
  fails(1, 'info empty', /there is no model: there are no files/);
  fails(1, 'info /dev/zero', /is a device/);
  fails(1, 'info sites.json', /sites\.json/);
  fails(1, 'diagram broken.glb --sites 3 -o d.json', /broken\.glb/);
  fails(1, 'diagram shape.glb --sites nowhere.json -o d.json', /nowhere\.json/);
  fails(
    1,
    'diagram shape.glb --sites sites.txt -o d.json',
    /sites\.txt: line 1 is neither three numbers nor names with x, y and z: "one two"/,
  );
  write('nothing.csv', '\n');
  fails(1, 'diagram shape.glb --sites nothing.csv -o d.json', /nothing\.csv: the file is empty/);
  write('names.csv', 'x,y,z\n');
  fails(1, 'diagram shape.glb --sites names.csv -o d.json', /names\.csv: it has no points/);
  write('half.json', '{"vertex": [0');
  fails(1, 'diagram shape.glb --sites half.json -o d.json', /half\.json: it is no JSON .*: \S/);
  fails(1, 'diagram shape.glb --sites many.json -o d.json', /many\.json/);
  fails(1, 'diagram shape.glb --sites outside.json -o d.json', /8/);
  write('three.json', '{"vertex": [0, 1, 2]}');
  fails(1, 'path shape.glb --from three.json --to sites.json -o p.json', /3 points.*2 to end/);
  fails(1, 'path shape.glb --from sites.json --to three.json -o p.json', /2 points.*3 to end/);
  fails(1, 'diagram shape.glb --sites 3 -o nowhere/d.json', /nowhere.*no such file or folder/);
  mkdirSync(join(folder, 'taken.json'));
  fails(1, 'diagram shape.glb --sites 3 -o taken.json', /taken\.json.*folder/);
});

test('a file that is there stays as it was when the command fails', () => {
  write('d.json', 'old');
  write('outside.json', '{"face": [8], "bary": [1, 0, 0]}');
  fails(1, 'diagram shape.glb --sites outside.json -o d.json', /8/);
  assert.equal(read('d.json'), 'old');
  succeeds('diagram shape.glb --sites 2 -o d.json');
  assert.notEqual(read('d.json'), 'old');
});

test('progress is shown when asked for, and never on standard output', () => {
  const { stdout, stderr } = succeeds('diagram shape.glb --sites 1 --progress');
  assert.match(stderr, /100%\n$/);
  assert.doesNotMatch(stdout, /%/);
  assert.equal(succeeds('diagram shape.glb --sites 1').stderr, '');
});
