// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gltfResourceUris, load } from 'geodesic-voronoi';
import {
  BoxGeometry,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Int16BufferAttribute,
  Vector3,
} from 'three';
import { apart, glb, gltf, grid, octahedron, placeOf, torn, withFlipped } from './meshes.mjs';
import { meshPly } from './model_files.mjs';
import { fails, near } from './expectations.mjs';

const gvd = await load();

test('a mesh of arrays: counts, topology, measures', async () => {
  const { info } = await gvd.mesh(octahedron());
  assert.equal(info.vertices, 6);
  assert.equal(info.edges, 12);
  assert.equal(info.faces, 8);
  assert.equal(info.components, 1);
  assert.equal(info.boundaryLoops, 0);
  assert.equal(info.eulerCharacteristic, 2);
  assert.equal(info.genus, 0);
  near(info.area, 4 * Math.sqrt(3), 1e-12);
  near(info.boundingDiagonal, Math.sqrt(12), 1e-12);
  assert.deepEqual(info.notes, []);
  assert.ok(Object.values(info.repairs).every((count) => count === 0));
});

test('a mesh keeps copies of what it was made from', async () => {
  const positions = Float32Array.from(grid(1).positions);
  const indices = Uint16Array.from(grid(1).indices);
  const mesh = await gvd.mesh({ positions, indices });
  positions.fill(7);
  indices.fill(7);
  assert.deepEqual([...mesh.positions], grid(1).positions);
  assert.deepEqual([...mesh.indices], grid(1).indices);
  assert.deepEqual(mesh.parts, []);
});

test('a geometry of three.js: its attributes, however they are stored', async () => {
  const plain = new BoxGeometry(1, 2, 3);
  const { attributes, index } = plain;
  const interleaved = new BufferGeometry();
  const buffer = new InterleavedBuffer(new Float32Array(5 * attributes.position.count), 5);
  interleaved.setIndex(index);
  interleaved.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0));
  interleaved.setAttribute('uv', new InterleavedBufferAttribute(buffer, 2, 3));
  const normalized = new BufferGeometry().setIndex(index);
  normalized.setAttribute('position', new Int16BufferAttribute(3 * attributes.position.count, 3));
  normalized.attributes.position.normalized = true;
  for (let v = 0; v < attributes.position.count; ++v) {
    const place = new Vector3().fromBufferAttribute(attributes.position, v);
    interleaved.attributes.position.setXYZ(v, ...place);
    interleaved.attributes.uv.setXY(v, attributes.uv.getX(v), attributes.uv.getY(v));
    normalized.attributes.position.setXYZ(v, ...place.divideScalar(2));
  }

  const { positions, indices, normals, uvs, info } = await gvd.mesh(plain);
  near(info.area, 22, 1e-12);
  assert.deepEqual(positions, Float64Array.from(attributes.position.array));
  assert.deepEqual(indices, Int32Array.from(index.array));
  assert.deepEqual(normals, Float64Array.from(attributes.normal.array));
  assert.deepEqual(uvs, Float64Array.from(attributes.uv.array));
  const mesh = await gvd.mesh(interleaved);
  assert.deepEqual([mesh.positions, mesh.indices, mesh.uvs], [positions, indices, uvs]);
  assert.equal(mesh.normals.length, 0);
  near((await gvd.mesh(normalized)).info.area, 22 / 4, 1e-3);
  const loose = await gvd.mesh(plain.toNonIndexed());
  assert.deepEqual([loose.info.faces, loose.info.area], [info.faces, info.area]);
});

test('building a mesh takes no more memory than the mesh', async (t) => {
  const { instantiate } = WebAssembly;
  let memory;
  t.mock.method(WebAssembly, 'instantiate', async (...args) => {
    const instance = await instantiate(...args);
    memory = instance.exports.memory;
    return instance;
  });
  const own = await load();
  const { info } = await own.mesh(grid(387));
  const bytes = memory.buffer.byteLength / info.faces;
  own.dispose();
  // 175 bytes are the mesh; the rest are the 17 MB that the module begins with, and growth ahead.
  assert.ok(bytes < 210, `${bytes} bytes per triangle`);
});

test('repairs are counted by name', async () => {
  const { positions, indices } = withFlipped(grid(2), 3);
  const mesh = await gvd.mesh({
    positions: [...positions, 0, 0, 0, NaN, 0, 0],
    indices: [...indices, 0, 1, 9, 0, 1, 10],
  });
  const { repairs } = mesh.info;
  assert.equal(repairs.flippedTriangles, 1);
  assert.equal(repairs.weldedVertices, 1);
  assert.equal(repairs.degenerateTriangles, 1);
  assert.equal(repairs.nonFiniteTriangles, 1);
  assert.equal(mesh.info.faces, 8);
  assert.equal(mesh.info.inputFaces, 10);
});

test('mollification is told: what flat triangles cost all edges', async () => {
  const { positions, indices } = grid(2);
  // A corner in the middle of a side of its triangle.
  const mesh = await gvd.mesh({
    positions: [...positions, 0.25, 0, 0],
    indices: [...indices, 1, 0, 9],
  });
  const { mollifiedTriangles, mollification } = mesh.info.repairs;
  assert.equal(mollifiedTriangles, 1);
  assert.ok(mollification > 0 && mollification < 1e-10);
});

test('a GLB comes in world space, with its parts', async () => {
  const mesh = await gvd.mesh(glb(octahedron(), { translation: [10, 0, 0] }));
  assert.equal(mesh.positions[0], 11);
  assert.equal(mesh.info.faces, 8);
  assert.deepEqual(mesh.parts, [
    { name: 'Bläck', node: 0, mesh: 0, primitive: 0, firstTriangle: 0, triangleCount: 8 },
  ]);
});

test('a GLB may be a view of a larger buffer, or an ArrayBuffer', async () => {
  const bytes = glb(octahedron());
  const larger = new Uint8Array(bytes.length + 9);
  larger.set(bytes, 3);
  assert.equal((await gvd.mesh(larger.subarray(3, 3 + bytes.length))).info.faces, 8);
  assert.equal((await gvd.mesh(bytes.buffer)).info.faces, 8);
});

test('a .gltf takes its buffer from the files beside it, and names one that is missing', async () => {
  const { json, buffer } = gltf(octahedron(), { uri: 'shape%20one.bin' });
  const bytes = new TextEncoder().encode(JSON.stringify(json));
  assert.deepEqual(gltfResourceUris(bytes), ['shape%20one.bin']);
  const mesh = await gvd.mesh({ 'a.gltf': bytes, 'shape one.bin': buffer });
  assert.equal(mesh.info.faces, 8);
  await assert.rejects(gvd.mesh(bytes), fails('invalid-gltf', /shape.*one\.bin/));
});

test('gltfResourceUris names no resources where there are none', () => {
  assert.deepEqual(gltfResourceUris(glb(octahedron())), []);
  assert.deepEqual(gltfResourceUris(new Uint8Array(5)), []);
  const comment = '# {"buffers":[{"uri":"a.bin"}]}\nv 0 0 0\n';
  assert.deepEqual(gltfResourceUris(new TextEncoder().encode(comment)), []);
  const { json } = gltf(octahedron(), { uri: 'data:application/octet-stream;base64,AAAA' });
  assert.deepEqual(gltfResourceUris(new TextEncoder().encode(JSON.stringify(json))), []);
});

test('a mesh that cannot be made says why', async () => {
  const { positions, indices } = octahedron();
  const cases = [
    [{ positions: [], indices: [] }, 'invalid-mesh'],
    [{ positions, indices: [] }, 'invalid-mesh'],
    [{ positions, indices: [0, 1] }, 'invalid-mesh'],
    [{ positions: positions.slice(1), indices }, 'invalid-mesh'],
    [{ positions, indices: [0, 1, 6] }, 'invalid-mesh', /6/],
    [{ positions, indices: [0, 1, -1] }, 'invalid-mesh', /-1/],
    [{ positions, indices: [0, 1, 1] }, 'invalid-mesh'],
    [{ positions: positions.map(() => NaN), indices }, 'invalid-mesh'],
    [{ positions, indices: [0, 1, 1.5] }, 'invalid-argument', /indices\[2\] is 1\.5/],
    [{ positions, indices: [0, 1, 2 ** 32] }, 'invalid-argument', /indices\[2\] is 4294967296/],
    [{ positions: positions.slice(1) }, 'invalid-argument', /without indices/],
    [new Uint8Array(0), 'invalid-file', /empty/],
    [
      new TextEncoder().encode('no model'),
      'invalid-file',
      /none of the formats.*OBJ, OFF, PLY or STL/,
    ],
    [
      Buffer.from('\ufeff# UTF-16\nv 0 0 0\nv 12 0 0\nv 0 12 0\nf 1 2 3\n', 'utf16le'),
      'invalid-file',
      /is UTF-16 text: save it as UTF-8/,
    ],
    [glb(octahedron()).subarray(0, 300), 'invalid-gltf'],
  ];
  for (const [source, code, message = /./] of cases) {
    await assert.rejects(gvd.mesh(source), fails(code, message));
  }
});

test('the format of bytes without a name is found', async () => {
  const text = (string) => new TextEncoder().encode(string);
  const corners = '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
  const binary = new Uint8Array(84 + 50 + 2); // two bytes more than the triangle takes
  const view = new DataView(binary.buffer);
  view.setUint32(80, 1, true);
  view.setFloat32(84 + 24, 1, true);
  view.setFloat32(84 + 40, 1, true);
  const facet = ['0 0 0', '1 0 0', '0 1 0'].map((place) => `VERTEX ${place}\n`).join('');
  const cases = [
    ['OFF', text(`# by hand\nOFF\n3 1 0\n${corners}`)],
    ['OFF', text(`# by hand\nOFF\n3 1 0\n${corners}`.replaceAll('\n', '\r\n'))],
    ['OFF', text(`# by hand\nOFF\n3 1 0\n${corners}`.replaceAll('\n', '\r'))],
    ['OFF', text(`3 1 0\n${corners}`)],
    ['OFF', text(`NCOFF\n3 1 0\n${corners}`)], // in the order of MeshLab, not of Geomview
    ['OBJ', text('# OFF\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')],
    ['STL', text(`SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\n${facet}ENDLOOP\nENDFACET\nENDSOLID\n`)],
    ['STL', binary],
  ];
  for (const [format, bytes] of cases) {
    const { info } = await gvd.mesh(bytes);
    assert.equal(info.origin.format, format);
    assert.equal(info.faces, 1);
  }
});

test('vertices within sides of other triangles are told of', async () => {
  const positions = [0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0, 0, -1, 0, 2, -1, 0];
  const { info } = await gvd.mesh({ positions, indices: [0, 1, 2, 0, 4, 3, 3, 5, 1] });
  assert.equal(info.hasTJunctions, true);
  assert.equal(info.hasOpenSeams, false);
  assert.match(info.notes.at(-1), /T-junctions.*the option weld, 1e-6/);
  const torn = [...positions, 1e-6, 0, 0];
  const both = await gvd.mesh({ positions: torn, indices: [0, 1, 2, 6, 4, 3, 3, 5, 1] });
  assert.deepEqual([both.info.hasTJunctions, both.info.hasOpenSeams], [true, true]);
  assert.deepEqual(both.info.notes, info.notes);
  const whole = await gvd.mesh({ positions, indices: [0, 3, 2, 3, 1, 2, 0, 4, 3, 3, 5, 1] });
  assert.equal(whole.info.hasTJunctions, false);
  assert.deepEqual(whole.info.notes, []);
});

test('vertices within sides of other triangles are joined to these on request', async () => {
  const positions = [0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0, 0, -1, 0, 2, -1, 0];
  const mesh = await gvd.mesh({ positions, indices: [0, 1, 2, 0, 4, 3, 3, 5, 1] }, { weld: 1e-6 });
  const { info } = mesh;
  assert.equal(info.repairs.joinedVertices, 1);
  assert.equal(info.components, 1);
  assert.equal(info.hasTJunctions, false);
  assert.equal(info.inputFaces, 3);
  assert.equal(info.faces, 4);
  const { data } = await mesh.voronoi({ vertex: [2, 5] });
  assert.deepEqual([...data.faceLabel], [-2, -2, 1]);
  for (const face of data.segments.face) assert.ok(face < 3);
  const { length, points } = await mesh.path({ vertex: 2 }, { vertex: 4 });
  near(length, 3, 1e-5);
  for (const face of points.face) assert.ok(face < 3);
});

test('vertices are welded within a tolerance, in triangles and in files', async () => {
  const apartByAHair = torn(octahedron(), 1e-6);
  for (const source of [apartByAHair, glb(apartByAHair)]) {
    const seen = (await gvd.mesh(source)).info;
    assert.equal(seen.components, 8);
    assert.equal(seen.hasOpenSeams, true);
    assert.match(seen.notes.at(-1), /nearly coincide.*the option weld, 1e-6/);
    const { info } = await gvd.mesh(source, { weld: 1e-5 });
    assert.equal(info.components, 1);
    assert.equal(info.boundaryLoops, 0);
    assert.equal(info.hasOpenSeams, false);
    assert.deepEqual(info.notes, []);
    assert.equal(info.repairs.weldedVertices, 18);
  }
});

test('orientations are unified, or kept', async () => {
  const source = withFlipped(octahedron(), 3);
  const unified = await gvd.mesh(source, { orientation: 'unify' });
  assert.equal(unified.info.repairs.flippedTriangles, 1);
  assert.equal(unified.info.boundaryLoops, 0);
  const { info } = await gvd.mesh(source, { orientation: 'keep' });
  assert.equal(info.repairs.flippedTriangles, 0);
  assert.equal(info.repairs.orientationCuts, 3);
  assert.equal(info.components, 2);
});

test('edges are halved until none is long, with what belongs to vertices and triangles', async () => {
  const input = apart(octahedron(), grid(1));
  const normals = octahedron().positions.concat(
    Array.from({ length: 12 }, (_, i) => +(i % 3 === 2)),
  );
  const density = input.positions.filter((_, i) => i % 3 === 0).map((x) => x + 1);
  const uvs = density.flatMap((_, v) => [input.positions[3 * v], 0.25]);
  const whole = await gvd.mesh({ ...input, normals, density, uvs });
  assert.equal(whole.parents.length, 0);
  const mesh = await gvd.mesh({ ...input, normals, density, uvs }, { maxEdge: 0.05 });
  const { info, positions, parents } = mesh;
  const triangles = input.indices.length / 3;
  assert.ok(info.inputFaces > 5 * triangles);
  assert.deepEqual(info.notes, [
    `long edges were halved: ${triangles} triangles became ${info.inputFaces}`,
  ]);
  near(info.area, whole.info.area, 1e-12);
  near(info.boundingDiagonal, whole.info.boundingDiagonal);
  assert.deepEqual(positions.slice(0, input.positions.length), whole.positions);
  assert.equal(parents.length, info.inputFaces);
  assert.deepEqual([...new Set(parents)], [...Array(triangles).keys()]);
  for (let h = 0; h < mesh.indices.length; ++h) {
    const [from, to] = [mesh.indices[h], mesh.indices[h % 3 === 2 ? h - 2 : h + 1]];
    const length = Math.hypot(
      ...[0, 1, 2].map((k) => positions[3 * from + k] - positions[3 * to + k]),
    );
    assert.ok(length <= 0.05 * info.boundingDiagonal * (1 + 1e-12));
  }
  for (let v = 0; v < info.inputVertices; ++v) {
    near(Math.hypot(...mesh.normals.subarray(3 * v, 3 * v + 3)), 1);
    near(mesh.density[v], positions[3 * v] + 1);
    near(mesh.uvs[2 * v], positions[3 * v]);
    near(mesh.uvs[2 * v + 1], 0.25);
  }
  // Results are in terms of the parts.
  const diagram = await mesh.voronoi({ vertex: [0, 1] });
  assert.equal(diagram.data.faceLabel.length, info.inputFaces);
});

test('a point before subdivision stays on its triangle where surfaces touch', async () => {
  const { positions, indices } = apart(grid(2), grid(3));
  const touching = { positions: positions.map((x) => (x < 5 ? x : x - 5)), indices };
  const whole = await gvd.mesh(touching);
  const mesh = await gvd.mesh(touching, { maxEdge: 0.1 });
  assert.deepEqual([whole.info.components, mesh.info.components], [2, 2]);
  const face = Int32Array.from({ length: whole.info.inputFaces + 1 }, (_, f) => f - 1);
  const bary = Float64Array.from([...face].flatMap((f) => (f < 0 ? [0, 0, 0] : [0.7, 0.2, 0.1])));
  const sites = { face, bary };
  const read = await mesh.readPoints({ mesh: { faces: whole.info.inputFaces }, sites });
  assert.deepEqual(
    Array.from(read.face, (f) => (f < 0 ? f : mesh.parents[f])),
    [...face],
  );
  const [before, now] = [await whole.positionsOf(sites), await mesh.positionsOf(read)];
  before.forEach((x, i) => i < 3 || near(now[i], x));
});

test('a point may be outside its triangle by the tolerance of the core, also before subdivision', async () => {
  const [whole, finer] = [await gvd.mesh(grid(1)), await gvd.mesh(grid(1), { maxEdge: 0.01 })];
  const at = (b) => ({ face: [1], bary: [b, 0.5, 0.5 - b] });
  const [within, beyond] = [at(-0.9e-6), at(-1.1e-6)];
  const wrong = {
    code: 'invalid-point',
    message: /point 0: the barycentric coordinate .* is negative/,
  };
  const diagram = await whole.voronoi({ vertex: 0 });
  for (const check of [
    (points) => diagram.locate(points),
    (points) => whole.positionsOf(points),
    (points) => whole.readPoints(points),
    async (points) => finer.voronoi(await finer.readPoints({ mesh: { faces: 2 }, sites: points })),
  ]) {
    await check(within);
    await assert.rejects(check(beyond), wrong);
  }
});

test('the parts of a model are told by their triangles after subdivision', async () => {
  const bytes = glb(apart(octahedron(), grid(2)));
  const [whole, mesh] = [await gvd.mesh(bytes), await gvd.mesh(bytes, { maxEdge: 0.1 })];
  assert.equal(mesh.info.origin.format, 'glTF');
  for (const [i, part] of mesh.parts.entries()) {
    const { firstTriangle, triangleCount } = whole.parts[i];
    mesh.parents.forEach((parent, t) =>
      assert.equal(
        t >= part.firstTriangle && t < part.firstTriangle + part.triangleCount,
        parent >= firstTriangle && parent < firstTriangle + triangleCount,
      ),
    );
  }
});

test('small components are dropped, and their triangles keep their numbers', async () => {
  const both = await gvd.mesh(apart(octahedron(), grid(2)), { minComponent: 8 });
  assert.equal(both.info.components, 2);
  const rest = await gvd.mesh(apart(grid(1), octahedron()), { minComponent: 3 });
  const { info } = rest;
  assert.equal(info.faces, 8);
  assert.equal(info.inputFaces, 10);
  assert.equal(info.repairs.smallComponents, 1);
  assert.equal(info.repairs.smallComponentTriangles, 2);
  const { data } = await rest.voronoi({ face: [2], bary: [1, 0, 0] });
  assert.deepEqual([...data.faceLabel], [-3, -3, 0, 0, 0, 0, 0, 0, 0, 0]);
  await assert.rejects(
    rest.voronoi({ face: [1], bary: [1, 0, 0] }),
    fails('invalid-point', /triangle 1 was dropped/),
  );
  await assert.rejects(
    gvd.mesh(octahedron(), { minComponent: 9 }),
    fails('invalid-mesh', /no component has 9 triangles: the largest has 8/),
  );
});

test('limits of a glTF can be lowered and raised; the error names the one to raise', async () => {
  const bytes = glb(octahedron());
  await assert.rejects(
    gvd.mesh(bytes, { limits: { maxTriangles: 7 } }),
    fails('invalid-gltf', /more than 7 triangles; raise the limit maxTriangles/),
  );
  const limits = { maxJsonBytes: 2 ** 20, maxObjects: 100, maxVertices: 6, maxTriangles: 8 };
  const mesh = await gvd.mesh(bytes, { limits: { ...limits, maxZeroElements: 0 } });
  assert.equal(mesh.info.faces, 8);
  // As of any option, undefined stands for the default.
  assert.equal((await gvd.mesh(bytes, { limits: { maxVertices: undefined } })).info.faces, 8);
});

test('after a mesh that failed the library still works', async () => {
  await assert.rejects(gvd.mesh(new Uint8Array(100)));
  await assert.rejects(gvd.mesh({ positions: [], indices: [] }));
  assert.equal((await gvd.mesh(apart(octahedron(), grid(2)))).info.components, 2);
});

test('sampled sites depend on the seed alone, and the first ones not on the count', async () => {
  const mesh = await gvd.mesh(octahedron());
  const ten = await mesh.sampleSites(10, { seed: 5 });
  const four = await mesh.sampleSites(4, { seed: 5 });
  assert.equal(ten.face.length, 10);
  assert.equal(ten.bary.length, 30);
  assert.deepEqual(ten.face.slice(0, 4), four.face);
  assert.deepEqual(ten.bary.slice(0, 12), four.bary);
  assert.notDeepEqual(await mesh.sampleSites(10, { seed: 6 }), ten);
  assert.deepEqual(await mesh.sampleSites(3), await mesh.sampleSites(3, { seed: 1 }));
  assert.notDeepEqual(
    await mesh.sampleSites(3, { seed: 2 ** 40 }),
    await mesh.sampleSites(3, { seed: 2 ** 41 }),
  );
});

test('objects have tags, by which Vue tells them from plain ones and puts no proxy before them', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 1] });
  assert.deepEqual(
    [gvd, mesh, diagram].map((object) => `${object}`),
    ['[object GeodesicVoronoi]', '[object Mesh]', '[object Diagram]'],
  );
});

test('where points are: by triangles, vertices and places, and of labels without a site', async () => {
  const mesh = await gvd.mesh(octahedron());
  const places = await mesh.sampleSites(20);
  const positions = await mesh.positionsOf(places);
  const back = await mesh.closestPoints(positions);
  assert.ok(Math.max(...back.distance) < 1e-15);
  assert.deepEqual(await mesh.positionsOf({ vertex: [1, 0] }), Float64Array.of(0, 1, 0, 1, 0, 0));
  assert.deepEqual(await mesh.positionsOf({ position: [2, 0, 0] }), Float64Array.of(1, 0, 0));
  assert.deepEqual(
    await mesh.positionsOf({ face: [-1, 0], bary: [0, 0, 0, 1, 0, 0] }),
    Float64Array.of(NaN, NaN, NaN, ...mesh.positions.slice(3 * mesh.indices[0]).slice(0, 3)),
  );
  for (const face of [8, -2]) {
    await assert.rejects(
      mesh.positionsOf({ face, bary: [1, 0, 0] }),
      fails('invalid-point', new RegExp(`^point 0: there is no triangle ${face}$`)),
    );
  }
  for (const bary of [
    [NaN, 0, 1],
    [2, -1, 0],
    [0.5, 0.5, 0.5],
  ]) {
    await assert.rejects(
      mesh.positionsOf({ face: [-1, 0], bary: [0, 0, 0, ...bary] }),
      fails('invalid-point', /^point 1: .*barycentric coordinate/),
    );
  }
});

test('random sites spread as a tessellation with a density does', async () => {
  const mesh = await gvd.mesh(octahedron()); // its vertex 0 is at x = 1
  const meanX = async (options) => {
    const positions = await mesh.positionsOf(await mesh.sampleSites(2000, options));
    return positions.reduce((sum, x, i) => sum + (i % 3 === 0 ? x : 0), 0) / 2000;
  };
  const onOneSide = [1, 0, 0, 0, 0, 0];
  near(await meanX({}), 0, 0.05);
  // The root falls linearly from the vertex, where four triangles meet: the mean of x is 1/2.
  near(await meanX({ density: onOneSide }), 0.5, 0.03);
  for (const options of [
    { density: onOneSide, sampling: 'poisson' },
    { density: [1, 2] },
    { density: 'attribute' },
    { density: [-1, 0, 0, 0, 0, 0] },
  ]) {
    await assert.rejects(mesh.sampleSites(3, options), fails('invalid-argument', /densit/));
  }
});

test('there may be more sites than vertices', async () => {
  const mesh = await gvd.mesh(octahedron());
  assert.equal((await mesh.sampleSites(100)).face.length, 100);
});

test('every component gets sites if they are asked for, and what has none is told', async () => {
  const crumbs = { ...grid(1), positions: grid(1).positions.map((x) => x / 100) };
  const source = [0, 1, 2].reduce((all) => apart(crumbs, all), grid(4));
  const mesh = await gvd.mesh(source);
  assert.equal(mesh.info.components, 4);
  for (const sampling of ['random', 'farthest', 'poisson', 'size', 'distortion']) {
    const sites = await mesh.sampleSites(20, { sampling, perComponent: 2 });
    assert.equal(sites.face.length, 20, sampling);
    const onCrumbs = [0, 2, 4].map(
      (first) => sites.face.filter((f) => f === first || f === first + 1).length,
    );
    assert.ok(Math.min(...onCrumbs) >= 2, `${sampling}: ${onCrumbs}`);
    const bare = await mesh.bareComponents(sites);
    assert.deepEqual(bare, { components: 0, area: 0 });
  }
  const bare = await mesh.bareComponents({ face: [2], bary: [1, 0, 0] });
  assert.equal(bare.components, 3);
  near(bare.area, 1.0002, 1e-9);
  await assert.rejects(
    mesh.sampleSites(7, { perComponent: 2 }),
    fails(
      'invalid-argument',
      /2 per component, of which the mesh has 4, makes 8 sites, more than the 7 in all/,
    ),
  );
});

test('a radius in place of a number: as many sites as it takes', async () => {
  const mesh = await gvd.mesh(grid(20));
  for (const sampling of [undefined, 'farthest', 'poisson']) {
    const counts = [];
    for (const radius of [0.5, 0.2, 0.1]) {
      const sites = await mesh.sampleSites({ radius }, { sampling });
      const { distance } = await mesh.distances(sites);
      assert.ok(Math.max(...distance) <= radius * (1 + 1e-9), `${sampling} ${radius}`);
      counts.push(sites.face.length);
    }
    assert.ok(counts[0] < counts[1] && counts[1] < counts[2], String(counts));
  }
  const farther = await mesh.sampleSites({ radius: 99 }, { perComponent: 3 });
  assert.equal(farther.face.length, 3);
  for (const sampling of ['random', 'size', 'distortion'])
    await assert.rejects(
      mesh.sampleSites({ radius: 1 }, { sampling }),
      fails('invalid-argument', /radius|sampling/),
    );
});

test('a site for the worst region, always', async () => {
  const mesh = await gvd.mesh(apart(grid(6), octahedron()));
  const largest = async (sites) => Math.max(...(await mesh.voronoi(sites)).data.regionArea);
  const bySize = await mesh.sampleSites(24, { sampling: 'size' });
  assert.ok((await largest(bySize)) < (await largest(await mesh.sampleSites(24))));
  const onOctahedron = ({ face }) => face.filter((f) => f >= 72).length;
  const byDistortion = await mesh.sampleSites(24, { sampling: 'distortion' });
  assert.equal(onOctahedron(byDistortion), 23, 'the square is flat');
  const few = await mesh.sampleSites(5, { sampling: 'distortion' });
  assert.deepEqual(few.face, byDistortion.face.slice(0, 5));
  const diagram = await mesh.voronoi({ vertex: [0] });
  const next = await diagram.worstRegionPoint('size');
  assert.ok(next.face[0] >= 72, 'a component without a site');
});

test('a density that follows curvature', async () => {
  const mesh = await gvd.mesh(apart(grid(4), octahedron()));
  const density = await mesh.curvatureDensity();
  assert.equal(density.length, 31);
  assert.ok(density.subarray(0, 25).every((value) => value < density[25]));
  const sites = await mesh.sampleSites(20, { perComponent: 5 });
  const last = async (options) => {
    let state;
    for await (state of mesh.cvt(sites, { iterations: 2, ...options }));
    return state.sites;
  };
  assert.deepEqual(await last({ density: 'curvature' }), await last({ density }));
  assert.notDeepEqual(await last({ density }), await last({}));
});

test('a density that the mesh came with, of arrays, a glTF or a PLY', async () => {
  const shape = grid(2);
  const density = [1, 2, 3, 4, 5, 6, 7, 8, 0.5];
  const { json, buffer } = gltf(shape, { uri: 'a.bin' });
  const values = Buffer.from(Float32Array.from(density).buffer);
  json.bufferViews.push({ buffer: 1, byteLength: values.length });
  json.buffers.push({ byteLength: values.length, uri: 'b.bin' });
  json.accessors.push({ bufferView: 2, componentType: 5126, count: 9, type: 'SCALAR' });
  json.meshes[0].primitives[0].attributes._DENSITY = 2;
  const ply = new TextDecoder()
    .decode(meshPly(shape, 'ascii'))
    .replace('uchar red', 'float density')
    .split('\n');
  const first = ply.indexOf('end_header') + 1;
  density.forEach((value, i) => {
    ply[first + i] = ply[first + i].replace(/255$/, String(value));
  });
  const sources = [
    { ...shape, density },
    {
      'a.gltf': new TextEncoder().encode(JSON.stringify(json)),
      'a.bin': new Uint8Array(buffer),
      'b.bin': new Uint8Array(values),
    },
    new TextEncoder().encode(ply.join('\n')),
  ];
  for (const source of sources) {
    const mesh = await gvd.mesh(source);
    assert.deepEqual([...mesh.density], density);
    const energies = [];
    for (const given of ['attribute', density, undefined]) {
      const states = mesh.cvt({ vertex: [0, 8] }, { density: given, iterations: 1 });
      energies.push((await states.next()).value.energy);
    }
    assert.equal(energies[0], energies[1]);
    assert.notEqual(energies[0], energies[2]);
  }
  const bare = await gvd.mesh(shape);
  assert.equal(bare.density.length, 0);
  await assert.rejects(
    bare.cvt({ vertex: [0] }, { density: 'attribute' }).next(),
    fails('invalid-argument', /came without a density: a glTF has it as .* _DENSITY, a PLY as /),
  );
  await assert.rejects(
    gvd.mesh({ ...shape, density: [1] }),
    fails('invalid-argument', /density has 1 number, not 9/),
  );
});

test('what does not fit into memory says so, and the library still works', async () => {
  const mesh = await gvd.mesh(octahedron());
  await assert.rejects(mesh.sampleSites(2 ** 31 - 1), fails('out-of-memory', /memory/));
  assert.equal((await mesh.sampleSites(2)).face.length, 2);
});

/** The least distance of a place from the triangles, by samples of each, and how much more it may be. */
function sampledDistance({ positions, indices }, place, steps = 24) {
  let least = Infinity;
  for (let t = 0; t < indices.length; t += 3) {
    const corners = [0, 1, 2].map((i) =>
      positions.slice(3 * indices[t + i], 3 * indices[t + i] + 3),
    );
    for (let i = 0; i <= steps; ++i) {
      for (let j = 0; i + j <= steps; ++j) {
        const weights = [i, j, steps - i - j];
        const distance = Math.hypot(
          ...place.map(
            (x, k) => x - corners.reduce((sum, c, n) => sum + (weights[n] * c[k]) / steps, 0),
          ),
        );
        least = Math.min(least, distance);
      }
    }
  }
  return least;
}

test('closest points: as near as the triangles are, and on the surface', async () => {
  for (const input of [octahedron(), apart(octahedron(), grid(3)), withFlipped(grid(4), 5)]) {
    const mesh = await gvd.mesh(input);
    // Of a quick generator, the same every time.
    let state = 7;
    const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
    const places = Array.from({ length: 60 }, () => 4 * random() - 2);
    const { face, bary, position, distance } = await mesh.closestPoints(places);
    assert.equal(face.length, 20);
    for (let i = 0; i < face.length; ++i) {
      const place = places.slice(3 * i, 3 * i + 3);
      const found = [...position.subarray(3 * i, 3 * i + 3)];
      const named = placeOf(mesh, face[i], bary.subarray(3 * i));
      named.forEach((x, k) => near(x, found[k], 1e-12));
      near(Math.hypot(...place.map((x, k) => x - found[k])), distance[i], 1e-12);
      const sampled = sampledDistance(input, place);
      assert.ok(distance[i] <= sampled + 1e-12 && distance[i] > sampled - 0.06, `${sampled}`);
    }
  }
});

test('closest points are sites; of a vertex, that vertex', async () => {
  const mesh = await gvd.mesh(octahedron());
  const sites = await mesh.closestPoints([1, 0, 0, -3, 0, 0]);
  assert.deepEqual([...sites.distance], [0, 2]);
  assert.deepEqual([...sites.position], [1, 0, 0, -1, 0, 0]);
  const diagram = await mesh.voronoi(sites);
  assert.equal(diagram.regions.length, 2);
  assert.deepEqual((await mesh.closestPoints([])).distance, new Float64Array());
  mesh.dispose();
  assert.equal((await diagram.locate({ vertex: [0] })).distance[0], 0);
});

test('points by faces, vertices or places; one point without a list', async () => {
  const mesh = await gvd.mesh(octahedron());
  const [first] = mesh.indices;
  const corner = [0, 1, 2].map((k) => mesh.positions[3 * first + k]);
  const expected = (await mesh.voronoi({ vertex: [first] })).data.regionArea;
  for (const site of [
    { vertex: first },
    { face: 0, bary: [1, 0, 0] },
    { face: [0], bary: [1, 0, 0] },
    { position: corner },
    { position: corner.map((x) => 3 * x) },
    await mesh.closestPoints(corner),
  ]) {
    const diagram = await mesh.voronoi(site);
    assert.deepEqual(diagram.data.regionArea, expected);
    await diagram.insertSite({ position: corner.map((x) => -x) });
    await diagram.moveSite(0, site);
    assert.equal(diagram.regions.length, 2);
    assert.equal((await diagram.locate(site)).label[0], 0);
    assert.equal((await mesh.path(site, { vertex: first })).length, 0);
  }
  await assert.rejects(
    mesh.voronoi({ position: [0, 1] }),
    fails('invalid-argument', /sites.position has 2 numbers, not three/),
  );
  await assert.rejects(
    mesh.voronoi({ face: 0, bary: [1, 0, 0, 1, 0, 0] }),
    fails('invalid-argument', /sites.bary has 6 numbers, not 3: /),
  );
});

test('closest points: what is no place', async () => {
  const mesh = await gvd.mesh(octahedron());
  await assert.rejects(
    mesh.closestPoints([1, 2]),
    fails('invalid-argument', /2 numbers, not three/),
  );
  await assert.rejects(
    mesh.closestPoints([0, NaN, 0]),
    fails('invalid-argument', /^positions\[1\]/),
  );
  await assert.rejects(
    mesh.closestPoints([0, 0, 0, 0, 0, 1e300]),
    fails('invalid-point', /^position 1: /),
  );
});
