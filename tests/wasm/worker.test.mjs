// SPDX-License-Identifier: MIT
//
// Both sides of the worker's protocol, joined by a channel instead of a worker, which Node has not.
// tests/web runs a real one.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { load } from 'geodesic-voronoi';
import { outOfMemory } from '../../dist/api/errors.js';
import { LocalEngine } from '../../dist/engine/local_engine.js';
import { Library } from '../../dist/library/library.js';
import { startWorkerEngine } from '../../dist/engine/worker_engine.js';
import { serve } from '../../dist/engine/worker_server.js';
import { glb, grid, octahedron } from './meshes.mjs';
import { meshObj } from './model_files.mjs';
import { fails } from './expectations.mjs';

const bytesOf = (name) => readFileSync(new URL(`../../dist/${name}.wasm`, import.meta.url));
const sources = () => ({ wasm: bytesOf('core'), gltfWasm: bytesOf('gltf') });

/** A worker of a kind: `loadEngine` runs on the far side of a channel. */
function fakeWorker(loadEngine) {
  const { port1, port2 } = new MessageChannel();
  const sent = [];
  serve(port2, loadEngine);
  const worker = Object.assign(new EventTarget(), {
    postMessage(message) {
      sent.push(message);
      port1.postMessage(message);
    },
    terminate: () => port1.close(),
  });
  port1.onmessage = (event) => worker.onmessage(event);
  return { worker, sent };
}

/** The library over such a worker, until the test is over. */
async function loadThroughChannel(t) {
  let engine;
  const { worker, sent } = fakeWorker(async (from) => (engine = await LocalEngine.load(from)));
  const library = new Library(await startWorkerEngine(worker, sources(), 'the worker'));
  t.after(() => library.dispose());
  return { library, worker, sent, engine: () => engine };
}

test('a worker answers as the calling thread does', async (t) => {
  const { library: there } = await loadThroughChannel(t);
  const here = await load();
  assert.equal(there.version, here.version);
  const answers = await Promise.all(
    [there, here].map(async (gvd) => {
      const mesh = await gvd.mesh(glb(grid(6)));
      const sites = await mesh.sampleSites(8, { seed: 3 });
      const shares = [];
      const diagram = await mesh.voronoi(sites, { onProgress: (share) => shares.push(share) });
      const located = await diagram.locate({ vertex: [0, 10, 20] });
      const distances = await mesh.distances(sites, { metric: 'dgpc' });
      const paths = [
        await mesh.path({ vertex: [0] }, { vertex: [20] }),
        await diagram.path({ vertex: [9] }),
      ];
      const parts = await diagram.partition();
      const valid = await diagram.repair({ onProgress: (share) => shares.push(share) });
      const duals = [await valid.dual(), await valid.dual({ primal: true })];
      const facts = [await diagram.violations(), await valid.remeshQuality(), valid.sites];
      facts.push(await mesh.closestPoints([0.3, 0.4, 2]));
      facts.push((await mesh.remesh(sites, { iterations: 2 })).sites);
      await diagram.removeSite(2);
      facts.push(await diagram.dual());
      const states = [];
      for await (const state of mesh.cvt(sites, { iterations: 3, data: true })) states.push(state);
      const { info, positions, indices, normals, uvs } = mesh;
      const { metric, data } = diagram;
      const last = shares.at(-1);
      const input = { info, positions, indices, normals, uvs, parts: mesh.parts };
      return {
        input,
        sites,
        metric,
        data,
        located,
        distances,
        paths,
        parts,
        duals,
        facts,
        states,
        last,
      };
    }),
  );
  assert.deepEqual(answers[0], answers[1]);
});

test('a tessellation can be given up', async (t) => {
  const { library } = await loadThroughChannel(t);
  const mesh = await library.mesh(grid(60));
  const controller = new AbortController();
  const states = mesh.cvt(await mesh.sampleSites(50), { signal: controller.signal });
  await states.next();
  const next = states.next();
  controller.abort(new Error('enough'));
  await assert.rejects(next, /enough/);
  assert.deepEqual(await states.next(), { value: undefined, done: true });
  assert.equal((await mesh.sampleSites(2)).face.length, 2);
});

test('files of any format go to the worker, and their triangles come back', async (t) => {
  const { library } = await loadThroughChannel(t);
  for (const file of [meshObj(octahedron()), new Blob([meshObj(octahedron())])]) {
    const mesh = await library.mesh({ 'a.obj': file });
    assert.deepEqual([...mesh.indices], octahedron().indices);
    assert.deepEqual(mesh.info.origin, { format: 'OBJ', file: 'a.obj' });
  }
});

test('errors keep their code and their message', async (t) => {
  const { library } = await loadThroughChannel(t);
  await assert.rejects(library.mesh(new Uint8Array(9)), fails('invalid-file'));
  const mesh = await library.mesh(octahedron());
  await assert.rejects(mesh.voronoi({ vertex: [6] }), fails('invalid-point', /6/));
});

test('what cannot be sent to the worker is refused', async (t) => {
  const { library } = await loadThroughChannel(t);
  const file = { arrayBuffer: async () => new ArrayBuffer(8) };
  await assert.rejects(
    library.mesh({ 'a.obj': file }),
    fails('invalid-argument', /sent to the worker/),
  );
  assert.equal((await library.mesh(octahedron())).info.faces, 8);
});

test('arrays of the caller are not taken away', async (t) => {
  const { library } = await loadThroughChannel(t);
  const bytes = glb(octahedron());
  const mesh = await library.mesh(bytes);
  assert.ok(bytes.length > 0);
  const sites = await mesh.sampleSites(4);
  await mesh.voronoi(sites);
  assert.equal(sites.face.length, 4);
});

test('giving up is immediate, and the worker stops too', async (t) => {
  const { library, sent } = await loadThroughChannel(t);
  const mesh = await library.mesh(grid(150));
  const sites = await mesh.sampleSites(300);
  const controller = new AbortController();
  const reason = new Error('changed my mind');
  let shares = 0;
  const onProgress = () => {
    ++shares;
    controller.abort(reason);
  };
  await assert.rejects(mesh.voronoi(sites, { signal: controller.signal, onProgress }), reason);
  assert.ok('abort' in sent.at(-1));
  await mesh.voronoi({ vertex: [0] });
  assert.equal(shares, 1);
  await assert.rejects(mesh.voronoi(sites, { signal: controller.signal }), reason);
});

test('files and limits in proxies, as Vue makes them, are sent as what they are', async (t) => {
  const { library } = await loadThroughChannel(t);
  const files = new Proxy({ 'model.glb': glb(octahedron()) }, {});
  const limits = new Proxy({ maxVertices: 6 }, {});
  assert.equal((await library.mesh(files, { limits })).info.faces, 8);
});

test('a diagram that is done before its abortion arrives is freed', async (t) => {
  const { library, sent, engine } = await loadThroughChannel(t);
  const mesh = await library.mesh(octahedron());
  // The far side misses the signal: its answer comes after all.
  const far = engine();
  const openDiagram = far.openDiagram.bind(far);
  far.openDiagram = (...args) => openDiagram(...args.slice(0, 3), {});
  const controller = new AbortController();
  const sites = await mesh.sampleSites(2);
  const abandoned = mesh.voronoi(sites, { signal: controller.signal });
  while (sent.at(-1).call !== 'openDiagram') await null;
  controller.abort();
  await assert.rejects(abandoned, { name: 'AbortError' });
  await mesh.voronoi(sites);
  assert.ok(sent.some((message) => 'close' in message));
});

test('the worker forwards any function of the engine, of which it knows none', async (t) => {
  const engine = { version: '1', close() {}, dispose() {} };
  const rows = new Float64Array(3);
  engine.twice = async (x, { onProgress }) => {
    onProgress(0.5);
    return { twice: 2 * x, both: [rows.subarray(0, 1), rows.subarray(1)] };
  };
  const { worker } = fakeWorker(async () => engine);
  const remote = await startWorkerEngine(worker, sources(), 'the worker');
  t.after(() => remote.dispose());
  const shares = [];
  const { twice, both } = await remote.twice(21, { onProgress: (share) => shares.push(share) });
  assert.equal(twice, 42);
  assert.equal(both[1].length, 2);
  assert.deepEqual(shares, [0.5]);
  await assert.rejects(remote.thrice(1, {}), fails('internal', /thrice|not a function/));
});

test('a change of a diagram that has begun is carried out on both sides', async (t) => {
  const { library } = await loadThroughChannel(t);
  const mesh = await library.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 1] });
  const controller = new AbortController();
  const change = diagram.insertSite(
    { vertex: [2] },
    { signal: controller.signal, onProgress: () => controller.abort() },
  );
  assert.equal((await change).label, 2);
  assert.equal(diagram.sites.face.length, 3);
  await assert.rejects(diagram.removeSite(0, { signal: controller.signal }), {
    name: 'AbortError',
  });
  assert.deepEqual([...(await diagram.locate({ vertex: [0, 2] })).label], [0, 2]);
});

/** Else what it says of itself would not be what it answers. */
test('a diagram without memory for all of a change is disposed', async (t) => {
  const { library, engine } = await loadThroughChannel(t);
  const mesh = await library.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 1] });
  const call = engine().call.bind(engine());
  engine().call = async (name, ...args) => {
    const result = await call(name, ...args);
    if (name === 'insertSite') throw outOfMemory();
    return result;
  };
  await assert.rejects(diagram.insertSite({ vertex: [2] }), fails('out-of-memory', /memory/));
  await assert.rejects(diagram.locate({ vertex: [2] }), fails('disposed', /diagram/));
  assert.equal((await mesh.voronoi({ vertex: [0, 1] })).regions.length, 2);
});

test('what a listener throws ends the task', async (t) => {
  const { library } = await loadThroughChannel(t);
  const mesh = await library.mesh(octahedron());
  const onProgress = () => {
    throw new Error('no screen');
  };
  await assert.rejects(mesh.voronoi({ vertex: [0] }, { onProgress }), /no screen/);
  const diagram = await mesh.voronoi({ vertex: [0] });
  await assert.rejects(diagram.insertSite({ vertex: 1 }, { onProgress }), /no screen/);
  assert.equal(diagram.sites.face.length, 2, 'a change of a site is carried out');
  assert.equal((await diagram.insertSite({ vertex: 2 })).label, 2);
});

test('disposing frees on the far side, and ends what waits', async (t) => {
  const { library, sent } = await loadThroughChannel(t);
  const mesh = await library.mesh(octahedron());
  mesh.dispose();
  mesh.dispose();
  assert.equal(sent.filter((message) => 'close' in message).length, 1);
  const waiting = library.mesh(octahedron());
  library.dispose();
  library.dispose();
  await assert.rejects(waiting, fails('disposed'));
  await assert.rejects(library.mesh(octahedron()), fails('disposed'));
});

test('a worker that does not load, or stops, says so', async (t) => {
  const silent = Object.assign(new EventTarget(), { postMessage() {}, terminate() {} });
  const starting = startWorkerEngine(silent, sources(), 'the worker');
  silent.onerror({ message: '' });
  await assert.rejects(starting, fails('load-failed', /script/));

  const { worker } = fakeWorker((from) => LocalEngine.load(from));
  const broken = startWorkerEngine(
    worker,
    { ...sources(), wasm: new Uint8Array(10) },
    'the worker',
  );
  await assert.rejects(broken, fails('load-failed', /magic/));

  const { library, worker: running } = await loadThroughChannel(t);
  const waiting = library.mesh(octahedron());
  running.onerror({ message: 'out of memory' });
  await assert.rejects(waiting, fails('internal', /out of memory/));
});

test('an answer that cannot be received ends what waits', async (t) => {
  const { library, worker } = await loadThroughChannel(t);
  const waiting = library.mesh(octahedron());
  worker.dispatchEvent(new Event('messageerror'));
  await assert.rejects(waiting, fails('internal', /the worker has stopped: its answer/));
});
