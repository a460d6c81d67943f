// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createContext, runInContext } from 'node:vm';
import {
  compileModules,
  GeodesicVoronoiError,
  gltfResourceUris,
  load,
  loadWorker,
} from 'geodesic-voronoi';
import { glb, octahedron } from './meshes.mjs';
import { temporaryFolder } from './temporary_folder.mjs';

const dist = new URL('../../dist/', import.meta.url);
const coreUrl = new URL('core.wasm', dist);
const coreBytes = readFileSync(coreUrl);

const failsToLoad = (message) => ({ name: 'GeodesicVoronoiError', code: 'load-failed', message });

test('load() finds its modules beside itself and knows the version of the package', async () => {
  const { version } = JSON.parse(readFileSync(new URL('../package.json', dist), 'utf8'));
  assert.equal((await load()).version, version);
});

test('load() takes a URL, a path, bytes, what a server answered, or a module', async () => {
  const module = await WebAssembly.compile(coreBytes);
  const arrayBuffer = Uint8Array.from(coreBytes).buffer;
  for (const wasm of [
    coreUrl,
    coreUrl.href,
    fileURLToPath(coreUrl),
    URL.createObjectURL(new Blob([coreBytes])),
    coreBytes,
    arrayBuffer,
    new DataView(arrayBuffer),
    new Response(coreBytes),
    ...['application/wasm', 'Application/Wasm', 'application/wasm; charset=utf-8'].map(
      (type) => new Response(coreBytes, { headers: { 'Content-Type': type } }),
    ),
    module,
  ]) {
    const gvd = await load({ wasm });
    assert.equal((await gvd.mesh(octahedron())).info.faces, 8);
  }
});

test('objects of other frames are taken as those of this one', async () => {
  const frame = createContext();
  const other = runInContext('({ array: Uint8Array, compile: WebAssembly.compile })', frame);
  const [model, wasm] = [glb(octahedron()), coreBytes].map((bytes) => other.array.from(bytes));
  assert.ok(!(model instanceof Uint8Array));
  for (const source of [wasm.buffer, await other.compile(wasm)]) {
    const gvd = await load({ wasm: source });
    assert.equal((await gvd.mesh(model)).info.faces, 8);
    assert.equal((await gvd.mesh(model.buffer)).info.faces, 8);
    assert.equal((await gvd.mesh({ 'model.glb': model })).info.faces, 8);
  }
  assert.deepEqual(gltfResourceUris(model), []);
});

test('in a path, # and % and ? are letters as any others', async () => {
  const folder = temporaryFolder();
  mkdirSync(join(folder, 'x#y%20?'));
  const path = join(folder, 'x#y%20?', 'core.wasm');
  copyFileSync(fileURLToPath(coreUrl), path);
  assert.equal((await (await load({ wasm: path })).mesh(octahedron())).info.faces, 8);
});

test('what cannot be loaded says so', async () => {
  await assert.rejects(load({ wasm: './nowhere.wasm' }), failsToLoad(/nowhere\.wasm/));
  await assert.rejects(load({ wasm: new Uint8Array(100) }), failsToLoad(/magic/));
  await assert.rejects(loadWorker(), failsToLoad(/load\(\)/));
});

test('a worker that may not be started is told of as one that cannot be loaded', async (t) => {
  t.after(() => delete globalThis.Worker);
  globalThis.Worker = class {
    constructor() {
      throw new DOMException('of another origin', 'SecurityError');
    }
  };
  const sources = { wasm: coreBytes, gltfWasm: coreBytes, dracoWasm: coreBytes };
  await assert.rejects(
    loadWorker(sources),
    failsToLoad(/^the worker "worker\.js" cannot be started: of another origin$/),
  );
});

test('a worker whose script cannot be loaded is told of by its address', async (t) => {
  t.after(() => delete globalThis.Worker);
  globalThis.Worker = class extends EventTarget {
    constructor() {
      super();
      setTimeout(() => this.onerror({ message: '' }));
    }
    postMessage() {}
    terminate() {}
  };
  const sources = { wasm: coreBytes, gltfWasm: coreBytes, dracoWasm: coreBytes };
  await assert.rejects(
    loadWorker({ ...sources, worker: '/app/worker.js' }),
    failsToLoad(/^the worker "\/app\/worker\.js" has stopped: its script cannot be loaded$/),
  );
});

test('a module with imports that are not ours is refused by the name of the import', async () => {
  // (module (import "env" "spy" (func)))
  const stranger = [
    0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 2, 11, 1, 3, 101, 110, 118, 3, 115, 112, 121, 0,
    0,
  ];
  await assert.rejects(load({ wasm: Uint8Array.from(stranger) }), failsToLoad(/env\.spy/));
});

test('gltf.wasm is loaded with the first glTF, not before', async () => {
  const gvd = await load({ gltfWasm: './nowhere.wasm' });
  await gvd.mesh(octahedron());
  await assert.rejects(gvd.mesh(glb(octahedron())), failsToLoad(/nowhere\.wasm/));
});

test('a timer keeps the event loop of Node busy while modules are compiled and started', async (t) => {
  const timers = () => process.getActiveResourcesInfo().filter((name) => name === 'Timeout').length;
  const before = timers();
  const during = [];
  for (const name of ['compile', 'instantiate']) {
    const original = WebAssembly[name];
    t.mock.method(WebAssembly, name, (...args) => {
      during.push([name, timers() - before]);
      return original.apply(WebAssembly, args);
    });
  }
  const gvd = await load();
  await gvd.mesh(glb(octahedron()));
  const calls = ['compile', 'instantiate', 'compile', 'instantiate'];
  assert.deepEqual(
    during,
    calls.map((name) => [name, 1]),
  );
  assert.equal(timers(), before);
});

test('what is compiled once is enough for any number of libraries', async () => {
  const modules = await compileModules();
  assert.ok(Object.values(modules).every((module) => module instanceof WebAssembly.Module));
  const libraries = await Promise.all([load(modules), load(modules)]);
  for (const library of libraries) await library.mesh(octahedron());
});

test('GeodesicVoronoiError is an Error with a code', () => {
  const error = new GeodesicVoronoiError('internal', 'why');
  assert.ok(error instanceof Error);
  assert.equal(`${error}`, 'GeodesicVoronoiError: why');
});

test('nothing that a browser loads imports anything of Node', () => {
  const seen = new Set();
  const visit = (url) => {
    if (seen.has(url.href)) return;
    seen.add(url.href);
    for (const [, name] of readFileSync(url, 'utf8').matchAll(
      /(?:^(?:import|export) .*from |^import |\bimport\()'([^']+)'/gm,
    )) {
      assert.match(name, /^\.{1,2}\//, `${url.pathname} imports ${name}`);
      visit(new URL(name, url));
    }
  };
  visit(new URL('index.js', dist));
  visit(new URL('worker.js', dist));
  for (const name of ['base/checks.js', 'input/obj_reader.js', 'input/draco_decoder.js'])
    assert.ok(seen.has(new URL(name, dist).href), name);
});

test('the package works where code from strings is forbidden', () => {
  const script = `
    import { load } from 'geodesic-voronoi';
    const mesh = await (await load()).mesh(${JSON.stringify(octahedron())});
    const { data } = await mesh.voronoi(await mesh.sampleSites(4));
    console.log(data.regionArea.length);`;
  const { stdout, stderr } = spawnSync(
    process.execPath,
    ['--disallow-code-generation-from-strings', '--input-type=module', '--eval', script],
    { cwd: dist, encoding: 'utf8' },
  );
  assert.equal(stderr, '');
  assert.equal(stdout, '4\n');
});
