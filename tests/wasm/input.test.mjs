// SPDX-License-Identifier: MIT
//
// Models of every format: the same mesh gives the same diagram, whatever its file, and a file that is
// broken is refused in a sentence.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { zipSync } from 'fflate';
import { findModel, gltfResourceUris, listModels, load } from 'geodesic-voronoi';
import { decompressed } from '../../dist/input/gltf_decompression.js';
import { parseGltf } from '../../dist/input/gltf_document.js';
import { total } from './files.mjs';
import { bumpySphere, glb, glbOf, gltf, octahedron } from './meshes.mjs';
import {
  dracoGlb,
  dracoModels,
  dragon,
  meshBinaryStl,
  meshObj,
  meshOff,
  meshoptGlb,
  meshPly,
  meshTextStl,
  packageModels,
} from './model_files.mjs';
import { fails, near } from './expectations.mjs';

const bytesOf = (text) => new TextEncoder().encode(text);

const gvd = await load();

/** The regions of a few sites make up the surface. */
async function assertDivided(mesh, what, sites = { face: [0], bary: [1 / 3, 1 / 3, 1 / 3] }) {
  const diagram = await mesh.voronoi(sites ?? (await mesh.sampleSites(5)));
  const { regionArea, faceLabel } = diagram.data;
  const isReached = faceLabel.every((label) => label !== -1);
  const share = total([...regionArea]) / mesh.info.area;
  if (isReached) near(share, 1, 1e-9, what);
  else assert.ok(share < 1 + 1e-9, `${what}: ${share}`);
  return diagram;
}

test('the same mesh gives the same diagram from every format', async () => {
  const { positions, indices } = bumpySphere(9, 14);
  // Numbers of 32 bits, which is what most formats have.
  const sphere = { positions: positions.map(Math.fround), indices };
  const textPly = meshPly(sphere, 'ascii');
  const files = [
    ['arrays', sphere],
    ['glTF', glb(sphere)],
    ['glTF', await meshoptGlb(sphere, 'EXT_meshopt_compression')],
    ['glTF', await meshoptGlb(sphere, 'KHR_meshopt_compression')],
    ['OBJ', meshObj(sphere)],
    ['OFF', meshOff(sphere)],
    ['PLY', textPly],
    ['PLY', meshPly(sphere, 'binary_little_endian')],
    ['PLY', meshPly(sphere, 'binary_big_endian')],
    ['STL', meshTextStl(sphere)],
    ['STL', meshBinaryStl(sphere)],
    ['PLY', zipSync({ 'sphere/sphere.ply': textPly, 'sphere/read me.txt': bytesOf('…') })],
  ];
  const sites = { face: [0, 30, 100, 200], bary: [1, 1, 1, 1].flatMap(() => [0.5, 0.3, 0.2]) };
  const expected = await (await gvd.mesh(sphere)).voronoi(sites);
  for (const [i, [format, file]] of files.entries()) {
    const name = `file ${i}, ${format}`;
    const mesh = await gvd.mesh(file);
    assert.equal(mesh.info.origin.format, format, name);
    assert.equal(mesh.info.eulerCharacteristic, 2, name);
    const { data } = await assertDivided(mesh, name, sites);
    assert.deepEqual([...data.faceLabel], [...expected.data.faceLabel], name);
    data.regionArea.forEach((area, i) => {
      near(area / expected.data.regionArea[i], 1, 1e-12, name);
    });
  }
  // Draco rounds to 2^-16 of the size, and lets each face begin at any of its corners.
  const mesh = await gvd.mesh(await dracoGlb(sphere));
  assert.deepEqual([mesh.info.inputFaces, mesh.info.eulerCharacteristic], [indices.length / 3, 2]);
  const centres = { face: sites.face, bary: Array(12).fill(1 / 3) };
  const { data } = await assertDivided(mesh, 'Draco', centres);
  const { data: exact } = await (await gvd.mesh(sphere)).voronoi(centres);
  data.regionArea.forEach((area, i) => {
    near(area / exact.regionArea[i], 1, 1e-3, 'Draco');
  });
});

test('reading is sliced in every format: it tells how far it is, and can be given up', async ({
  mock,
}) => {
  // A clock that is always later than the end of a slice: how fast the machine is must not matter.
  let clock = 0;
  mock.method(performance, 'now', () => (clock += 1000));
  const sphere = bumpySphere(40, 60);
  const files = {
    OBJ: meshObj(sphere),
    OFF: meshOff(sphere),
    'text PLY': meshPly(sphere, 'ascii'),
    PLY: meshPly(sphere, 'binary_little_endian'),
    'text STL': meshTextStl(sphere),
    STL: meshBinaryStl(sphere),
    zip: zipSync({ 'a.obj': meshObj(sphere) }),
  };
  for (const [name, file] of Object.entries(files)) {
    const control = new AbortController();
    const shares = [];
    const given = gvd.mesh(file, {
      signal: control.signal,
      onProgress: (share) => {
        shares.push(share);
        control.abort(new Error('enough'));
      },
    });
    await assert.rejects(given, { message: 'enough' }, name);
    assert.ok(shares.length === 1 && shares[0] >= 0 && shares[0] < 1, `${name}: ${shares}`);
  }
});

test('unpacking a zip is sliced, and can be given up', async ({ mock }) => {
  for (const level of [0, 6]) {
    const zip = zipSync({ 'a.ply': [meshPly(bumpySphere(40, 60), 'ascii'), { level }] });
    const control = new AbortController();
    let clock = 0;
    const { mock: now } = mock.method(performance, 'now', () => {
      control.abort(new Error('enough'));
      return (clock += 1000); // every step is a slice
    });
    await assert.rejects(findModel(zip, { signal: control.signal }), { message: 'enough' });
    now.restore();
  }
});

test('decompression can be given up', async ({ mock }) => {
  const many = (json) => {
    const [mesh] = json.meshes;
    mesh.primitives = Array.from({ length: 50 }, () => structuredClone(mesh.primitives[0]));
  };
  const file = await dracoGlb(octahedron(), many);
  await gvd.mesh(file); // now the modules are there
  const control = new AbortController();
  let clock = 0;
  let steps = 0;
  mock.method(performance, 'now', () => {
    if (++steps === 10) control.abort(new Error('enough'));
    return (clock += 1000); // every step is a slice
  });
  await assert.rejects(gvd.mesh(file, { signal: control.signal }), { message: 'enough' });
  assert.ok(steps < 15, `${steps} steps: primitives were decompressed that nobody wants`);
});

/** Each had an instance of the decoder, which took milliseconds and megabytes. */
test('all primitives of a file are decompressed by one decoder', async ({ mock }) => {
  const instantiate = mock.method(WebAssembly, 'instantiate');
  const instancesFor = async (length) => {
    const file = await dracoGlb(octahedron(), ({ meshes: [mesh] }) => {
      mesh.primitives = Array.from({ length }, () => structuredClone(mesh.primitives[0]));
    });
    instantiate.mock.resetCalls();
    assert.equal((await gvd.mesh(file)).info.inputFaces, 8 * length);
    return instantiate.mock.callCount();
  };
  assert.equal(await instancesFor(50), await instancesFor(1));
});

test('compressed buffers are decoded in slices', async ({ mock }) => {
  let clock = 0;
  mock.method(performance, 'now', () => (clock += 1000)); // every step is a slice
  const turnsFor = async (copies) => {
    const file = await meshoptGlb(octahedron(), undefined, ({ bufferViews }) => {
      const [view] = bufferViews;
      for (let i = 0; i < copies; ++i) bufferViews.push(structuredClone(view));
    });
    let turns = 0;
    let turn = setImmediate(function next() {
      ++turns;
      turn = setImmediate(next);
    });
    await gvd.mesh(file);
    clearImmediate(turn);
    return turns;
  };
  await turnsFor(0); // loads what decodes
  assert.ok((await turnsFor(100)) > (await turnsFor(0)) + 50);
});

/** It was decoded for every primitive: two minutes for 200 of them in a buffer of 5 MB. */
test('the data URI of a buffer is decoded once', async (t) => {
  let text;
  await dracoGlb(octahedron(), (json, buffer) => {
    const [mesh] = json.meshes;
    mesh.primitives = [0, 1, 2].map(() => structuredClone(mesh.primitives[0]));
    json.buffers[0].uri = `data:;base64,${Buffer.from(buffer).toString('base64')}`;
    text = JSON.stringify(json);
  });
  const { atob } = globalThis;
  t.after(() => (globalThis.atob = atob));
  let decoded = 0;
  globalThis.atob = (digits) => {
    ++decoded;
    return atob(digits);
  };
  assert.equal((await gvd.mesh(bytesOf(text))).info.inputFaces, 24);
  assert.equal(decoded, 1);
  // Nor does what reads the file after it is decompressed.
  const compile = () =>
    WebAssembly.compile(readFileSync(new URL('../../dist/draco.wasm', import.meta.url)));
  const { bytes } = await decompressed(parseGltf(bytesOf(text)), new Map(), compile, {});
  assert.doesNotMatch(new TextDecoder().decode(bytes), /data:/);
});

test('words of a text are whole, wherever it is taken apart', async () => {
  // Longer than what is decoded at a time: a byte more in front puts the cuts into other words.
  const { positions, indices } = bumpySphere(40, 60);
  const expected = meshObj({ positions, indices });
  for (let shift = 0; shift < 24; ++shift) {
    const front = `#${'ä'.repeat(shift % 12)}${' '.repeat(shift)}\r\n`;
    const continued = new TextDecoder().decode(expected).replaceAll('f ', 'f \\\n');
    const mesh = await gvd.mesh({ 'a.obj': bytesOf(front + continued) });
    assert.deepEqual([...mesh.indices], [...indices], `shifted by ${shift}`);
    assert.deepEqual([...mesh.positions], [...positions], `shifted by ${shift}`);
    mesh.dispose();
  }
  const returns = new TextDecoder().decode(expected).replaceAll('\n', '\r');
  assert.deepEqual([...(await gvd.mesh(bytesOf(returns))).indices], [...indices]);
});

test('of several models, one can be named', async () => {
  const parts = { 'a/one.obj': meshObj(octahedron()), 'two.stl': meshBinaryStl(bumpySphere(5, 6)) };
  const open = async (source, file) => (await gvd.mesh(source, { file })).info.origin.file;
  for (const source of [
    parts,
    zipSync(parts),
    { 'parts.zip': zipSync(parts), 'b.ply': bytesOf('') },
  ]) {
    for (const name of Object.keys(parts)) assert.equal(await open(source, name), name);
    await assert.rejects(
      open(source, 'one.obj'),
      fails('invalid-file', /there is no one\.obj in /),
    );
  }
  await assert.rejects(
    open(zipSync(parts)),
    fails('several-models', /a\/one\.obj and two\.stl are several models: choose one/),
  );
  await assert.rejects(open(parts['a/one.obj'], 'x'), fails('invalid-file', /there is no x/));
  await assert.rejects(open(parts, 5), fails('invalid-argument', /^file is 5/));
});

test('JSON that is large takes no more memory than it should', async () => {
  const many = (text, count) => `[${`${text},`.repeat(count)}${text}]`;
  for (const member of ['nodes', 'buffers', 'extensionsUsed']) {
    const list = many('{}', 2 ** 19);
    const json = `{"asset":{"version":"2.0"},"${member}":${list}}`;
    await assert.rejects(gvd.mesh(bytesOf(json)), fails('invalid-gltf', /objects|no triangles/));
  }
  const used = `{"extensionsUsed":["KHR_draco_mesh_compression"],"nodes":${many('[]', 2 ** 22)}}`;
  await assert.rejects(
    gvd.mesh(bytesOf(used)),
    fails('invalid-gltf', /compressed.*more than 4,194,304 lists/),
  );
});

test('models of packages: Draco, every controller, the dragon', async () => {
  const models = [...dracoModels(), dragon(), ...packageModels('@webxr-input-profiles/assets')];
  assert.ok(models.length > 60, `${models.length} models`);
  for (const { name, bytes } of models) {
    const mesh = await gvd.mesh(bytes);
    await assertDivided(mesh, name, null);
    mesh.dispose();
  }
});

test('polygons are cut into triangles, also those that are no fans, and named', async () => {
  // An L, a square with a corner in the middle of a side, and a triangle, by either way of counting.
  const obj = `v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0
f 4 5 6 1 2 3
v 4 0 0\nv 5 0 0\nv 6 0 0\nv 6 2 0\nv 4 2 0
f -5/1 -4/1/1 -3//1 -2 \\\n-1
v 8 0 0\nv 9 0 0\nv 8 1 0
f 12 13 14
l 1 2`;
  const mesh = await gvd.mesh(bytesOf(obj));
  assert.equal(mesh.info.faces, 4 + 3 + 1);
  assert.equal(mesh.info.repairs.isolatedVertices, 0);
  near(mesh.info.area, 7.5, 1e-12);
  assert.deepEqual(mesh.info.notes, [
    '2 polygons were cut into triangles',
    '1 line or point was passed over',
  ]);
  const partition = await (
    await mesh.voronoi({ face: [0, 4, 7], bary: Array(9).fill(1 / 3) })
  ).partition();
  assert.deepEqual(
    [...partition.regions.area].map((x) => x.toFixed(9)),
    ['3.000000000', '4.000000000', '0.500000000'],
  );
});

test('polygons with corners in a line keep their area, and none of their triangles is flat', async () => {
  const slantedU = [
    ...[
      [1, 1.5],
      [1, 2],
      [0.5, 2],
      [0, 2],
      [0, 0],
      [1, 0],
      [2, 0],
      [3, 0],
      [3, 2],
      [2, 2],
    ],
    ...[
      [2, 5 / 3],
      [2, 4 / 3],
      [2, 1],
      [1, 1],
    ],
  ].map(([x, y]) => [0.6 * y - 0.1 * x, 0.2 * y - 0.3 * x, 0.3 * y + 0.1 * x]);
  const slantedTrapezium = [
    [-1.2, 3.4, 0],
    [-1.8, 2.6, 0],
    [-2.4, 1.8, 0],
    [0, 0, 0],
    [1.2, 1.6, 0],
  ];
  for (const [polygon, area] of [
    [slantedU, 5 * Math.hypot(0.11, 0.09, 0.16)],
    [slantedTrapezium, 6],
  ]) {
    const lines = polygon.map((corner) => `v ${corner.join(' ')}`);
    const { info } = await gvd.mesh(
      bytesOf(`${lines.join('\n')}\nf ${polygon.map((_, i) => i + 1).join(' ')}`),
    );
    assert.equal(info.faces, polygon.length - 2);
    near(info.area, area, 1e-12);
    assert.equal(info.repairs.mollifiedTriangles, 0);
  }
});

test('comments end any line of an OBJ and an OFF', async () => {
  const obj = `# three\nv 0 0 0 # a\nv 1 0 0#b\nv 0 1 0 #\n  # four
f 1 2 3 # comment\nf 1 2 3 4 #c\nf 1 2# a line\n#f 1 2 3\nl 1 2 # too\nv 1 1 0\nf 2 4 3#c`;
  const off = `OFF # by hand\n# counts\n4 2 0 # each\n0 0 0#a\n1 0 0 # b\n 0 1 0\n#\n1 1 0
3 0 1 2 # first\n3 1 3 2#second`;
  for (const [text, faces] of [
    [obj, 4],
    [off, 2],
  ]) {
    const { info } = await gvd.mesh(bytesOf(text));
    assert.equal(info.inputFaces, faces);
    assert.equal(info.inputVertices, 4);
  }
  await assert.rejects(
    gvd.mesh(bytesOf('v 0 0 # 0\nf 1 1 1')),
    fails('invalid-file', /line 1: a number is missing after 'v 0 0/),
  );
});

test('the mark of UTF-8 before a text does not matter', async () => {
  const shape = octahedron();
  const { json, buffer } = gltf(shape);
  json.buffers[0].uri = `data:;base64,${buffer.toString('base64')}`;
  const texts = {
    glTF: JSON.stringify(json),
    OBJ: meshObj(shape),
    OFF: meshOff(shape),
    PLY: meshPly(shape, 'ascii'),
    STL: meshTextStl(shape),
  };
  for (const [format, text] of Object.entries(texts)) {
    const { info } = await gvd.mesh(Buffer.concat([bytesOf('\ufeff'), Buffer.from(text)]));
    assert.equal(info.origin.format, format);
    assert.equal(info.inputFaces, 8);
  }
});

test('PLY: triangle strips, old names of types, and elements that do not matter', async () => {
  const ply = `ply\r\nformat ascii 1.0\r\nelement range 2\r\nproperty list uchar char other
element vertex 5\nproperty float32 z\nproperty float x\nproperty float y
element tristrips 1\nproperty list int int vertex_indices\nend_header
2 1 2\n1 7\n0 0 0\n0 1 0\n0 0 1\n0 1 1\n0 0 2
9 0 1 2 3 -1 2 3 4 -1`;
  const mesh = await gvd.mesh(bytesOf(ply));
  assert.deepEqual([...mesh.indices], [0, 1, 2, 1, 3, 2, 2, 3, 4]);
  assert.deepEqual([...mesh.positions.slice(3, 6)], [1, 0, 0]);
});

test('files come in any order, by paths that are percent-encoded or not', async () => {
  const { json, buffer } = gltf(octahedron(), { uri: '../data/its%20buffer.bin' });
  const files = {
    'data/its buffer.bin': new Blob([buffer]),
    'models/.hidden.glb': bytesOf('no model'),
    '__MACOSX/models/scene.gltf': bytesOf('no model'),
    'models/scene.gltf': bytesOf(JSON.stringify(json)),
  };
  for (const source of [files, Object.fromEntries(Object.entries(files).reverse())]) {
    const { info } = await gvd.mesh(source);
    assert.deepEqual([info.faces, info.origin], [8, { format: 'glTF', file: 'models/scene.gltf' }]);
  }
  // Files that were chosen one by one have lost their folders.
  const flat = {
    'its buffer.bin': buffer,
    'scene.gltf': bytesOf(
      JSON.stringify({ ...json, buffers: [{ ...json.buffers[0], uri: 'data/its%20buffer.bin' }] }),
    ),
  };
  assert.equal((await gvd.mesh(flat)).info.faces, 8);
  assert.equal((await gvd.mesh(new Blob([glb(octahedron())]))).info.faces, 8);

  const scene = bytesOf(JSON.stringify(json));
  const without = { 'models/scene.gltf': scene, 'data/Its Buffer.bin': buffer };
  await assert.rejects(
    gvd.mesh(without),
    fails('invalid-gltf', /needs the file.*buffer\.bin.*missing/),
  );
  await assert.rejects(
    gvd.mesh({ 'scene.gltf': scene, 'x/y': buffer }),
    fails('invalid-gltf', /outside the model's folder/),
  );
  await assert.rejects(
    gvd.mesh({ 'a.glb': scene, 'b.obj': scene }),
    fails('several-models', /a\.glb and b\.obj are several models: choose one/),
  );
  await assert.rejects(
    gvd.mesh({ 'a.txt': scene, 'b.jpg': scene }),
    fails('invalid-file', /there is no model in a\.txt and b\.jpg/),
  );
  await assert.rejects(gvd.mesh({}), fails('invalid-file', /no files/));
  const unreadable = { arrayBuffer: () => Promise.reject(new Error('it has changed')) };
  await assert.rejects(
    gvd.mesh({ 'a.obj': unreadable }),
    fails('invalid-file', /a\.obj cannot be read: it has changed/),
  );
});

test('a file is found by any name, also by one that every object has', async () => {
  const { json, buffer } = gltf(octahedron(), { uri: '__proto__' });
  const files = Object.fromEntries([
    ['scene.gltf', bytesOf(JSON.stringify(json))],
    ['__proto__', buffer],
  ]);
  assert.equal((await gvd.mesh(files)).info.faces, 8);
});

test('bytes in shared memory are read, of which browsers decode no text', async (t) => {
  const { decode } = TextDecoder.prototype;
  t.after(() => (TextDecoder.prototype.decode = decode));
  TextDecoder.prototype.decode = function (bytes, ...rest) {
    assert.ok(!(bytes?.buffer instanceof SharedArrayBuffer));
    return decode.call(this, bytes, ...rest);
  };
  for (const bytes of [
    glb(octahedron()),
    meshObj(octahedron()),
    zipSync({ 'a.obj': meshObj(octahedron()) }),
  ]) {
    const shared = new Uint8Array(new SharedArrayBuffer(bytes.length));
    shared.set(bytes);
    assert.equal((await gvd.mesh(shared)).info.faces, 8);
  }
});

/** A small zip with thousands of such buffers was unpacked for each of them. */
test('a file of several buffers is read once', async () => {
  const { json, buffer } = gltf(octahedron(), { uri: 'shape.bin' });
  const [own] = json.buffers;
  json.buffers.push(own, { ...own, uri: './shape.bin' }, { ...own, uri: 'in/../shape.bin' });
  const uris = ['shape.bin', './shape.bin', 'in/../shape.bin'];
  assert.deepEqual(gltfResourceUris(bytesOf(JSON.stringify(json))), uris);
  let read = 0;
  const arrayBuffer = async () => {
    ++read;
    return Uint8Array.from(buffer).buffer;
  };
  const files = { 'shape.gltf': bytesOf(JSON.stringify(json)), 'shape.bin': { arrayBuffer } };
  assert.equal((await gvd.mesh(files)).info.faces, 8);
  assert.equal(read, 1);
});

test('a zip that is broken, or a bomb, is refused', async () => {
  const zip = zipSync({ 'a.obj': meshObj(octahedron()) });
  const stored = zipSync({ 'a.obj': [meshObj(octahedron()), { level: 0 }] });
  assert.equal((await gvd.mesh(stored)).info.faces, 8);
  assert.equal((await gvd.mesh(Buffer.from(stored))).info.faces, 8);
  const directory = Buffer.from(zip).indexOf('PK\x01\x02');
  const changed = (at, value) => {
    const copy = Uint8Array.from(zip);
    new DataView(copy.buffer).setUint32(at, value, true);
    return copy;
  };
  const { length } = meshObj(octahedron());
  const cut = Buffer.from(stored); // its content would end beyond it
  const entry = cut.indexOf('PK\x01\x02');
  for (const at of [20, 24]) cut.writeUInt32LE(2 ** 20, entry + at);
  for (const [bytes, message] of [
    [cut, /a\.obj cannot be unpacked/],
    [zip.subarray(0, zip.length - 10), /zip is truncated/],
    [changed(directory, 7), /zip is damaged/],
    [
      changed(directory + 24, 2 ** 31),
      /zip of 1 MB would unpack to 2048 MB, more than the 33 MB.*folder/,
    ],
    // What it says of a size does not matter in the end: it is stopped there.
    [changed(directory + 24, length - 1), /a\.obj cannot be unpacked/],
    [changed(directory + 24, length + 1), /a\.obj cannot be unpacked/],
    [changed(directory + 20, 10), /a\.obj cannot be unpacked/],
    [changed(directory + 42, 5), /a\.obj cannot be unpacked/],
    [changed(directory + 8, 0x0008_0001), /encrypted/],
    [changed(directory + 10, 12), /method 12/],
    [zipSync({}), /no files/],
    [zipSync({ 'a.zip': zip }), /a\.zip in the zip is a zip itself/],
  ]) {
    await assert.rejects(gvd.mesh(bytes), fails('invalid-file', message));
  }
});

test('compressed data that are damaged are refused', async () => {
  const view = (i) => (json) => json.bufferViews[i].extensions.EXT_meshopt_compression;
  const meshopt = (change) => meshoptGlb(octahedron(), undefined, change);
  for (const [file, message] of [
    [meshopt((json) => (view(0)(json).count = 5)), /accessor|count/],
    [meshopt((json) => (view(0)(json).count = 2 ** 40)), /more than 1024 MB/],
    [meshopt((json) => (view(0)(json).count = -1)), /the count of buffer view 0 is -1/],
    [meshopt((json) => (view(0)(json).byteStride = 10)), /byteStride 10/],
    [meshopt((json) => (view(0)(json).mode = 'toString')), /mode of buffer view 0 is "toString"/],
    [meshopt((json) => (view(1)(json).mode = 'ATTRIBUTES')), /damaged/],
    [meshopt((json) => (view(0)(json).filter = 'QUATERNION')), /byteStride 12/],
    [meshopt((json) => (view(0)(json).byteLength -= 9)), /damaged/],
    [meshopt((json) => (view(0)(json).byteLength = 10_000)), /should have 10,000 bytes/],
    [meshopt((json) => (view(0)(json).buffer = 7)), /number 7 of 2 buffers/],
    [dracoGlb(octahedron(), (json) => (json.bufferViews[0].byteLength -= 20)), /damaged/],
    [dracoGlb(octahedron(), (json) => (json.accessors[0].count = 7)), /POSITION.*7.*it has 6/],
    [dracoGlb(octahedron(), (json) => (json.accessors[1].count = 27)), /indices.*27.*it has 24/],
    [dracoGlb(octahedron(), (json) => (json.accessors[0].type = 'VEC2')), /damaged/],
    [
      dracoGlb(octahedron(), (json) => (json.accessors[0].componentType = 5130)),
      /componentType 5130/,
    ],
    [dracoGlb(octahedron(), (_, data) => data.fill(255, 11)), /damaged/],
    [
      dracoGlb(
        octahedron(),
        (json) =>
          (json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.attributes.POSITION = 9),
      ),
      /damaged/,
    ],
    [
      dracoGlb(
        octahedron(),
        (json) =>
          (json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.bufferView = 9),
      ),
      /number 9 of 1 bufferViews/,
    ],
  ]) {
    await assert.rejects(gvd.mesh(await file), fails('invalid-gltf', message));
  }
  assert.equal((await gvd.mesh(await meshopt())).info.faces, 8);
});

test('compressed data with any byte changed are read or refused', async () => {
  for (const file of [await meshoptGlb(octahedron()), await dracoGlb(octahedron())]) {
    const start = 28 + new DataView(file.buffer).getUint32(12, true);
    for (let at = start; at < file.length; ++at) {
      const changed = Uint8Array.from(file);
      changed[at] ^= 1 << (at % 8);
      await gvd
        .mesh(changed)
        .catch((error) => assert.equal(error.name, 'GeodesicVoronoiError', error.stack));
    }
  }
});

test('a model is given up while its files are read', async () => {
  const file = new File([meshObj(octahedron())], 'a.obj');
  const content = await file.arrayBuffer();
  for (const open of [(...given) => gvd.mesh(...given), findModel]) {
    const control = new AbortController();
    file.arrayBuffer = async () => {
      control.abort(new Error('enough'));
      return content;
    };
    await assert.rejects(open(file, { signal: control.signal }), { message: 'enough' });
  }
  const control = new AbortController();
  const mesh = gvd.mesh(octahedron(), { signal: control.signal });
  control.abort(new Error('enough'));
  await assert.rejects(mesh, { message: 'enough' });
});

test('findModel tells which file the model is, and what it means by a URI', async () => {
  const scene = bytesOf('{}');
  const files = { 'a/scene.gltf': scene, 'a/maps/red.png': bytesOf('red'), 'note.txt': scene };
  for (const given of [files, zipSync(files)]) {
    const { file, format, bytes, resource } = await findModel(given);
    assert.deepEqual([file, format, bytes], ['a/scene.gltf', 'glTF', scene]);
    assert.deepEqual(await resource('maps/red.png'), bytesOf('red'));
    assert.equal(await resource('maps/blue.png'), undefined);
  }
});

test('listModels tells all models, of which file names one', async () => {
  const obj = bytesOf('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const files = { 'b.obj': obj, 'a/b.OBJ': obj, 'note.txt': obj, '__MACOSX/a.obj': obj };
  for (const given of [files, zipSync(files), { 'all.zip': zipSync(files) }]) {
    const models = await listModels(given);
    assert.deepEqual(models, ['b.obj', 'a/b.OBJ']);
    for (const file of models)
      assert.equal((await gvd.mesh(given, { file })).info.origin.file, file);
  }
  assert.deepEqual(await listModels({ anything: obj }), ['anything']);
  // One beside an archive is meant, as everywhere.
  assert.deepEqual(await listModels({ 'b.obj': obj, 'all.zip': zipSync(files) }), ['b.obj']);
  await assert.rejects(
    listModels({ 'note.txt': obj, 'more.txt': obj }),
    /^GeodesicVoronoiError: there is no model in /,
  );
});

test('textures in any format do not matter, required or not', async () => {
  const { json, buffer } = gltf(octahedron());
  json.extensionsRequired = ['KHR_texture_basisu', 'EXT_texture_webp'];
  json.images = [{ uri: 'missing.ktx2' }];
  json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
  assert.equal((await gvd.mesh(glbOf(json, buffer))).info.faces, 8);
});

test('an OFF without the keyword, which may be missing, is known by its name', async () => {
  const text = '3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
  const mesh = await gvd.mesh({ 'plain.off': bytesOf(text) });
  assert.equal(mesh.info.area, 0.5);
  await assert.rejects(gvd.mesh({ 'plain.off': bytesOf('3\n') }), /line 1: a number is missing/);
});

test('a broken OBJ, OFF, PLY or STL says in which line or at which byte', async () => {
  const ply = (...lines) => ['ply', 'format ascii 1.0', ...lines].join('\n');
  const vertices = (n) => [
    `element vertex ${n}`,
    'property float x',
    'property float y',
    'property float z',
  ];
  const faces = (n) => [
    `element face ${n}`,
    'property list uchar int vertex_indices',
    'end_header',
  ];
  const binary = (text, ...bytes) => Uint8Array.from([...bytesOf(text), ...bytes]);
  const triangle = ['0 0 0', '1 0 0', '0 1 0'];
  for (const [file, message] of [
    ['v 0 0 0', /the OBJ has no faces/],
    ['v 0 0 0\nv 1 x 0', /^line 2: 'x' is no number/],
    ['v 0 0 0\nv 1 0x10 0', /^line 2: '0x10' is no number/],
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0x1 2 3', /^line 4: '0x1' names no vertex/],
    ['v 0 0 0\nv 1 0', /^line 2: a number is missing after 'v 1 0'/],
    ['v 0 0 0\nf 1 2 0', /^line 2: '0' names no vertex/],
    ['v 0 0 0\nf 1 1 -2', /^line 2: '-2' names no vertex/],
    ['v 0 0 0\nf 1 1/2 1.5', /^line 2: '1\.5' names no vertex/],
    [
      'v 0 0 0\n\n#\nf 1 1 4\nv 1 1 1',
      /^line 4: the face names vertex 4, but the number of vertices is 2/,
    ],
    ['OFF\n3 1 0\n0 0 0\n1 0 0', /^line 4: the OFF is truncated: it ends after 2 of 3 vertices/],
    ['OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n', /^line 5: a number is missing after '0 1'/],
    [
      'OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3',
      /^line 5: the face names vertex 3 \(from 0\), but the number/,
    ],
    ['OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1', /the OFF has no faces of three corners/],
    ['OFF\n3 x 0', /^line 2: 'x' is no number of vertices or faces/],
    ['OFF\n0x3 1 0', /^line 2: '0x3' is no number of vertices or faces/],
    ['OFF\n3', /^line 2: a number is missing after '3'/],
    ['OFF', /^line 1: the OFF is truncated: it ends after its keyword/],
    ['4OFF\n1 1 1', /^line 1: '4OFF' is a kind of OFF that is not read/],
    ['OFF BINARY\n\0\0\0\x03', /^line 1: binary OFF is not read: save it as text/],
    ['OFF\n999999999 1 0', /more than 16,777,216 vertices/],
    [ply(...vertices(1)), /header has no end/],
    [ply('element vertex -1', 'end_header\n'), /^line 3: '-1' is not a count/],
    [ply('property float x', 'end_header\n'), /^line 3: this property belongs to no element/],
    [
      ply('element vertex 1', 'property number x', 'end_header\n'),
      /^line 4: 'number' is not a type/,
    ],
    [ply('element vertex 1', 'property float x', 'end_header\n'), /no y/],
    ['ply\nend_header\n', /does not say its format/],
    ['ply\nformat utf8 1.0\nend_header\n', /^line 2: 'utf8' is not a format/],
    [ply(...vertices(3), ...faces(0), ...triangle), /the PLY has no faces/],
    [
      ply(
        ...vertices(1),
        ...Array(2).fill('property float density'),
        ...faces(1),
        '0 0 0 1 1 3 0 0 0',
      ),
      /the PLY has 2 densities for 1 vertex$/,
    ],
    [
      ply(...vertices(3), ...faces(1), ...triangle, '3 0 1 3'),
      /^line 13: a face names vertex 3 \(from 0\), but the number of vertices is 3/,
    ],
    [ply(...vertices(3), ...faces(1), ...triangle, '3 0 1 -1'), /^line 13: -1 is not a vertex/],
    [ply(...vertices(3), ...faces(2), ...triangle, '3 0 1 2'), /^line 13: the PLY is truncated/],
    [ply(...vertices(3), ...faces(1), ...triangle, '-3 0 1 2'), /^line 13: -3 is not the length/],
    [ply(...vertices(2 ** 39), ...faces(1), ''), /more than 16,777,216 vertices/],
    [
      binary(
        'ply\nformat binary_big_endian 1.0\nelement vertex 9\nproperty int x\nproperty int y\nproperty int z\nend_header\n',
        0,
        0,
      ),
      /truncated: it ends at byte \d+/,
    ],
    ['solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n', /^line 4: a number is missing/],
    ['solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n', /^line 4: the STL is truncated/],
    [
      'solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nendloop',
      /^line 5: a triangle with 1 corner ends here/,
    ],
    ['solid\nfacet\nvertex 0 0 0', /^line 3: this vertex is in no triangle/],
    ['solid\nfacet\nv 0 0 0', /^line 3: 'v 0 0 0' has no meaning/],
    ['solid a\nendsolid a', /the STL has no triangles/],
    ['solid facet outer loop vertex 0 0 0', /each statement needs a line of its own/],
  ]) {
    const bytes = typeof file === 'string' ? bytesOf(file) : file;
    await assert.rejects(gvd.mesh(bytes), fails('invalid-file', message), file);
  }
  const stl = meshBinaryStl(octahedron()).subarray(0, 300);
  for (const source of [stl, { 'a.stl': stl }])
    await assert.rejects(
      gvd.mesh(source),
      fails('invalid-file', /for 8 triangles it needs 484 bytes, but it has 300/),
    );
});

test('vertices and triangles are limited in every format, and the limits can be raised', async () => {
  const mesh = octahedron();
  const files = [
    meshObj(mesh),
    meshOff(mesh),
    meshPly(mesh, 'ascii'),
    meshBinaryStl(mesh),
    meshTextStl(mesh),
  ];
  for (const file of [glb(mesh), await dracoGlb(mesh), ...files]) {
    for (const limit of ['maxVertices', 'maxTriangles']) {
      await assert.rejects(gvd.mesh(file, { limits: { [limit]: 5 } }), {
        message: new RegExp(`more than 5 .*; raise the limit ${limit} to read it`),
      });
    }
    const limits = { maxVertices: 24, maxTriangles: 8 };
    assert.equal((await gvd.mesh(file, { limits })).info.faces, 8);
  }
});
