// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, beforeEach, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { zipSync } from 'fflate';
import { parseCommandLine } from '../../dist/cli/command_line.js';
import { commands } from '../../dist/cli/options.js';
import { assertValidGlb, readPly } from './files.mjs';
import { apart, glb, gltf, grid, octahedron, withFlipped } from './meshes.mjs';
import { meshBinaryStl, meshObj } from './model_files.mjs';

const main = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));
let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
});
after(() => rmSync(folder, { recursive: true }));
beforeEach(() => {
  rmSync(folder, { recursive: true });
  mkdirSync(folder);
  write('shape.glb', glb(octahedron()));
  write('two.glb', glb(apart(octahedron(), grid(1))));
  write('sites.json', '{"vertex": [0, 3]}');
  write('points.json', '{"face": [0, 1], "bary": [1, 0, 0, 0, 1, 0]}');
});

const write = (name, content) => writeFileSync(join(folder, name), content);
const read = (name) => readFileSync(join(folder, name), 'utf8');

/** Runs the command in the folder; `input` goes to its standard input. */
function run(args, input) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [main, ...args.split(' ')], {
    cwd: folder,
    input,
    encoding: 'utf8',
  });
  return { status, stdout, stderr };
}

function succeeds(args, input) {
  const { status, stdout, stderr } = run(args, input);
  assert.equal(status, 0, stderr);
  return { stdout, stderr };
}

/** One line on standard error, nothing on standard output, no file that was not there. */
function fails(status, args, message, input) {
  const before = readdirSync(folder);
  const result = run(args, input);
  assert.match(result.stderr, /^geodesic-voronoi: [^\n]+\n$/);
  assert.match(result.stderr, message);
  assert.equal(result.status, status, result.stderr);
  assert.equal(result.stdout, '');
  assert.deepEqual(readdirSync(folder), before);
}

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
  fails(2, 'diagram shape.glb --sites 3 --quiet=no', /--quiet is 'no', and takes no value\n$/);
});

test('sites and points by their coordinates', () => {
  write('places.json', '{"position": [1, 0, 0, 0, 2, 0]}');
  write('corners.json', '{"vertex": [0, 2]}');
  const { stderr } = succeeds('diagram shape.glb --sites places.json --units cm -o d.json');
  assert.match(stderr, /^note: the farthest of 2 places is 100\.0 from the surface\n2 regions/);
  assert.equal(succeeds('diagram shape.glb --sites places.json -q -o d.json').stderr, '');
  const one = succeeds('diagram shape.glb --sites {"position":[0,0,2]} -o d.json').stderr;
  assert.match(one, /^note: the place is 1\.000 from the surface\n/);
  const far = succeeds('diagram shape.glb --sites {"position":[0,0,1000]} -q -o d.json').stderr;
  assert.equal(far, 'warning: the place is 999.0 from the surface\n');
  const located = JSON.parse(
    succeeds('locate shape.glb --sites places.json --points places.json').stdout,
  );
  const rest = { mesh: { faces: 8 }, scale: 1, unit: 'm' };
  assert.deepEqual(located, { ...rest, label: [0, 1], distance: [0, 0] });
  const [{ length }] = JSON.parse(
    succeeds('path shape.glb --from places.json --to places.json').stdout,
  ).paths;
  assert.equal(length, 0);
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

test('--max-edge, --weld, --orientation and --min-component: how the mesh is made', () => {
  const { positions, indices } = octahedron();
  const torn = indices.flatMap((v, i) =>
    positions.slice(3 * v, 3 * v + 3).map((x) => x + 1e-6 * (i % 3)),
  );
  write('torn.obj', meshObj({ positions: torn, indices: indices.map((_, i) => i) }));
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
    /repair: 3 edges cut because their two triangles disagree in orientation\n/,
  );

  const finer = succeeds('info shape.glb --max-edge 0.2').stdout;
  assert.match(
    finer,
    /triangles +128 \(128 in the subdivided file\)[^]*note: long edges were halved: 8 triangles became 128/,
  );
  fails(2, 'info shape.glb --max-edge=2', /^geodesic-voronoi: --max-edge/);
  fails(1, 'info shape.glb --max-edge 1e-9', /there would be more than 16777216 triangles/);

  // Sites of the whole mesh stay where they are; others are refused.
  const placesOf = (file) => JSON.parse(read(file)).position;
  succeeds('cvt shape.glb --sites 3 --iterations 0 -o whole.json');
  succeeds('cvt shape.glb --sites whole.json --max-edge 0.2 --iterations 0 -o finer.json');
  placesOf('finer.json').forEach((x, i) => {
    assert.ok(Math.abs(x - placesOf('whole.json')[i]) < 1e-12);
  });
  fails(1, 'diagram two.glb --sites finer.json --max-edge 0.2', /belong to another mesh/);

  const large = succeeds('info two.glb --min-component 3').stdout;
  assert.match(large, /components +1\n[^]*repair: 1 component .*\nrepair: 2 triangles of these/);
  succeeds('partition two.glb --min-component 3 --sites 3 --sampling farthest -o parts.glb');
  assertValidGlb(readFileSync(join(folder, 'parts.glb')));
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

test('components without a site are told of; --per-component puts some there', () => {
  const note = /^note: 1 of 2 components, (13|87) % of the area, have no site/;
  assert.match(succeeds('diagram two.glb --sites 1 -o d.json').stderr, note);
  assert.match(succeeds('cvt two.glb --sites sites.json -o s.json').stderr, note);
  assert.equal(succeeds('diagram two.glb --sites 1 -o d.json --quiet').stderr, '');
  for (const sites of ['1', 'sites.json']) {
    const { stderr } = succeeds(`diagram two.glb --sites ${sites} -o d.json`);
    const [, advice] = /^note: .* have no site \((.*) samples one on each\)/.exec(stderr);
    assert.doesNotMatch(succeeds(`diagram two.glb ${advice} -o d.json`).stderr, note);
  }
  for (const sites of ['--sites 4 --per-component 2', '--radius 9 --per-component 1']) {
    const { stderr } = succeeds(`diagram two.glb ${sites} -o d.json`);
    assert.match(stderr, /^(note: faces .*\n)?\d regions/);
  }
  fails(
    1,
    'diagram two.glb --sites 3 --per-component 2 -o d.json',
    /2 per component, of which the mesh has 2, makes 4 sites/,
  );
  fails(2, 'diagram two.glb --sites sites.json --per-component 1', /--per-component/);
});

test('sites at one place are told of; sites of a file are not sampled', () => {
  write('same.json', '{"vertex": [0, 0, 5]}');
  const { stderr } = succeeds('diagram shape.glb --sites same.json -o d.json');
  assert.match(stderr, /^note: 1 site without a region: another site is at the same place\n/);
  fails(
    2,
    'diagram shape.glb --sites same.json --sampling poisson',
    /--sampling is for sites that/,
  );
  fails(2, 'diagram shape.glb --sites same.json --seed 2', /--seed is for sites that are sampled/);
  fails(2, 'diagram shape.glb --sites same.json --per-component 0', /--per-component is for sites/);
});

test('edges that are cut are told of', () => {
  write('fin.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n');
  const { stderr } = succeeds('distances fin.obj --sites {"vertex":[2]} -o d.json');
  assert.match(stderr, /^note: 1 edge of three or more triangles is cut apart: distances do not/);

  write('turned.glb', glb(withFlipped(octahedron(), 2)));
  const note =
    /^note: 3 edges of two triangles that disagree in orientation are cut apart: distances do not lead across\n/;
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
    /^note: at 1 vertex parts of the surface touch: distances do not lead across\n/m,
  );
  const none = succeeds(
    'path hourglass.glb --from {"vertex":0} --to {"vertex":[1,4]} -o p.json',
  ).stderr;
  assert.match(none, /no path between 1 pair of points: .* \(info tells where it is cut apart\)/);
});

test('results name their mesh, so that their sites are not taken for those of another', () => {
  write('grid.glb', glb(grid(4)));
  for (const command of ['diagram', 'partition', 'distances', 'dual', 'cvt', 'remesh']) {
    succeeds(`${command} shape.glb --sites 30 --quiet -o result.json`);
    assert.deepEqual(JSON.parse(read('result.json')).mesh, { faces: 8 }, command);
    fails(
      1,
      'diagram grid.glb --sites result.json',
      /another mesh: to one with 8 triangles, not 32/,
    );
  }
});

test('a path that does not exist is told of', () => {
  const { stderr } = succeeds(
    'path two.glb --from {"vertex":[0,0]} --to {"vertex":[1,6]} -o path.json',
  );
  assert.match(stderr, /^warning: there is no path between 1 pair of points.*\n1 path, of length /);
});

test('--radius: as many sites as it takes, in the unit of the output', () => {
  write('grid.glb', glb(grid(20)));
  const count = (args) =>
    JSON.parse(succeeds(`diagram grid.glb ${args} --json`).stdout).sites.face.length;
  const [few, many] = [count('--radius 0.5'), count('--radius 0.1')];
  assert.ok(few < many);
  assert.equal(count('--radius 10 --units cm'), many);
  assert.ok(count('--radius 0.1 --sampling poisson') > few);
  fails(2, 'diagram grid.glb --radius 1 --sites 3', /--radius/);
  fails(2, 'diagram grid.glb --radius 1 --sampling distortion', /--sampling distortion/);
  for (const radius of ['0', '-1', 'wide', 'Infinity'])
    fails(2, `diagram grid.glb --radius=${radius}`, /--radius/);
});

test('--units: a unit of length, or a factor', () => {
  const area = (units) =>
    JSON.parse(succeeds(`info shape.glb --json --units ${units}`).stdout).area;
  const { scale, unit, ...facts } = JSON.parse(succeeds('info shape.glb --json').stdout);
  assert.deepEqual([scale, unit, facts.area], [1, 'm', area('m')]);
  assert.ok(Math.abs(area('cm') / area('m') - 1e4) < 1e-6);
  assert.ok(Math.abs(area('0.5') / area('m') - 0.25) < 1e-9);
  for (const units of ['parsec', '0', '-1', 'Infinity', 'toString']) {
    fails(2, `info shape.glb --units=${units}`, /--units/);
  }
});

test('--limits: what a glTF may ask for', () => {
  fails(1, 'info shape.glb --limits maxTriangles=7', /raise the limit maxTriangles/);
  succeeds('info shape.glb --limits maxTriangles=8,maxVertices=6');
  for (const limits of ['triangles=7', 'maxTriangles', 'maxTriangles=', 'maxTriangles=-1', '7'])
    fails(2, `info shape.glb --limits=${limits}`, /--limits/);
});

test('diagram as JSON, to a file or to standard output', () => {
  const { stderr } = succeeds('diagram shape.glb --sites 5 --seed 7 -o d.json');
  assert.match(
    stderr,
    /^note: faces are too coarse: about \d.* % of the area lies .*--max-edge 0\.\d --detail 1 .*\n5 regions, \d+ bisector arcs, \d+ Voronoi points\n$/,
  );
  const single = succeeds('diagram shape.glb --sites 1 -o one.json').stderr;
  assert.match(single, /^1 region, 0 bisector arcs, 0 Voronoi points\n$/);
  const json = JSON.parse(read('d.json'));
  assert.equal(json.regions.length, 5);
  assert.equal(json.sites.face.length, 5);
  assert.deepEqual([json.metric, json.scale, json.unit], ['exact', 1, 'm']);
  const again = succeeds('diagram shape.glb --sites 5 --seed 7 -o -');
  assert.equal(again.stdout, read('d.json'));
  assert.match(again.stderr, /^note: [^\n]*\n$/);
  const other = succeeds('diagram shape.glb --sites 5');
  assert.notEqual(other.stdout, again.stdout);
  succeeds('diagram shape.glb --sites 5 --json -o d.txt --quiet');
  assert.equal(read('d.txt'), other.stdout);
});

test('cvt writes sites that other commands read, and the energy of every iteration', () => {
  const { stderr } = succeeds('cvt shape.glb --sites 5 --iterations 6 -o c.json');
  assert.match(
    stderr,
    /^5 sites, 6 iterations \(no more were allowed\), energy [\d.]+ to [\d.]+\n$/,
  );
  const { mesh, face, bary, position, energy } = JSON.parse(read('c.json'));
  assert.deepEqual(mesh, { faces: 8 });
  assert.equal(face.length, 5);
  assert.equal(bary.length, 15);
  assert.equal(position.length, 15);
  energy.slice(1).forEach((e, i) => assert.ok(e <= energy[i] * (1 + 1e-12)));
  succeeds('diagram shape.glb --sites c.json');

  const lloyd = JSON.parse(
    succeeds('cvt shape.glb --sites 5 --iterations 1 --method lloyd --units cm').stdout,
  );
  assert.equal(lloyd.energy.length, 2);
  assert.ok(Math.abs(lloyd.energy[0] / energy[0] / 1e8 - 1) < 1e-12);

  const exact = JSON.parse(
    succeeds('cvt shape.glb --sites 5 --iterations 1 --metric exact').stdout,
  );
  assert.ok(exact.energy[1] < exact.energy[0]);
  const single = succeeds('cvt shape.glb --sites 1 --iterations 1 -o one.json').stderr;
  assert.match(single, /^1 site, [01] iterations?( |,)/);
  succeeds('remesh shape.glb --sites 20 --iterations 1 --metric exact -o remesh.obj');

  const soon = succeeds(
    'cvt shape.glb --sites 5 --energy-tolerance 0.01 --units cm -o c.ply',
  ).stderr;
  assert.match(soon, /^5 sites, \d+ iterations, energy/);
  assert.match(read('c.ply'), /^ply\n[^]*element vertex 5\nproperty double x/);
  const again = succeeds('cvt shape.glb --sites c.ply --iterations 0 -o again.json').stderr;
  assert.doesNotMatch(again, /from the surface/, 'coordinates are in the unit of the model');
  // One millimetre, of moves that are given in centimetres: the same as a thousandth of a metre.
  const ended = (options) =>
    JSON.parse(succeeds(`cvt shape.glb --sites 5 ${options}`).stdout).energy.length;
  assert.equal(ended('--move-tolerance 0.1 --units cm'), ended('--move-tolerance 0.001'));
  assert.ok(ended('--move-tolerance 0.1') < ended('--move-tolerance 0.001'));
  fails(2, 'cvt shape.glb --sites 5 --move-tolerance -1', /--move-tolerance is '-1', not a number/);
  fails(2, 'cvt shape.glb --sites 5 -o c.obj', /ending of 'c\.obj' is not one of \.json, \.ply/);
});

test('random sites are spread by the density', () => {
  write('left.json', JSON.stringify([1, 0, 0, 0, 0, 0]));
  const spread = (options) =>
    JSON.parse(succeeds(`cvt shape.glb --sites 200 --iterations 0 ${options}`).stdout).position;
  const meanX = (position) =>
    position.reduce((sum, x, i) => sum + (i % 3 === 0 ? x : 0), 0) / (position.length / 3);
  assert.ok(Math.abs(meanX(spread('--seed 2'))) < 0.1);
  assert.ok(meanX(spread('--density left.json')) > 0.4);
});

test('a density that would have no effect on the sites is refused', () => {
  write('left.json', JSON.stringify([1, 0, 0, 0, 0, 0]));
  for (const command of ['cvt', 'remesh']) {
    const poisson = `${command} shape.glb --sites 20 --sampling poisson --density left.json`;
    fails(2, `${poisson} --iterations 0`, /--sampling poisson does not follow it\n$/);
    const radius = `${command} shape.glb --radius 0.5 --density curvature --iterations 0`;
    fails(2, radius, /--iterations 0, --radius does not follow it\n$/);
  }
  const cvt = 'cvt shape.glb --density left.json';
  succeeds(`${cvt} --sites 20 --sampling poisson --iterations 1`);
  // The energy of sites from a file depends on the density.
  succeeds(`${cvt} --sites sites.json --iterations 0`);
});

test('sites from a PLY and a CSV of places', () => {
  succeeds('cvt shape.glb --sites 4 --iterations 0 -q -o four.json');
  succeeds('cvt shape.glb --sites 4 --iterations 0 -q -o four.ply');
  const { position } = JSON.parse(read('four.json'));
  const rows = [0, 1, 2, 3].map((i) => position.slice(3 * i, 3 * i + 3));
  write('four.csv', rows.map((row) => `${row.join(', ')}\n`).join(''));
  const named = rows.map(([x, y, z], i) => `${i};${z};${x};${y}`);
  write('named.csv', ['# measured', '"id";"Z";"X";"Y"', ...named].join('\r\n'));
  const quoted = rows.map(([x, y, z], i) => `"a, ""${i}""; b",7,"${x}", ${y} ,"${z}"`);
  write('quoted.csv', ['name of it,"weight",x,"y", "z"', ...quoted].join('\n'));
  // As pandas writes a table.
  write('indexed.csv', [',z,x,y', ...rows.map(([x, y, z], i) => `${i},${z},${x},${y}`)].join('\n'));
  write('blanks.xyz', rows.map((row) => ` ${row.join('  \t')} 1\n`).join('\n'));
  const areas = (sites) => {
    const { regions } = JSON.parse(succeeds(`diagram shape.glb --sites ${sites} -q`).stdout);
    return regions.map(({ area }) => area.toFixed(9));
  };
  const expected = areas('four.json');
  for (const sites of [
    'four.ply',
    'four.csv',
    'named.csv',
    'quoted.csv',
    'indexed.csv',
    'blanks.xyz',
  ])
    assert.deepEqual(areas(sites), expected);
  // Standard input has no ending.
  for (const file of ['four.json', 'four.ply', 'named.csv', 'blanks.xyz']) {
    const input = readFileSync(join(folder, file));
    const { regions } = JSON.parse(succeeds('diagram shape.glb --sites - -q', input).stdout);
    assert.deepEqual(
      regions.map(({ area }) => area.toFixed(9)),
      expected,
    );
  }

  for (const [content, message] of [
    ['1, 2, 3\n1, 2', /bad\.csv: line 2: z is missing\n$/],
    ['x,y,z\n1,2,three', /bad\.csv: line 2: z is 'three', not a number\n$/],
    ['x,y\n1,2', /bad\.csv: line 1 is neither three numbers nor names with x, y and z: "x y"\n$/],
    [
      '0,0,nan',
      /bad\.csv: line 1 is neither three numbers nor names with x, y and z: "0 0 nan"\n$/,
    ],
  ]) {
    write('bad.csv', content);
    fails(1, 'diagram shape.glb --sites bad.csv', message);
  }
  write('bad.ply', 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n2\n');
  fails(1, 'diagram shape.glb --sites bad.ply', /bad\.ply: the PLY's vertices have no y\n$/);
});

test('points as JSON in place of a file, and named in errors', () => {
  const path = `path shape.glb --from {"vertex":0} --to`;
  assert.equal(JSON.parse(succeeds(`${path} {"vertex":[0]}`).stdout).paths[0].length, 0);
  fails(1, `${path} {"vertex":9}`, /\{"vertex":9\}: point 0: there is no vertex 9\n$/);
  fails(1, `${path} {"position":[[0,0,0]]}`, /position\[0\] is a list: all numbers go into one/);
  write('bad.json', '{"face": [0, 8], "bary": [1, 0, 0, 1, 0, 0]}');
  fails(1, 'locate shape.glb --sites 2 --points bad.json', /bad\.json: point 1: there is no tri/);
  succeeds('cvt two.glb --sites 2 -o two.json');
  fails(1, 'distances shape.glb --sites two.json -o d.ply', /two\.json.*10 triangles, not 8/);
  fails(1, `${path} 0`, /there is no file 0; a vertex is given as '\{"vertex": 0\}'\n$/);
  const both = '{"vertex":[0],"face":[0],"bary":[1,0,0]}';
  fails(1, `${path} ${both}`, /: points has both vertex and face: only one can say where/);
  const other = '{"vertex":[1],"position":[0,0,0]}';
  fails(1, `${path} ${other}`, /: points has both vertex and position: only one can say where/);
  fails(1, `locate shape.glb --sites ${other} --points {"vertex":1}`, /both vertex and position/);
});

test('a note where there are fewer vertices than sites to be', () => {
  const { stderr } = succeeds(
    'cvt shape.glb --sites 50 --sampling farthest --iterations 0 -o c.json',
  );
  assert.match(stderr, /^note: 7 of 50 sites: every vertex has one\n/);
});

test('cvt with sites that stay, and with a density', () => {
  write('fixed.json', '[1, 3]');
  const before = JSON.parse(succeeds('cvt shape.glb --sites 5 --iterations 0').stdout);
  const after = JSON.parse(succeeds('cvt shape.glb --sites 5 --fixed-sites fixed.json').stdout);
  const moved = before.face.flatMap((face, i) =>
    face === after.face[i] && before.bary[3 * i] === after.bary[3 * i] ? [] : [i],
  );
  assert.deepEqual(moved, [0, 2, 4]);

  write('each.json', JSON.stringify(Array.from({ length: 6 }, (_, v) => v + 1)));
  const finer = `cvt shape.glb --sites 5 --max-edge 0.2 --iterations 2`;
  const spread = succeeds(`${finer} --density each.json`).stdout;
  assert.notEqual(spread, succeeds(finer).stdout);

  write('few.json', '[1, 1]');
  write('object.json', '{}');
  fails(1, 'cvt shape.glb --sites 5 --density few.json', /2 densities for \d+ input vertices/);
  fails(1, 'cvt shape.glb --sites 5 --density object.json', /object\.json holds no list/);
  write('beyond.json', '[9]');
  fails(1, 'cvt shape.glb --sites 5 --fixed-sites beyond.json', /site 9/);
});

test('partition as GLB, OBJ, PLY and JSON', () => {
  const { stderr } = succeeds('partition shape.glb --sites 5 -o parts.glb');
  assert.match(stderr, /^5 regions, \d of them disks, \d+ triangles\n$/);
  const json = JSON.parse(succeeds('partition shape.glb --sites 5 --units cm').stdout);
  const area = JSON.parse(succeeds('info shape.glb --json').stdout).area;
  const areas = json.regions.reduce((sum, region) => sum + region.area, 0);
  assert.ok(Math.abs(areas / area / 1e4 - 1) < 1e-12);
  const parts = JSON.parse(succeeds('info parts.glb --json').stdout);
  assert.equal(parts.faces, json.triangles.label.length);
  assert.deepEqual(
    parts.parts.map(({ name, triangleCount }) => [name, triangleCount]),
    json.regions.map(({ triangleCount }, i) => [`region ${i}`, triangleCount]),
  );
  succeeds('partition shape.glb --sites 5 --layout features -o ids.glb');
  assert.match(read('ids.glb'), /_FEATURE_ID_0/);
  succeeds('partition shape.glb --sites 5 --leave-out-indifferent -o parts.obj');
  assert.equal(read('parts.obj').match(/^g region_/gm).length, 5);
  succeeds('partition shape.glb --sites 5 -o parts.ply');
  assert.match(read('parts.ply'), /^ply\n[^]*property int label\nproperty uchar red\n/);
  succeeds('diagram shape.glb --sites 5 -o d.json');
  assert.deepEqual(JSON.parse(read('d.json')).sites, json.sites);
});

test('a partition leaves out the components without a site when asked to', () => {
  write('corner.json', JSON.stringify({ vertex: [0] }));
  const labels = (command) => JSON.parse(succeeds(command).stdout).triangles.label;
  assert.ok(labels('partition two.glb --sites corner.json').includes(-1));
  const reached = labels('partition two.glb --sites corner.json --leave-out-unreachable');
  assert.ok(reached.length > 0 && !reached.includes(-1));
});

test('dual says what is wrong with it, and can be repaired', () => {
  const { stderr } = succeeds('dual shape.glb --sites sites.json -o base.obj');
  assert.match(
    stderr,
    /^2 sites, 0 vertices[^\n]*\nnot valid: regions 0 and 1 meet[^\n]*\nnote: --repair adds sites until it is valid\n$/,
  );
  const warning = /^warning: the dual is not valid: regions 0 and 1 meet.* \(--repair .*\)\n$/;
  assert.match(succeeds('dual shape.glb --sites sites.json -q -o base.obj').stderr, warning);
  rmSync(join(folder, 'base.obj'));
  fails(
    1,
    'dual shape.glb --sites sites.json --check -o base.obj',
    /the dual is not valid: regions/,
  );
  succeeds('dual shape.glb --sites sites.json --repair --check -q -o base.obj');
  succeeds('dual shape.glb --sites sites.json --repair -q -o base.stl');
  assert.match(succeeds('info base.stl').stdout, /^format +STL.*\n[^]*boundary loops +0\n/);
  const repaired = succeeds('dual shape.glb --sites sites.json --repair -o base.json').stderr;
  assert.match(repaired, /^\d sites \(\d added\).*Euler characteristic 2, genus 0, 0 boundary/);
  assert.doesNotMatch(repaired, /not valid/);
  const { sites, faces, topology, violations } = JSON.parse(read('base.json'));
  assert.deepEqual(sites.face.slice(0, 2), [0, 1]);
  assert.equal(topology.eulerCharacteristic, 2);
  assert.deepEqual(violations, []);
  // Its sites are sites for another one.
  succeeds('dual shape.glb --sites base.json -o base.obj');
  assert.equal(read('base.obj').match(/^f /gm).length, faces.length);
  succeeds('dual shape.glb --sites base.json --primal -o regions.obj');
  assert.equal(read('regions.obj').match(/^g region_/gm).length, sites.face.length);
  for (const ending of ['glb', 'ply'])
    succeeds(`dual shape.glb --sites base.json -o base.${ending}`);
  assert.match(succeeds('info base.glb').stdout, /Euler characteristic +2\n/);
});

test('a repair that would take too many sites says what helps on a mesh of many components', () => {
  const shards = Array.from(
    { length: 400 },
    (_, i) => `v ${i} 0 0\nv ${i} 1 0\nv ${i} 0 1\nf -3 -2 -1\n`,
  );
  write('shards.obj', shards.join(''));
  const hint = /boundary passes.* 400 components: --min-component [^:]* --per-component 3/;
  for (const command of ['dual --repair', 'remesh --iterations 0']) {
    const [name, ...options] = command.split(' ');
    fails(1, `${name} shards.obj --sites 1 -q ${options.join(' ')} -o b.obj`, hint);
  }
});

test('remesh tells its quality', () => {
  const { stderr } = succeeds('remesh shape.glb --sites 20 --iterations 5 -o fine.obj');
  assert.match(stderr, /genus 0[^]*least angle [\d.]+°[^]*valence \d to \d[^]*Hausdorff distance/);
  const { quality, topology } = JSON.parse(
    succeeds('remesh shape.glb --sites 20 --iterations 5 --units 10').stdout,
  );
  assert.equal(topology.isManifold, true);
  assert.ok(quality.minAngle > 0 && quality.hausdorff > 0);
});

test('remesh with a density, and with sites that stay', () => {
  const args = 'remesh two.glb --sites 20 --per-component 6 --iterations 4';
  assert.notEqual(succeeds(args).stdout, succeeds(`${args} --density curvature`).stdout);
  write('fixed.json', '[0]');
  const first = JSON.parse(succeeds('cvt shape.glb --sites 12 --iterations 0').stdout);
  const { sites } = JSON.parse(
    succeeds('remesh shape.glb --sites 12 --iterations 4 --fixed-sites fixed.json').stdout,
  );
  assert.deepEqual(sites.bary.slice(0, 3), first.bary.slice(0, 3));
  assert.notDeepEqual(sites.bary.slice(3, 6), first.bary.slice(3, 6));
});

test('tessellations tell that faces are too coarse', () => {
  const note =
    /^note: faces are too coarse: about .* energies and centroids are inaccurate \(--max-edge/m;
  write('grid.glb', glb(grid(5)));
  assert.match(succeeds('cvt shape.glb --sites 2 -o s.json').stderr, note);
  const ofPlane = succeeds('remesh grid.glb --sites 15 -o s.json').stderr;
  assert.doesNotMatch(ofPlane, note, 'squared distances in a plane are right between corners, too');
  assert.doesNotMatch(succeeds('cvt grid.glb --sites 1 -o s.json').stderr, /note/);
  const finer = succeeds('cvt shape.glb --sites 2 --max-edge 0.1 -o s.json').stderr;
  assert.doesNotMatch(finer, note);
  assert.equal(succeeds('cvt shape.glb --sites 2 -q -o s.json').stderr, '');
});

test('cvt by curvature', () => {
  const args = 'cvt two.glb --sites 9 --per-component 3 --iterations 2';
  assert.notEqual(succeeds(args).stdout, succeeds(`${args} --density curvature`).stdout);
});

test('cvt by the density of the file', () => {
  fails(1, 'cvt shape.glb --sites 2 --density attribute', /came without a density/);
});

test('sites are sampled in five ways', () => {
  const sampled = ['random', 'farthest', 'poisson', 'size', 'distortion'].map(
    (sampling) => succeeds(`diagram two.glb --sites 30 --sampling ${sampling}`).stdout,
  );
  assert.equal(new Set(sampled).size, 5);
});

test('diagram as OBJ and GLB', () => {
  succeeds('diagram shape.glb --sites sites.json -o lines.obj');
  assert.match(read('lines.obj'), /^l (\d+)( \d+)+ \1$/m); // the outline closes
  succeeds('diagram shape.glb --sites sites.json -o lines.glb');
  assert.match(read('lines.glb'), /^glTF/);
});

test('the sites of a diagram are sites for another', () => {
  succeeds('diagram shape.glb --sites 5 -o d.json');
  assert.equal(succeeds('diagram shape.glb --sites d.json').stdout, read('d.json'));
});

test('locate', () => {
  const { stdout } = succeeds('locate shape.glb --sites sites.json --points points.json');
  const located = { scale: 1, unit: 'm', label: [0, 1], distance: [0, 0] };
  assert.deepEqual(JSON.parse(stdout), { mesh: { faces: 8 }, ...located });
  write('points.json', '{"face": [0, 8], "bary": [0, 0, 1, 0, 1, 0]}');
  const far = JSON.parse(
    succeeds('locate shape.glb --sites sites.json --points sites.json --units 2').stdout,
  );
  assert.deepEqual(far.label, [0, 1]);
});

test('locate gives null for what no site reaches', () => {
  write('points.json', '{"vertex": [6, 2]}');
  const { stdout } = succeeds('locate two.glb --sites sites.json --points points.json');
  const { label, distance } = JSON.parse(stdout);
  assert.deepEqual(label, [-1, 0]);
  assert.equal(distance[0], null);
  assert.ok(distance[1] > 1);
});

test('distances as JSON, PLY and GLB', async () => {
  const { stderr } = succeeds('distances two.glb --sites sites.json -o d.json --units 2');
  assert.match(stderr, /^6 of 10 vertices reached, the farthest at [\d.]+\n$/m);
  const { label, distance, direction } = JSON.parse(read('d.json'));
  assert.deepEqual([label[0], label[3], label[6]], [0, 1, -1]);
  assert.deepEqual([distance[0], distance[3], distance[6]], [0, 0, null]);
  assert.ok(Math.abs(distance[1] - 2 * Math.SQRT2) < 1e-12);
  assert.ok(Math.abs(Math.hypot(direction[2], direction[3]) - 1) < 1e-12);
  assert.equal(direction[12], null);
  assert.equal(direction.length, 20);
  succeeds('distances two.glb --sites d.json --metric dgpc -o d.ply');
  const { vertex, face } = readPly(readFileSync(join(folder, 'd.ply')));
  assert.equal(face.length, 10);
  assert.deepEqual(
    vertex.map((row) => row.label),
    label,
  );
  assert.equal(vertex[6].distance, Infinity);
  succeeds('distances two.glb --sites d.json -o d.glb');
  await assertValidGlb(new Uint8Array(readFileSync(join(folder, 'd.glb'))));
});

test('tables of located points, distances and sites', () => {
  const numbers = (text) =>
    text
      .trim()
      .split('\n')
      .map((line) => line.split(','));
  const locate = 'locate two.glb --sites {"vertex":[0]} --points {"vertex":[3,9]} -q --units cm';
  const { label, distance } = JSON.parse(succeeds(locate).stdout);
  assert.deepEqual(numbers(succeeds(`${locate} --format csv`).stdout), [
    ['label', 'distance'],
    [`${label[0]}`, `${distance[0]}`],
    ['-1', ''],
  ]);
  succeeds('distances two.glb --sites sites.json -q -o d.csv');
  const all = JSON.parse(succeeds('distances two.glb --sites sites.json -q').stdout);
  const [names, ...rows] = numbers(read('d.csv'));
  assert.deepEqual(names, ['label', 'distance', 'direction_x', 'direction_y']);
  const text = (x) => (x === null ? '' : String(x));
  assert.deepEqual(
    rows,
    all.label.map((l, v) =>
      [l, all.distance[v], all.direction[2 * v], all.direction[2 * v + 1]].map(text),
    ),
  );
  succeeds('cvt shape.glb --sites 3 -q -o s.json');
  succeeds('cvt shape.glb --sites 3 -q -o s.csv');
  const { position } = JSON.parse(read('s.json'));
  assert.deepEqual(numbers(read('s.csv')), [
    ['x', 'y', 'z'],
    ...[0, 1, 2].map((i) => position.slice(3 * i, 3 * i + 3).map(String)),
  ]);
  succeeds('diagram shape.glb --sites s.csv -q');
});

test('--format decides, also on standard output and whatever the file is called', () => {
  const { stdout } = succeeds('partition shape.glb --sites 2 --format obj');
  succeeds('partition shape.glb --sites 2 -o parts.obj');
  assert.equal(stdout, read('parts.obj'));
  succeeds('partition shape.glb --sites 2 --format obj -o parts.txt');
  assert.equal(read('parts.txt'), stdout);
  const ply = 'cvt shape.glb --sites 2 --format ply';
  assert.match(succeeds(ply).stdout, /^ply\n/);
  succeeds('partition shape.glb --sites 2 --layout features --format glb -o parts.bin');
  const obj = 'partition shape.glb --sites 2 --layout features --format obj -o parts.glb';
  fails(2, obj, /--layout is about \.glb files: --format obj has none\n$/);
  fails(2, `${ply} --json`, /--json is a format as --format is: give one of them\n$/);
  fails(
    2,
    'cvt shape.glb --sites 2 --format obj',
    /--format is 'obj', not one of json, ply, csv\n$/,
  );
});

test('path as JSON and OBJ', () => {
  const { stderr } = succeeds('path shape.glb --from points.json --to sites.json -o p.json');
  assert.match(stderr, /^2 paths, of length /);
  const { paths } = JSON.parse(read('p.json'));
  assert.deepEqual(
    paths.map(({ length }) => length),
    [0, 0],
  );
  write('from.json', '{"vertex": [0]}');
  write('to.json', '{"vertex": [3]}');
  succeeds('path shape.glb --from from.json --to to.json --units cm -o p.json');
  const [path] = JSON.parse(read('p.json')).paths;
  // Over two faces, as straight as in the plane.
  assert.ok(Math.abs(path.length - 100 * Math.sqrt(6)) < 1e-9);
  assert.equal(path.points.face.length, 3);
  assert.equal(path.points.position[0], 100);
  succeeds('path shape.glb --from sites.json --to to.json -o p.obj');
  const obj = read('p.obj').split('\n');
  assert.equal(obj.filter((line) => line.startsWith('l ')).length, 1);
  assert.deepEqual(
    obj.filter((line) => line.startsWith('p ')),
    ['p 4'],
  );
  assert.equal(obj.filter((line) => line.startsWith('v ')).length, 3 + 1);
});

test('paths from one point to many are those from many to one, from their ends', () => {
  write('many.json', '{"vertex": [0, 1, 3, 4]}');
  const paths = (ends) => JSON.parse(succeeds(`path shape.glb ${ends}`).stdout).paths;
  const there = paths('--from {"vertex":2} --to many.json');
  const back = paths('--from many.json --to {"vertex":2}');
  assert.equal(there.length, 4);
  there.forEach(({ points, length }, i) => {
    assert.equal(length, back[i].length);
    assert.deepEqual(points.position.slice(0, 3), [0, 0, 1]);
    const count = points.face.length;
    for (let k = 0; k < count; ++k) {
      const [at, from] = [3 * k, 3 * (count - 1 - k)];
      assert.equal(points.face[k], back[i].points.face[count - 1 - k]);
      for (const name of ['bary', 'position'])
        assert.deepEqual(
          points[name].slice(at, at + 3),
          back[i].points[name].slice(from, from + 3),
        );
    }
  });
});

test('no path leads to another component', () => {
  write('from.json', '{"vertex": [6]}');
  write('to.json', '{"vertex": [0]}');
  const { stdout } = succeeds('path two.glb --from from.json --to to.json');
  const none = { face: [], bary: [], position: [] };
  const { paths } = JSON.parse(stdout);
  assert.deepEqual(paths, [{ points: none, length: null }]);
});

test('- is standard input, for one file', () => {
  const bytes = glb(octahedron());
  assert.match(succeeds('info -', bytes).stdout, /triangles +8/);
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
  fails(2, 'partition shape.glb --sites 3 -o d.stl', /d\.stl.*\.json, \.glb, \.obj, \.ply/);
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
  const { json } = gltf(octahedron(), { uri: '-' });
  fails(1, 'info -', /- cannot be read: it refers to itself/, JSON.stringify(json));
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
