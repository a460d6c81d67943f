// SPDX-License-Identifier: MIT
//
// The two sides of the border with WebAssembly: the C++ functions are the table, and what the
// JavaScript says of them is compared with it.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import {
  cvtMethods,
  metrics,
  orientations,
  samplings,
  worstRegions,
} from '../../dist/api/results.js';
import { gltfLimitNames } from '../../dist/api/options.js';
import { WasmModule } from '../../dist/base/wasm_module.js';
import { octahedron } from './meshes.mjs';
import { fails } from './expectations.mjs';

const dist = new URL('../../dist/', import.meta.url);
const modules = {};
before(async () => {
  for (const name of ['core', 'gltf'])
    modules[name] = await WebAssembly.compile(readFileSync(new URL(`${name}.wasm`, dist)));
});

test('every function of the modules is called by its name, and there is none but these', () => {
  const functions = new Set(
    Object.values(modules)
      .flatMap((module) => WebAssembly.Module.exports(module))
      .filter(({ kind, name }) => kind === 'function' && !name.startsWith('_'))
      .map(({ name }) => name),
  );
  const scripts = ['base/', 'engine/', 'input/', 'library/']
    .map((folder) => new URL(folder, dist))
    .flatMap((folder) => readdirSync(folder).map((file) => new URL(file, folder)))
    .filter(({ pathname }) => pathname.endsWith('.js'))
    .map((file) => readFileSync(file, 'utf8'))
    .join('\n');
  const named = (name) => new RegExp(`'${name}'|#exports\\.${name}\\b`).test(scripts);
  const idle = [...functions].filter((name) => !named(name));
  // Of emscripten's own making.
  assert.deepEqual(
    idle.filter((name) => !/^(stack|emscripten|malloc$|free$|setThrew$)/.test(name)),
    [],
  );
  const calls = scripts.matchAll(/(?:\.(?:call|answer|run|text)|change)\(\s*'(\w+)'/g);
  const called = [...calls].map(([, name]) => name);
  assert.ok(called.length > 20);
  for (const name of called) assert.ok(functions.has(name), name);
});

test('a call that does not fit the function is refused before it is made', async () => {
  const core = await WasmModule.instantiate(modules.core);
  assert.throws(() => core.call('perimeter', 1), fails('internal', /no function perimeter of 1/));
  assert.throws(() => core.call('createMesh', 1), fails('internal', /createMesh of 1 parameter/));
  assert.throws(() => core.call('memory'), fails('internal', /memory/));
});

test('enumerators have the same names on both sides', async () => {
  const core = await WasmModule.instantiate(modules.core);
  const { positions, indices } = octahedron();
  const meshOf = (orientation) => {
    const arrays = core.call('newMeshArrays', positions.length, indices.length);
    const triangles = [Float64Array.from(positions), Int32Array.from(indices)];
    core.call('appendToMeshArrays', arrays, ...triangles);
    return finished(core.call('createMesh', arrays, 0, orientation, 0)).mesh;
  };
  const finished = (answer) => {
    while (core.call('stepAnswer', answer, 1000) !== 2);
    const copying = core.copying(answer);
    let next = copying.next();
    while (!next.done) next = copying.next();
    return next.value;
  };
  const mesh = meshOf(orientations[0]);
  const site = [Int32Array.of(0), Float64Array.of(1, 0, 0)];
  const none = [0, 0, new Float64Array(), new Int32Array()];
  const voronoiOf = (metric) =>
    finished(core.call('createVoronoi', mesh, ...site, metric, 0)).voronoi;
  const voronoi = voronoiOf(metrics[0]);
  const named = [
    [metrics, voronoiOf],
    [orientations, meshOf],
    [worstRegions, (name) => core.call('worstRegionPoint', voronoi, name)],
    [samplings, (name) => finished(core.call('sampleSites', mesh, 1, name, 1, new Float64Array()))],
    [cvtMethods, (name) => core.call('startCvt', mesh, ...site, name, metrics[0], 1, ...none)],
  ];
  for (const [names, call] of named) {
    for (const name of names) call(name);
    assert.throws(() => call('x'), fails('invalid-argument', listing(names)));
  }
  const gltf = await WasmModule.instantiate(modules.gltf);
  const read = (name) =>
    gltf.call('readGltfScene', new Uint8Array(), [], [], [name], Float64Array.of(1));
  assert.throws(() => read('x'), fails('invalid-argument', listing(gltfLimitNames)));
});

/** The end of the sentence about a name that there is not. */
const listing = (names) => new RegExp(`is "x", not one of ${names.join(', ')}$`);
