// SPDX-License-Identifier: MIT
//
// Misuse of the whole public interface: every mistake gets an error of this library, one sentence that
// names the argument, and never one of the language from inside.

import assert from 'node:assert/strict';
import { Readable } from 'node:stream';
import { test } from 'node:test';
import * as api from 'geodesic-voronoi';
import { BufferGeometry, Mesh } from 'three';
import { bumpySphere, glb, octahedron } from './meshes.mjs';
import { meshBinaryStl } from './model_files.mjs';

const { load, loadWorker } = api;

const notOptions = [null, 5, 'exact', true, [], () => {}];
const notObjects = [undefined, null, 5, 'x'];
const transferred = new Float64Array(3);
structuredClone(transferred, { transfer: [transferred.buffer] });
const notLists = [
  transferred,
  null,
  5,
  'abc',
  {},
  new Set([1]),
  new BigInt64Array(1),
  ['1'],
  [null],
  [{}],
  [1n],
];
const notIndices = notLists.filter((value) => typeof value !== 'number');
const notPoints = [
  ...notObjects,
  [],
  {},
  { face: [0] },
  { bary: [1, 0, 0] },
  { face: [0], bary: [1, 0] },
  ...notIndices.map((vertex) => ({ vertex })),
  ...notIndices.map((face) => ({ face, bary: [1, 0, 0] })),
  ...notLists.map((position) => ({ position })),
  { position: [0, 1] },
  { position: [0, NaN, 0] },
  { vertex: 0.5 },
  { vertex: [0.5] },
  { vertex: [NaN] },
  { vertex: [2 ** 32] },
  { face: [-0.5], bary: [1, 0, 0] },
  { face: [0], bary: [1, 0, '0'] },
];
/** Well formed, but not on the surface. */
const strayPoints = [
  { vertex: [-1] },
  { vertex: [6] },
  { face: [8], bary: [1, 0, 0] },
  { face: [-1], bary: [1, 0, 0] },
  { face: [0], bary: [NaN, 0, 0] },
  { face: [0], bary: [2, -1, 0] },
  { face: [0], bary: [0, 0, 0] },
];
const notTasks = [
  ...notOptions,
  { signal: null },
  { signal: {} },
  { signal: 5 },
  { onProgress: null },
  { onProgress: 'yes' },
];
const notCounts = [0, -1, 1.5, NaN, Infinity, '3', null, undefined, {}, 2n, 2 ** 31];
const notLabels = [-1, 0.5, NaN, '0', null, undefined, 2 ** 40];
const notNames = [null, 5, '', 'Exact', 'toString', {}, ['exact']];
const notBooleans = [null, 0, 1, 'yes', {}];
const notTolerances = [null, -1, NaN, '0', Infinity];
const notScales = [null, 0, -1, NaN, Infinity, '1', {}];

const toSites = ({ vertex }) => ({ face: [vertex].flat(), bary: [1, 0, 0] });

const gvd = await load();
const mesh = await gvd.mesh(octahedron());
const diagram = await mesh.voronoi({ vertex: [0, 1, 2, 3] });

/** What the calls of `f` with each of the values do, and how the sentences begin. */
async function refused(values, f, message, code = 'invalid-argument') {
  for (const value of values) {
    let error;
    try {
      await f(value);
    } catch (thrown) {
      error = thrown;
    }
    const shown = `${f} of ${String(JSON.stringify(value, (_, v) => (typeof v === 'bigint' ? `${v}n` : v)))}`;
    assert.ok(error instanceof api.GeodesicVoronoiError, `${shown}: ${error?.stack}`);
    assert.equal(error.code, code, `${shown}: ${error.message}`);
    assert.match(error.message, message, shown);
    assert.match(error.message, /^[^\n]{10,200}$/, shown);
  }
}

const one = { vertex: [0] };

test('load and loadWorker', async () => {
  await refused(notOptions, (options) => load(options), /^options is /);
  await refused([null, 5, true, {}, []], (wasm) => load({ wasm }), /^wasm is /);
  await refused(
    [''.padEnd(3), 'nowhere.wasm'],
    (wasm) => load({ wasm }),
    /cannot be loaded/,
    'load-failed',
  );
  await refused(
    [new Uint8Array(0), Buffer.from('wasm'), new DataView(new ArrayBuffer(9))],
    (wasm) => load({ wasm }),
    /cannot be loaded/,
    'load-failed',
  );
  await refused(
    [new Response('no', { status: 404 })],
    (wasm) => load({ wasm }),
    /404/,
    'load-failed',
  );
  await refused(notOptions, (options) => loadWorker(options), /^options is /);
  const terminate = () => assert.fail('it has been started');
  const ofNode = { postMessage: terminate, terminate };
  await refused([null, 5, true, {}, ofNode], (worker) => loadWorker({ worker }), /^worker is /);
  const worker = { ...ofNode, addEventListener: terminate };
  for (const wasm of ['nowhere.wasm', 'http://'])
    await refused(
      [wasm],
      (value) => loadWorker({ worker, wasm: value }),
      /^wasm is .*not an address$/,
    );
  await refused([5], (dracoWasm) => api.compileModules({ dracoWasm }), /no option "dracoWasm"/);
  const bytes = glb(octahedron());
  for (const gltfWasm of [null, 5, {}])
    await refused([gltfWasm], async () => (await load({ gltfWasm })).mesh(bytes), /^gltfWasm is /);
});

test('mesh', async () => {
  const { buffer } = glb(octahedron());
  const { positions, indices } = octahedron();
  await refused(
    [...notObjects, [], { a: 5 }, () => {}, new Float32Array(9), new Map(), new DataView(buffer)],
    (source) => gvd.mesh(source),
    /^a mesh is made from/,
  );
  // These have no entries of their own, as files in no folder.
  await refused(
    [Promise.resolve()],
    (source) => gvd.mesh(source),
    /^a mesh is .* Promise: await it$/,
  );
  await refused([new URL('file:///a.glb')], (source) => gvd.mesh(source), /URL: fetch or read the/);
  await refused(['a.glb'], (source) => gvd.mesh(source), /"a\.glb": fetch or read the/);
  await refused([transferred.buffer], (source) => gvd.mesh(source), /bytes .* were transferred/);
  await refused(
    ['v 0 0 0\n'.repeat(1e4)],
    (source) => gvd.mesh(source),
    /"v 0 0 0\\n.{10,100}…": encode it as bytes$/,
  );
  await refused(notOptions, (options) => gvd.mesh(octahedron(), options), /^options is /);
  await refused(
    notTasks.slice(notOptions.length),
    (options) => gvd.mesh(octahedron(), options),
    /^(signal|onProgress) is /,
  );
  await refused(
    notLists,
    (values) => gvd.mesh({ positions: values, indices }),
    /^positions(\[0\])? is /,
  );
  await refused(
    notLists,
    (values) => gvd.mesh({ positions, indices: values }),
    /^indices(\[0\])? is /,
  );
  await refused(
    notLists,
    (normals) => gvd.mesh({ positions, indices, normals }),
    /^normals(\[0\])? is /,
  );
  await refused(
    [[1], new Float32Array(17)],
    (normals) => gvd.mesh({ positions, indices, normals }),
    /^normals has /,
  );
  await refused(
    [[1], new Float32Array(13)],
    (uvs) => gvd.mesh({ positions, indices, uvs }),
    /^uvs has /,
  );
  const bytes = glb(octahedron());
  await refused(
    [null, 5, 'x', [1], { arrayBuffer: 5 }],
    (content) => gvd.mesh({ 'a.glb': bytes, 'a.bin': content }),
    /files by their paths/,
  );
  for (const source of [bytes, octahedron()]) {
    await refused([null, 5, 'x'], (limits) => gvd.mesh(source, { limits }), /^limits is /);
    await refused(
      [{ triangles: 5 }, { toString: 5 }],
      (limits) => gvd.mesh(source, { limits }),
      /name of a limit/,
    );
  }
  await refused(
    [null, -1, 0.5, NaN, '5', 2 ** 32],
    (maxTriangles) => gvd.mesh(bytes, { limits: { maxTriangles } }),
    /^limits\.maxTriangles is /,
  );
});

/** Has `f` find no memory for arrays. */
async function refusedWithoutMemory(f) {
  const own = Float64Array;
  globalThis.Float64Array = class {
    constructor() {
      throw new RangeError('Array buffer allocation failed');
    }
  };
  try {
    await refused([undefined], f, /not enough memory/, 'out-of-memory');
  } finally {
    globalThis.Float64Array = own;
  }
}

test('arrays for which there is no memory', async () => {
  const { positions, indices } = octahedron();
  await refusedWithoutMemory(() => gvd.mesh({ positions, indices }));
  const sphere = await gvd.mesh(bumpySphere(24, 36));
  const changed = await sphere.voronoi(await sphere.sampleSites(30));
  await changed.moveSite(0, { vertex: 5 });
  await refusedWithoutMemory(() => changed.data);
  assert.equal(changed.data.regionArea.length, 30, 'merged later');
});

test('a file for whose triangles there is no memory', async () => {
  const file = meshBinaryStl(octahedron());
  await refusedWithoutMemory(() => gvd.mesh(file));
});

/** What takes a signal and tells how far it is. */
const tasks = [
  (options) => mesh.sampleSites(2, options),
  (options) => mesh.sampleSites({ radius: 1 }, options),
  (options) => mesh.bareComponents(one, options),
  (options) => mesh.curvatureDensity(options),
  (options) => mesh.voronoi(one, options),
  (options) => mesh.distances(one, options),
  (options) => mesh.path(one, one, options),
  (options) => mesh.cvt(one, options).next(),
  (options) => mesh.closestPoints([0, 0, 0], options),
  (options) => mesh.positionsOf(toSites(one), options),
  (options) => mesh.readPoints(toSites(one), options),
  (options) => mesh.remesh(one, options),
  (options) => diagram.insertSite(one, options),
  (options) => diagram.moveSite(0, one, options),
  (options) => diagram.removeSite(0, options),
  (options) => diagram.locate(one, options),
  (options) => diagram.path(one, options),
  (options) => diagram.worstRegionPoint('size', options),
  (options) => diagram.partition(options),
  (options) => diagram.dual(options),
  (options) => diagram.dualPaths(options),
  (options) => diagram.violations(options),
  (options) => diagram.fetchData(options),
  (options) => diagram.remeshQuality(options),
  (options) => diagram.repair(options),
];

test('options that there are not', async () => {
  const partition = await diagram.partition();
  const polygons = await diagram.dual();
  const calls = [
    (options) => load(options),
    (options) => loadWorker(options),
    (options) => api.compileModules(options),
    (options) => gvd.mesh(octahedron(), options),
    ...tasks,
    (options) => api.partitionGlb(partition, options),
    (options) => api.partitionObj(partition, options),
    (options) => api.partitionPly(partition, options),
    (options) => api.partitionStl(partition, options),
    (options) => api.polygonGlb(polygons, options),
    (options) => api.polygonObj(polygons, options),
    (options) => api.polygonPly(polygons, options),
    (options) => api.polygonStl(polygons, options),
  ];
  for (const call of calls) {
    await refused(
      [
        { nonsense: 1 },
        { toString: 1 },
        { '': 1 },
        { nonsense: undefined },
        { ['x'.repeat(9e5)]: 1 },
      ],
      call,
      /^there is no option ".*" here: (the nearest is "\w+"|there are \w+(, \w+)+|there is only \w+)$/,
    );
  }
  const nearest = [
    [{ metrik: 'exact' }, 'metrik', 'metric'],
    [{ Metric: 'exact' }, 'Metric', 'metric'],
    [{ details: 1 }, 'details', 'detail'],
    [{ onprogress() {} }, 'onprogress', 'onProgress'],
  ];
  for (const [options, name, known] of nearest) {
    await refused(
      [options],
      (value) => mesh.voronoi(one, value),
      new RegExp(`^there is no option "${name}" here: the nearest is "${known}"$`),
    );
  }
  await refused([{ seeds: 1 }], (value) => mesh.sampleSites(2, value), /"seed"$/);
  await refused([{ Radius: 1 }], (value) => mesh.sampleSites(value), /radius/);
  await refused([{}], (value) => mesh.sampleSites(value), /^radius is undefined, not a positive/);
});

test('how a mesh is made', async () => {
  await refused(
    [null, -1e-9, 1.1, NaN, Infinity, '0', {}],
    (weld) => gvd.mesh(octahedron(), { weld }),
    /^weld is .*, not a number from 0 to 1$/,
  );
  await refused(
    [null, -0.1, 1.5, NaN, '0.1'],
    (maxEdge) => gvd.mesh(octahedron(), { maxEdge }),
    /^maxEdge is .*, not a number from 0 to 1$/,
  );
  await refused(
    notNames,
    (orientation) => gvd.mesh(octahedron(), { orientation }),
    /^orientation is /,
  );
  await refused(
    [null, -1, 0.5, NaN, '1', 2 ** 31],
    (minComponent) => gvd.mesh(octahedron(), { minComponent }),
    /^minComponent is /,
  );
});

test('sampleSites', async () => {
  await refused(
    notCounts.filter((count) => typeof count !== 'object' || !count),
    (count) => mesh.sampleSites(count),
    /^count is /,
  );
  await refused([[5]], (count) => mesh.sampleSites(count), /^count is of type Array/);
  await refused(
    [null, 0, -1, NaN, Infinity, '1', undefined],
    (radius) => mesh.sampleSites({ radius }),
    /^radius is /,
  );
  await refused(
    [null, -1, 0.5, NaN, '1', 2 ** 31],
    (perComponent) => mesh.sampleSites(2, { perComponent }),
    /^perComponent is /,
  );
  await refused(notNames, (worst) => diagram.worstRegionPoint(worst), /^worst is /);
  await refused(notOptions, (options) => mesh.sampleSites(2, options), /^options is /);
  await refused(
    [-1, 0.5, NaN, '1', null, 2 ** 53],
    (seed) => mesh.sampleSites(2, { seed }),
    /^seed is /,
  );
  await refused(notNames, (sampling) => mesh.sampleSites(2, { sampling }), /^sampling is /);
});

test('points, wherever they are taken', async () => {
  const takers = {
    sites: [
      (points) => mesh.voronoi(points),
      (points) => mesh.distances(points),
      (points) => mesh.cvt(points).next(),
      (points) => mesh.remesh(points),
    ],
    from: [(point) => mesh.path(point, one)],
    to: [(point) => mesh.path(one, point)],
    points: [(points) => diagram.locate(points)],
    point: [(point) => diagram.path(point)],
    site: [(site) => diagram.insertSite(site), (site) => diagram.moveSite(0, site)],
  };
  for (const [name, functions] of Object.entries(takers)) {
    for (const f of functions) {
      await refused(
        notPoints,
        f,
        new RegExp(`^${name}(\\.(face|bary|vertex|position)(\\[\\d\\])?)? (is|has) `),
      );
      await refused(strayPoints, f, /./, 'invalid-point');
    }
  }
  for (const name of ['from', 'to'])
    await refused(strayPoints, takers[name][0], new RegExp(`^${name}: `), 'invalid-point');
  const single = ['from', 'to', 'point', 'site'].flatMap((name) => takers[name]);
  for (const f of single)
    await refused([{ vertex: [] }, { vertex: [0, 1] }], f, /is a list of \d points/);
  for (const f of takers.sites) await refused([{ vertex: [] }], f, /site/);
});

test('results that pointsJson has no points of', async () => {
  const { pointsJson } = api;
  await refused(
    [one, { position: [0, 0, 0] }],
    pointsJson,
    /^points has no face: it needs face, bary$/,
  );
  await refused([{ face: 1 }], pointsJson, /^points\.face is 1, not an object or an array$/);
  await refused(
    [diagram, await mesh.distances(one)],
    pointsJson,
    /^points is a result: pass its sites$/,
  );
  await refused([diagram.data], api.diagramJson, /^diagram has no sites: it needs sites, data$/);
});

test('what is not points or a mesh, but has some', async () => {
  for (const [sites, message] of [
    [diagram, /^sites is a result: pass its sites$/],
    [mesh.cvt(one), /^sites is what cvt gives: loop over it, and pass the sites of a state$/],
    [mesh.sampleSites(3), /^sites is a promise: await it$/],
  ])
    await refused([sites], (points) => mesh.voronoi(points), message);
  const place = { getX: () => 0, getY: () => 0, getZ: () => 0 };
  for (const [source, message] of [
    [new BufferGeometry(), /^the geometry's position is undefined, not an attribute of three\.js$/],
    [{ isBufferGeometry: true, attributes: null }, /^the geometry's position is undefined/],
    [
      { isBufferGeometry: true, attributes: { position: { ...place, count: -1 } } },
      /^the geometry's position\.count is -1, not an integer /,
    ],
    [
      { isBufferGeometry: true, attributes: { position: { ...place, count: 1e9 } } },
      /^the geometry's position\.count is 1000000000, not an integer from 0 to 178956970$/,
    ],
    [Readable.from(['v 0 0 0']), /Readable: await new Response\(stream\)\.arrayBuffer\(\)$/],
    [new Mesh(), /this is of type Mesh: pass its geometry$/],
    // Of these, JSON would not have made objects.
    [
      { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: BigInt64Array.of(0n, 1n, 2n) },
      /^indices is of type BigInt64Array, not an array of numbers$/,
    ],
  ])
    await assert.rejects(gvd.mesh(source), { code: 'invalid-argument', message });
});

test('the options of every task', async () => {
  const reason = new Error('given up before it began');
  for (const task of tasks) {
    await refused(notTasks, task, /^(options|signal|onProgress) is /);
    await assert.rejects(task({ signal: AbortSignal.abort(reason) }), reason, String(task));
  }
});

test('a diagram', async () => {
  for (const metric of notNames) {
    await refused([metric], (value) => mesh.voronoi(one, { metric: value }), /^metric is /);
    await refused([metric], (value) => mesh.distances(one, { metric: value }), /^metric is /);
  }
  await refused(
    [-1, 0.5, 11, NaN, '1', null],
    (detail) => mesh.voronoi(one, { detail }),
    /^detail is /,
  );
  await refused(notLabels, (label) => diagram.moveSite(label, one), /^label is /);
  await refused(notLabels, (label) => diagram.removeSite(label), /^label is /);
  await refused([4, 99], (label) => diagram.moveSite(label, one), /\b(4|99)\b/);
  await refused([4, 99], (label) => diagram.removeSite(label), /\b(4|99)\b/);
  await refused(
    notBooleans,
    (leaveOutIndifferent) => diagram.partition({ leaveOutIndifferent }),
    /^leaveOutIndifferent is /,
  );
  await refused(
    notBooleans,
    (leaveOutUnreachable) => diagram.partition({ leaveOutUnreachable }),
    /^leaveOutUnreachable is /,
  );
  await refused(notBooleans, (primal) => diagram.dual({ primal }), /^primal is /);
  await refused(
    [-1, 0.5, NaN, '1', null],
    (maxAdded) => diagram.repair({ maxAdded }),
    /^maxAdded is /,
  );
});

test('cvt', async () => {
  const start = (options) => mesh.cvt({ vertex: [0, 1] }, options).next();
  await refused(notNames, (method) => start({ method }), /^method is /);
  await refused(notNames, (metric) => start({ metric }), /^metric is /);
  await refused(
    [-1, 0.5, NaN, '1', null],
    (iterations) => start({ iterations }),
    /^iterations is /,
  );
  await refused(
    notTolerances,
    (energyTolerance) => start({ energyTolerance }),
    /^energyTolerance is /,
  );
  await refused([1.5], (energyTolerance) => start({ energyTolerance }), /number from 0 to 1$/);
  await refused(notTolerances, (moveTolerance) => start({ moveTolerance }), /^moveTolerance is /);
  await refused(notLists, (density) => start({ density }), /^density(\[0\])? is /);
  await refused(
    ['bend'],
    (density) => start({ density }),
    /"bend", not "attribute", "curvature" or/,
  );
  await refused(
    [[1], new Float64Array(6).fill(-1), new Float64Array(6).fill(NaN)],
    (density) => start({ density }),
    /densit/,
  );
  const zero = [new Float64Array(6), [0, 0, 0, 0, 0, -0]];
  await refused(
    zero,
    (density) => start({ density }),
    /^the density is zero all over the surface$/,
  );
  await refused(zero, (density) => mesh.sampleSites(2, { density }), /^the density is zero all ov/);
  await refused(notLists, (fixedSites) => start({ fixedSites }), /^fixedSites(\[0\])? is /);
  await refused([[0.5], [NaN]], (fixedSites) => start({ fixedSites }), /^fixedSites\[0\] is /);
  await refused([[-1], [2]], (fixedSites) => start({ fixedSites }), /site (-1|2) /);
  await refused(notBooleans, (data) => start({ data }), /^data is /);
  await refused(notBooleans, (diagrams) => start({ diagrams }), /^diagrams is /);
});

test('remesh', async () => {
  const start = (options) => mesh.remesh({ vertex: [0, 1] }, options);
  await refused(notNames, (method) => start({ method }), /^method is /);
  await refused([-1, 0.5, NaN, '1', null], (maxAdded) => start({ maxAdded }), /^maxAdded is /);
  await refused(notLists, (density) => start({ density }), /^density(\[0\])? is /);
  await refused([true], (data) => start({ data }), /^there is no option "data" here/);
  await refused(notLists, (positions) => mesh.closestPoints(positions), /^positions(\[0\])? is /);
});

test('what writes files', async () => {
  const partition = await diagram.partition();
  const polygons = await diagram.dual();
  const distances = await mesh.distances(one);
  const paths = [await mesh.path(one, one)];
  const [result, list, missing] = [
    [...notObjects, {}, []],
    [...notObjects, {}],
    /^(\w+|paths\[0\])(\.\w+)? (is|has no) /,
  ];
  for (const f of [
    api.diagramJson,
    api.diagramObj,
    api.diagramGlb,
    api.distancesJson,
    api.partitionJson,
    api.partitionGlb,
    api.partitionObj,
    api.partitionPly,
    api.partitionStl,
    api.partitionCsv,
    api.polygonJson,
    api.polygonGlb,
    api.polygonObj,
    api.polygonPly,
    api.polygonStl,
  ])
    await refused(result, (value) => f(value), missing);
  for (const f of [api.pathsJson, api.pathsObj])
    await refused([...list, [null], [{}]], (value) => f(value), missing);
  for (const f of [api.distancesPly, api.distancesGlb]) {
    await refused(result, (source) => f(distances, { mesh: source }), /^mesh/);
    await refused([undefined, {}], (options) => f(distances, options), /^mesh is undefined/);
    await refused(result, (value) => f(value, { mesh }), /^distances/);
  }
  await refused(result, (sites) => api.partitionJson(partition, { sites }), /^sites/);
  const { sites } = diagram;
  const plain = [
    ...[api.diagramJson, api.diagramObj, api.diagramGlb].map((f) => [f, diagram]),
    [api.distancesJson, distances],
    ...[api.distancesPly, api.distancesGlb].map((f) => [f, distances, { mesh }]),
    ...[api.pathsJson, api.pathsObj].map((f) => [f, paths]),
    [api.partitionJson, partition, { sites }],
    [api.polygonJson, polygons],
    [api.partitionStl, partition],
    [api.partitionCsv, partition],
    [api.polygonStl, polygons],
  ];
  for (const [f, value, more] of plain) {
    await refused(notOptions, (options) => f(value, options), /^options is /);
    await refused(notScales, (scale) => f(value, { ...more, scale }), /^scale is /);
  }
  const notRegions = [null, -2, 0.5, '0', partition.regions.area.length];
  await refused(notRegions, (region) => api.partitionStl(partition, { region }), /^region is /);
  await refused([null, 5, {}], (unit) => api.diagramJson(diagram, { unit }), /^unit is /);
  await refused([...notObjects, []].slice(1, 3), (value) => api.repairSentences(value), /^repairs/);
  await refused(
    [null, 0, -1, NaN, '1'],
    (samples) => diagram.accuracy({ samples }),
    /^samples is .*, not an integer from 1 /,
  );
  const writers = [
    ...[api.partitionGlb, api.partitionObj, api.partitionPly].map((f) => [f, partition]),
    ...[api.polygonGlb, api.polygonObj, api.polygonPly].map((f) => [f, polygons]),
  ];
  for (const [f, value] of writers) {
    await refused(notOptions, (options) => f(value, options), /^options is /);
    await refused(notScales, (scale) => f(value, { scale }), /^scale is /);
    await refused([null, 5, {}], (source) => f(value, { mesh: source }), /^mesh/);
  }
  await refused(notNames, (layout) => api.partitionGlb(partition, { layout }), /^layout is /);
  // A mesh that the result is not of.
  const other = await gvd.mesh({
    positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    normals: new Array(9).fill(1),
  });
  for (const f of [api.distancesPly, api.distancesGlb])
    await refused([other], (source) => f(distances, { mesh: source }), /3 vertices.*are of 6$/);
  for (const [f, value] of writers)
    await refused([other], (source) => f(value, { mesh: source }), /1 triangle:.*triangle [1-7]$/);
  await refused(
    [one],
    (value) => api.partitionJson(partition, { sites: toSites(value) }),
    /1 point:.*4 regions$/,
  );
  const notColours = [null, 5, 'red', {}, [5], [null], [[1, 0, NaN]], [['1', 0, 0]]];
  for (const layout of ['regions', 'features']) {
    const glbOf = (colours) => api.partitionGlb(partition, { colours, layout });
    await refused(notColours, glbOf, /^colours/);
    await refused([[[1, 0]]], glbOf, /^colours\[0\] has 2 numbers, not three$/);
    await refused([[[1, 0, 2]]], glbOf, /^colours\[0\]\[2\] is 2, not a number from 0 to 1$/);
    glbOf([undefined, [1, 0, 0.5]]);
  }
  await refused([...notObjects, [], {}], (bytes) => api.gltfResourceUris(bytes), /^bytes is /);
  await refused([...notObjects, [], { a: 1 }], (files) => api.findModel(files), /^a mesh is made /);
  await refused(
    [...notObjects, [], { a: 1 }],
    (files) => api.listModels(files),
    /^a mesh is made /,
  );
});

test('what has been disposed', async () => {
  const library = await load();
  const ownMesh = await library.mesh(octahedron());
  const ownDiagram = await ownMesh.voronoi({ vertex: [0, 1] });
  ownDiagram.dispose();
  ownDiagram.dispose();
  const ofDiagram = [
    () => ownDiagram.insertSite(one),
    () => ownDiagram.moveSite(0, one),
    () => ownDiagram.removeSite(0),
    () => ownDiagram.locate(one),
    () => ownDiagram.path(one),
    () => ownDiagram.partition(),
    () => ownDiagram.dual(),
    () => ownDiagram.violations(),
    () => ownDiagram.remeshQuality(),
    () => ownDiagram.repair(),
  ];
  for (const f of ofDiagram) await refused([0], f, /the diagram has been disposed/, 'disposed');
  ownMesh.dispose();
  const ofMesh = [
    () => ownMesh.sampleSites(2),
    () => ownMesh.voronoi(one),
    () => ownMesh.voronoi({ face: [0], bary: [1, 0, 0] }),
    () => ownMesh.distances(one),
    () => ownMesh.path(one, one),
    () => ownMesh.closestPoints([0, 0, 0]),
    () => ownMesh.remesh(one),
    () => ownMesh.cvt(one).next(),
  ];
  for (const f of ofMesh) await refused([0], f, /the mesh has been disposed/, 'disposed');
  library.dispose();
  library.dispose();
  await refused([0], () => library.mesh(octahedron()), /the library has been disposed/, 'disposed');
});
