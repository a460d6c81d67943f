// SPDX-License-Identifier: MIT
//
// The package as others get it: packed, unpacked and used from somewhere else.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
let folder;
let packed;

function run(command, args, cwd) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd, encoding: 'utf8' });
  assert.equal(status, 0, stdout + stderr);
  return stdout;
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  const target = join(folder, 'node_modules', 'geodesic-voronoi');
  mkdirSync(target, { recursive: true });
  const options = ['--json', '--ignore-scripts', '--pack-destination', folder];
  [packed] = JSON.parse(run('npm', ['pack', ...options], root));
  run('tar', ['-xf', join(folder, packed.filename), '-C', target, '--strip-components=1']);
});
after(() => rmSync(folder, { recursive: true }));

test('nothing is published but what is built, its licence and its description', () => {
  const others = packed.files.map(({ path }) => path).filter((path) => !path.startsWith('dist/'));
  for (const path of others)
    assert.ok(['LICENSE', 'README.md', 'package.json'].includes(path), path);
  assert.ok(others.includes('LICENSE'));
});

test('it works where it is installed', () => {
  writeFileSync(
    join(folder, 'use.mjs'),
    `import { load } from 'geodesic-voronoi';
     const gvd = await load();
     const mesh = await gvd.mesh({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2] });
     const { regions } = await mesh.voronoi({ vertex: [0, 1, 2] });
     console.log(regions.length, import.meta.resolve('geodesic-voronoi/core.wasm').slice(-15));`,
  );
  assert.equal(run(process.execPath, ['use.mjs'], folder), '3 /dist/core.wasm\n');
});

test('its types are complete, with and without those of Node', () => {
  symlinkSync(join(root, 'node_modules', '@types'), join(folder, 'node_modules', '@types'));
  writeFileSync(
    join(folder, 'use.mts'),
    `import { load, type Diagram, type DiagramData, type Mesh } from 'geodesic-voronoi';
     const gvd = await load();
     const mesh: Mesh = await gvd.mesh(new Uint8Array(8), { resources: {} });
     const diagram: Diagram = await mesh.voronoi(await mesh.sampleSites(3), { metric: 'exact' });
     const data: DiagramData = diagram.data;
     const loops: Int32Array[] = diagram.regions[data.arcs.labels[0]].loops;
     diagram[Symbol.dispose]();
     // @ts-expect-error: not a metric
     await mesh.voronoi({ vertex: [0] }, { metric: 'euclid' });
     export { loops };`,
  );
  const tsc = join(root, 'node_modules', '.bin', 'tsc');
  const options = ['--noEmit', '--strict', '--target', 'es2022', '--lib', 'es2022,dom', 'use.mts'];
  const nodeLike = ['--module', 'nodenext', '--types', 'node'];
  const bundlerLike = ['--module', 'esnext', '--moduleResolution', 'bundler', '--types', ''];
  for (const kind of [nodeLike, bundlerLike]) run(tsc, [...kind, ...options], folder);
});
