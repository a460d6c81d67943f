// SPDX-License-Identifier: MIT
//
// The sites and points of the command: sampled, read from files, moved by a tessellation.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fails, folder, read, succeeds, write } from './command.mjs';
import { glb, grid } from './meshes.mjs';
import { near } from './expectations.mjs';

test('sites that were written in the coordinates of a map are on the surface again', () => {
  write(
    'map.obj',
    'v 500000.1 6000000.3 7\nv 500020.7 6000000.3 9\nv 500000.1 6000030.9 8\nf 1 2 3\n',
  );
  succeeds('cvt map.obj --sites 40 --iterations 0 -o map.csv');
  const { stderr } = succeeds('diagram map.obj --sites map.csv -o map.json');
  assert.doesNotMatch(stderr, /from the surface/);
});

test('sites and points by their coordinates', () => {
  write('places.json', '{"position": [1, 0, 0, 0, 2, 0]}');
  write('corners.json', '{"vertex": [0, 2]}');
  const { stderr } = succeeds('diagram shape.glb --sites places.json --units cm -o d.json');
  assert.match(
    stderr,
    /^note: places\.json: the farthest of 2 places is 100\.0 from the surface\n2 regions/,
  );
  assert.equal(succeeds('diagram shape.glb --sites places.json -q -o d.json').stderr, '');
  const one = succeeds('diagram shape.glb --sites {"position":[0,0,2]} -o d.json').stderr;
  assert.match(one, /^note: \S+: the place is 1\.000 from the surface\n/);
  const far = succeeds('diagram shape.glb --sites {"position":[0,0,1000]} -q -o d.json').stderr;
  assert.equal(far, 'warning: {"position":[0,0,1000]}: the place is 999.0 from the surface\n');
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

test('components without a site are told of; --per-component puts some there', () => {
  const note = /^note: 1 of 2 components, (13|87) % of the area, have no site/;
  assert.match(succeeds('diagram two.glb --sites 1 -o d.json').stderr, note);
  assert.match(succeeds('cvt two.glb --sites sites.json -o s.json').stderr, note);
  assert.equal(succeeds('diagram two.glb --sites 1 -o d.json --quiet').stderr, '');
  const { stderr } = succeeds('diagram two.glb --sites 1 -o d.json');
  const [, advice] = /^note: .* have no site \((.*) samples one on each, /.exec(stderr);
  assert.doesNotMatch(succeeds(`diagram two.glb ${advice} -o d.json`).stderr, note);
  const ofFile = succeeds('diagram two.glb --sites sites.json -o d.json').stderr;
  assert.match(ofFile, /have no site \(--min-component drops small ones\)/);
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

test('results name their mesh, so that their sites are not taken for those of another', () => {
  write('grid.glb', glb(grid(4)));
  for (const command of ['diagram', 'partition', 'distances', 'dual', 'cvt', 'remesh']) {
    succeeds(`${command} shape.glb --sites 30 --quiet -o result.json`);
    assert.deepEqual(JSON.parse(read('result.json')).mesh, { faces: 8 }, command);
    fails(
      1,
      'diagram grid.glb --sites result.json',
      /another mesh, of another file or made with other options: to one with 8 triangles, not 32/,
    );
  }
  write('places.json', '{"mesh": {"faces": 8}, "position": [1, 0, 0]}');
  succeeds('diagram shape.glb --sites places.json --quiet -o result.json');
  fails(1, 'diagram grid.glb --sites places.json', /another mesh, .* 8 triangles, not 32/);
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

test('cvt writes sites that other commands read, and the energy of every iteration', () => {
  const { stderr } = succeeds('cvt shape.glb --sites 5 --iterations 6 -o c.json');
  assert.match(
    stderr,
    /^5 sites, 6 iterations \(no more were allowed\), energy [\d.]+ to [\d.]+\n$/,
  );
  const { mesh, face, bary, position, energy } = JSON.parse(read('c.json'));
  const first = (energies) => Number(/energy ([\d.e+]+) to/.exec(energies)[1]);
  assert.equal(first(stderr), Number(energy[0].toPrecision(6)));
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
  near(lloyd.energy[0] / energy[0] / 1e8, 1, 1e-12);

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
  near(first(soon) / energy[0] / 1e8, 1, 1e-5, 'areas times squared lengths');
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
  near(meanX(spread('--seed 2')), 0, 0.1);
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
  const decimal = rows.map((row) => row.join(';').replaceAll('.', ','));
  write('decimal-commas.csv', ['\ufeffx;y;z', ...decimal, ''].join('\r\n'));
  const quoted = rows.map(([x, y, z], i) => `"a, ""${i}""; b",7,"${x}", ${y} ,"${z}"`);
  write('quoted.csv', ['name of it,"weight",x,"y", "z"', ...quoted].join('\n'));
  // As pandas writes a table.
  write('indexed.csv', [',z,x,y', ...rows.map(([x, y, z], i) => `${i},${z},${x},${y}`)].join('\n'));
  const numbered = rows.map((row, i) => `${i},${row},0`);
  const slicer = '# CoordinateSystem = LPS\n# columns = id,x,y,z,ow';
  write('slicer.fcsv', [slicer, ...numbered.map((row) => `Fiducial_${row}`)].join('\n'));
  write('spoken.csv', ['# the columns x y z', ...rows].join('\n'));
  write(
    'numpy.txt',
    ['# id x y z w', ...numbered.map((row) => row.replaceAll(',', ' '))].join('\n'),
  );
  const table = numbered.map((row, i) => `"${i}" ${row.replaceAll(',', ' ')}`);
  write('r.txt', ['"id" "x" "y" "z" "w"', ...table].join('\n'));
  // As pandas writes one with tabs.
  write('tabs.tsv', ['\tx\ty\tz', ...rows.map((row, i) => `${i}\t${row.join('\t')}`)].join('\n'));
  write('ended.csv', ['x,y,z', ...rows.map((row) => `${row},`)].join('\n'));
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
    'decimal-commas.csv',
    'quoted.csv',
    'indexed.csv',
    'slicer.fcsv',
    'spoken.csv',
    'numpy.txt',
    'r.txt',
    'tabs.tsv',
    'ended.csv',
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
    ['x,y,z\n"1,234",5,6', /bad\.csv: line 2: x is '1,234', not a number\n$/],
    ['x,y,z\n1,2,0x10', /bad\.csv: line 2: z is '0x10', not a number\n$/],
    ['x,y\n1,2', /bad\.csv: line 1 is neither three numbers nor names with x, y and z: "x y"\n$/],
    [
      '0,0,nan',
      /bad\.csv: line 1 is neither three numbers nor names with x, y and z: "0 0 nan"\n$/,
    ],
  ]) {
    write('bad.csv', content);
    fails(1, 'diagram shape.glb --sites bad.csv', message);
  }
  write('bad.csv', Buffer.from('\ufeffx,y,z\n1,2,3\n', 'utf16le'));
  fails(
    1,
    'diagram shape.glb --sites bad.csv',
    /bad\.csv: the file is UTF-16 text: save it as UTF-8\n$/,
  );
  fails(1, 'diagram shape.glb --sites shape.glb', /shape\.glb: it is not text, and of binary fil/);
  write('bad.ply', 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n2\n');
  fails(1, 'diagram shape.glb --sites bad.ply', /bad\.ply: the PLY's vertices have no y\n$/);
});

test('points as JSON in place of a file, and named in errors', () => {
  const path = `path shape.glb --from {"vertex":0} --to`;
  assert.equal(JSON.parse(succeeds(`${path} {"vertex":[0]}`).stdout).paths[0].length, 0);
  fails(1, `${path} {"vertex":9}`, /\{"vertex":9\}: there is no vertex 9\n$/);
  fails(1, `${path} {"position":[[0,0,0]]}`, /position\[0\] is a list: all numbers go into one/);
  write('bad.json', '{"face": [0, 8], "bary": [1, 0, 0, 1, 0, 0]}');
  fails(1, 'locate shape.glb --sites 2 --points bad.json', /bad\.json: point 1: there is no tri/);
  succeeds('cvt two.glb --sites 2 -o two.json');
  fails(1, 'distances shape.glb --sites two.json -o d.ply', /two\.json.*10 triangles, not 8/);
  fails(1, `${path} 0`, /there is no file 0; a vertex is given as '\{"vertex": 0\}'\n$/);
  fails(
    1,
    `${path} -1,0,0.5`,
    /there is no file -1,0,0\.5; a place is given as '\[\[-1,0,0\.5\]\]'\n$/,
  );
  const both = '{"vertex":[0],"face":[0],"bary":[1,0,0]}';
  fails(1, `${path} ${both}`, /: points has both vertex and face: only one can say where/);
  const other = '{"vertex":[1],"position":[0,0,0]}';
  fails(1, `${path} ${other}`, /: points has both vertex and position: only one can say where/);
  fails(1, `locate shape.glb --sites ${other} --points {"vertex":1}`, /both vertex and position/);
  write('gone.json', '{"face": [3, -1], "bary": [1, 0, 0, 0, 0, 0]}');
  const gone = /gone\.json: point 1 is a site that was removed\n$/;
  fails(1, `${path} gone.json`, gone);
  fails(1, 'locate shape.glb --sites gone.json --points gone.json', gone);
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

  // As NumPy's savetxt writes them, and with an end of Windows' lines.
  write('each.txt', '1.0e+00\r\n2.0e+00\n3\n4\n5\n6\n');
  assert.equal(succeeds(`${finer} --density each.txt`).stdout, spread);
  write('stay.txt', '1 3\n');
  const stay = succeeds('cvt shape.glb --sites 5 --fixed-sites stay.txt').stdout;
  assert.deepEqual(JSON.parse(stay), after);
  for (const [text, words] of [
    ['1\n0,5\n', /words\.txt: number 1 is "0,5", not a number of 0 or more$/m],
    ['density\n1\n', /words\.txt: number 0 is "density", not a number of 0 or more$/m],
    [' \n', /words\.txt: the file is empty$/m],
    ['\x93NUMPY\x01\0', /words\.txt: it is not text$/m],
  ]) {
    write('words.txt', text);
    fails(1, 'cvt shape.glb --sites 5 --density words.txt', words);
  }

  write('few.json', '[1, 1]');
  write('object.json', '{}');
  fails(
    1,
    'cvt shape.glb --sites 5 --density few.json',
    /the number of densities is 2, not that of input vertices, \d+/,
  );
  fails(1, 'cvt shape.glb --sites 5 --density object.json', /object\.json holds no list/);
  write('half.json', '[1, 0.5]');
  write('minus.json', '[1, -1]');
  fails(
    1,
    'cvt shape.glb --sites 5 --density minus.json',
    /: minus\.json: number 1 is -1, not a number of 0 or more$/m,
  );
  fails(
    1,
    'cvt shape.glb --sites 5 --fixed-sites half.json',
    /: half\.json: number 1 is 0\.5, not an integer from 0 to \d+$/m,
  );
  fails(1, 'cvt shape.glb --sites 5 --fixed-sites 0,2', /no file 0,2; .* as '\[0,2\]'$/m);
  write('beyond.json', '[9]');
  fails(1, 'cvt shape.glb --sites 5 --fixed-sites beyond.json', /site 9/);
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

test('the sites of a diagram are sites for another', () => {
  succeeds('diagram shape.glb --sites 5 -o d.json');
  assert.equal(succeeds('diagram shape.glb --sites d.json').stdout, read('d.json'));
});
