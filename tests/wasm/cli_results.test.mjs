// SPDX-License-Identifier: MIT
//
// What each command computes and writes, in every format.

import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fails, folder, read, succeeds, write } from './command.mjs';
import { assertValidGlb, readPly } from './files.mjs';
import { glb, grid } from './meshes.mjs';
import { locatedEncoders } from '../../dist/cli/encoders.js';
import { haveLinesTooLong, near } from './expectations.mjs';

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

test('partition as GLB, OBJ, PLY and JSON', () => {
  const { stderr } = succeeds('partition shape.glb --sites 5 -o parts.glb');
  assert.match(stderr, /^5 regions, \d of them disks, \d+ triangles\n$/);
  const json = JSON.parse(succeeds('partition shape.glb --sites 5 --units cm').stdout);
  const area = JSON.parse(succeeds('info shape.glb --json').stdout).area;
  const areas = json.regions.reduce((sum, region) => sum + region.area, 0);
  near(areas / area / 1e4, 1, 1e-12);
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

test('an STL of a model far from the origin is told of, as it loses digits', () => {
  const corners = ['5000000 0 0', '5000001 0 0', '5000000 1 0', '5000000 0 1'];
  write('far.off', `OFF\n4 4 0\n${corners.join('\n')}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n`);
  const note = /^note: an STL rounds positions to 32 bits, here by up to 30; \.ply and \.obj keep/m;
  assert.match(succeeds('partition far.off --sites 2 --units cm -o parts.stl').stderr, note);
  assert.doesNotMatch(succeeds('partition far.off --sites 2 -o parts.ply').stderr, /32 bits/);
  assert.doesNotMatch(succeeds('partition shape.glb --sites 2 -o parts.stl').stderr, /32 bits/);
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

test('a repair that would take too many sites says what may help', () => {
  fails(
    1,
    'dual shape.glb --sites 1 --repair --max-added 1',
    /may be added, perhaps because triangles are too long: regions? 0 .* \(--max-edge 0\.05 .*, --max-added .*\)$/m,
  );
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
  const shown = Number(/Hausdorff distance ([\d.]+)/.exec(stderr)[1]);
  near(quality.hausdorff / 10 / shown, 1, 1e-3, 'it is in the unit of the output');
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

test('diagram as OBJ and GLB', () => {
  succeeds('diagram shape.glb --sites sites.json -o lines.obj');
  assert.match(read('lines.obj'), /^l (\d+)( \d+)+ \1$/m); // the outline closes
  succeeds('diagram shape.glb --sites sites.json -o lines.glb');
  assert.match(read('lines.glb'), /^glTF/);
});

test('locate', () => {
  const { stdout } = succeeds('locate shape.glb --sites sites.json --points points.json');
  const located = { scale: 1, unit: 'm', label: [0, 1], distance: [0, 0] };
  assert.deepEqual(JSON.parse(stdout), { mesh: { faces: 8 }, ...located });
  const far = JSON.parse(
    succeeds('locate shape.glb --sites sites.json --points {"vertex":[3,1]} --units 2').stdout,
  );
  assert.deepEqual(far.label, [1, 0]);
  assert.equal(far.distance[0], 0);
  near(far.distance[1], 2 * Math.SQRT2, 1e-12);
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
  write('lone.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n');
  const { stderr: all } = succeeds('distances lone.obj --sites {"vertex":[0]} -o lone.csv');
  assert.match(all, /^3 of 3 vertices reached/, 'the last one is not on the surface');
  const { label, distance, direction } = JSON.parse(read('d.json'));
  assert.deepEqual([label[0], label[3], label[6]], [0, 1, -1]);
  assert.deepEqual([distance[0], distance[3], distance[6]], [0, 0, null]);
  near(distance[1], 2 * Math.SQRT2, 1e-12);
  near(Math.hypot(direction[2], direction[3]), 1, 1e-12);
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

/** The cells of a table. */
const numbers = (text) =>
  text
    .trim()
    .split('\n')
    .map((line) => line.split(','));

test('tables of located points, distances and sites', () => {
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

test('a table longer than a string may be is refused by a sentence', (t) => {
  haveLinesTooLong(t);
  assert.throws(() => locatedEncoders['.csv']({ label: [0], distance: [0] }, { scale: 1 }), {
    code: 'out-of-memory',
    message: /longer than a string may be/,
  });
});

test('tables of sites leave out removed ones', () => {
  const sites = '{"face":[3,-1],"bary":[0.5,0.25,0.25,0,0,0]}';
  for (const format of ['csv', 'ply']) {
    succeeds(`cvt shape.glb --sites ${sites} --iterations 0 -q -o left.${format}`);
    const { face } = JSON.parse(
      succeeds(`diagram shape.glb --sites left.${format} -q`).stdout,
    ).sites;
    assert.deepEqual(face, [3], format);
  }
});

test('summaries count sites, not labels whose site was removed', () => {
  const sites = '{"face":[3,-1,0],"bary":[0.5,0.25,0.25,0,0,0,1,0,0]}';
  for (const [command, summary] of [
    ['cvt shape.glb --iterations 0', /^2 sites, 0 iterations, energy [\d.]+$/m],
    ['diagram shape.glb', /^2 regions, /m],
    ['partition shape.glb', /^2 regions, /m],
    ['dual shape.glb --repair', /^(\d+) sites \((\d+) added\), /m],
    ['remesh shape.glb --iterations 0', /^(\d+) sites \((\d+) added\), /m],
  ]) {
    const { stderr } = succeeds(`${command} --sites ${sites} --json -o out`);
    assert.match(stderr, summary, command);
    const [, count, added] = summary.exec(stderr);
    if (added) assert.equal(count - added, 2, stderr);
  }
});

test('a table of regions', () => {
  const partition = 'partition two.glb --sites {"vertex":[0,1,0]} -q --units cm';
  const { regions } = JSON.parse(succeeds(partition).stdout);
  assert.equal(regions[2].centroid, null, 'a site at the place of another');
  const [names, ...rows] = numbers(succeeds(`${partition} --format csv`).stdout);
  assert.deepEqual(names.slice(0, 4), ['label', 'area', 'perimeter', 'boundaryLength']);
  assert.deepEqual(names.slice(4, 7), ['centroid_x', 'centroid_y', 'centroid_z']);
  assert.deepEqual(names.slice(7), ['components', 'loops', 'genus']);
  const cells = regions.map((region, label) => [
    label,
    ...names.slice(1, 4).map((name) => region[name]),
    ...(region.centroid ?? ['', '', '']),
    ...names.slice(7).map((name) => region[name]),
  ]);
  assert.deepEqual(
    rows,
    cells.map((row) => row.map(String)),
  );
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

test('partition as STL: all regions, or one of them', () => {
  const areaOf = (...region) => {
    succeeds(['partition shape.glb --sites 3 -o part.stl', ...region].join(' '));
    return JSON.parse(succeeds('info part.stl --json').stdout).area;
  };
  const { regions } = JSON.parse(succeeds('partition shape.glb --sites 3').stdout);
  const areas = regions.map(({ area }) => area);
  areas.forEach((area, label) => near(areaOf(`--region ${label}`), area, 1e-5 * area));
  const all = areas.reduce((sum, area) => sum + area);
  near(areaOf(), all, 1e-5 * all);
  write('same.json', '{"vertex": [0, 0]}');
  fails(
    1,
    'partition shape.glb --sites 3 --region 3 -q -o part.stl',
    /: --region is 3, not an integer from -1 to 2$/m,
  );
  fails(2, 'partition shape.glb --sites 3 --region 0 -o a.obj', /--region is about \.stl files/);
  for (const what of [
    'shape.glb --sites same.json --region 1',
    'shape.glb --sites same.json --region -1',
    'two.glb --sites same.json --region -1 --leave-out-unreachable',
  ])
    fails(
      1,
      `partition ${what} -q -o part.stl`,
      /: --region is -?1: the partition has no triangles of it$/m,
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
  near(path.length, 100 * Math.sqrt(6), 1e-9);
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
