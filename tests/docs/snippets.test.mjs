// SPDX-License-Identifier: MIT
//
// The code in the documents runs. The JavaScript of a document is one program, its shell commands
// one script; both find a model and a few lists of points in the folder they run in.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { torus } from '../../web/page/samples/shapes.mjs';
import { glb } from '../wasm/meshes.mjs';
import { blocks, markdownFiles, root } from './documents.mjs';
import { temporaryFolder } from '../wasm/temporary_folder.mjs';

const folder = temporaryFolder();
mkdirSync(join(folder, 'node_modules'));
symlinkSync(root, join(folder, 'node_modules', 'geodesic-voronoi'));
symlinkSync(join(root, 'node_modules/three'), join(folder, 'node_modules', 'three'));
writeFileSync(join(folder, 'model.glb'), glb(torus(40, 20)));
const lists = { sites: [0, 200, 400], points: [5, 17], a: [3], b: [77] };
writeFileSync(join(folder, 'landmarks.csv'), 'name,x,y,z\n"a, b",2,0,0\nc,-2,0,0\n');
writeFileSync(join(folder, 'measurement.txt'), '7\n'.repeat(800));
writeFileSync(join(folder, 'cities.csv'), 'name,longitude,latitude\n"A, B",0,0\nC,180,0\nD,0,90\n');
for (const [name, vertex] of Object.entries(lists)) {
  writeFileSync(join(folder, `${name}.json`), JSON.stringify({ vertex }));
}

function run(command, args) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: folder, encoding: 'utf8' });
  assert.equal(status, 0, `${args.join(' ')}\n${stdout}${stderr}`);
  return stdout;
}

const runCommand = (args) => run(process.execPath, [join(root, 'dist/cli/main.js'), ...args]);

/** The words of a command line, as a shell takes it apart. */
const wordsOf = (line) => line.match(/'[^']*'|\S+/g).map((word) => word.replaceAll("'", ''));

for (const source of markdownFiles) {
  const programs = blocks(source, 'js');
  if (programs.length > 0) {
    test(`JavaScript of ${source}`, () => {
      const name = `${source.replace(/\W/g, '_')}.mjs`;
      writeFileSync(join(folder, name), programs.join('\n'));
      assert.notEqual(run(process.execPath, [name]), '');
    });
  }

  const lines = blocks(source, 'sh').flatMap((block) => block.split('\n'));
  const commands = lines.filter((line) => line.startsWith('geodesic-voronoi '));
  if (commands.length > 0) {
    test(`commands of ${source}`, () => {
      for (const line of commands) runCommand(wordsOf(line).slice(1));
    });
  }
}

test('the readme installs what package.json is called', () => {
  assert.deepEqual(blocks('README.md', 'sh')[0], 'npm install geodesic-voronoi\n');
});

const examples = {
  'even-sampling.mjs': {
    args: ['model.glb', '40'],
    says: /^40 points; the largest region has 1\.\d+ ×/,
  },
  'base-mesh.mjs': { args: [], says: /meet in 2 places[^]* polygons, genus 1$/m },
  'feature-ids.mjs': {
    args: ['model.glb', '7'],
    says: /^(region \d: area [\d.]+, perimeter [\d.]+\n){7}$/,
  },
  'printable-parts.mjs': {
    args: ['model.glb', '4', '0.05', 'piece'],
    says: /^(part \d: area [\d.]+, closed\n){4}$/,
  },
  'many-models.mjs': {
    args: ['3', 'model.glb', 'none.glb', 'model.glb'],
    says: /^model,label,area\n(model\.glb,\d,[\d.]+\n){6}$/,
  },
  'region-means.mjs': {
    args: ['model.glb', 'landmarks.csv', 'measurement.txt'],
    says: /^landmark,offSurface,area,perimeter,mean\n("a, b"|c)(,[\d.]+){3},7\.00000\n/,
  },
  // Three eighths of the sphere are nearest to the first city, and half its circumference leads to the second.
  'cities.mjs': {
    args: ['cities.csv'],
    says: /^city,area,neighbour,distance\n"A, B",1912\d{5},C,2001\d\.\d\n/,
  },
  'log-map.mjs': {
    args: ['model.glb'],
    says: /^farthest: vertex \d+ at \(-?\d+\.\d+, -?\d+\.\d+\)$/m,
  },
};
for (const [name, { args, says }] of Object.entries(examples)) {
  test(`example ${name}`, () => assert.match(runExample(name, args), says));
}

test('two cities divide the Earth, though their regions meet in no Voronoi point', () => {
  writeFileSync(join(folder, 'two.csv'), 'name,longitude,latitude\nA,0,0\nB,90,0\n');
  const says =
    /^city,area,neighbour,distance\nA,2550\d{5},B,1000\d\.\d\nB,2550\d{5},A,1000\d\.\d\n$/;
  assert.match(runExample('cities.mjs', ['two.csv']), says);
});

test('the outline of a region around a pole is as near to the meridian of Greenwich as it can be', () => {
  const cities = 'A,0,0\nB,120,0\nC,-120,0\nD,0,-90\n';
  writeFileSync(join(folder, 'south.csv'), `name,longitude,latitude\n${cities}`);
  runExample('cities.mjs', ['south.csv', 'south.geojson']);
  const { features } = JSON.parse(readFileSync(join(folder, 'south.geojson'), 'utf8'));
  for (const { geometry } of features)
    for (const ring of geometry.coordinates) {
      const longitudes = ring.map(([longitude]) => longitude);
      const middle = (Math.min(...longitudes) + Math.max(...longitudes)) / 2;
      assert.ok(Math.abs(middle) <= 180, `from ${Math.min(...longitudes)}`);
    }
});

test('a table of cities in another order is refused', () => {
  writeFileSync(join(folder, 'turned.csv'), 'name,latitude,longitude\nA,0,0\nB,0,90\n');
  assert.throws(() => runExample('cities.mjs', ['turned.csv']), /name,latitude,longitude/);
});

function runExample(name, args) {
  // A copy: an example finds its packages where it is run.
  copyFileSync(join(root, 'web/docs/examples', name), join(folder, name));
  return run(process.execPath, [name, ...args]);
}
