// SPDX-License-Identifier: MIT
//
// The layer of a file's own material: textures and vertex colours.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync, crc32 } from 'node:zlib';
import { gltf } from '../wasm/meshes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

/** A square in the plane z = 0, with texture coordinates that span it. */
const corners = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
];
const triangles = [0, 1, 2, 0, 2, 3];

/** A PNG of rows of colours. */
function png(rows) {
  const chunk = (type, data) => {
    const content = Buffer.concat([Buffer.from(type, 'latin1'), data]);
    const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc32(content));
    return Buffer.concat([length, content, sum]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(rows[0].length, 0);
  header.writeUInt32BE(rows.length, 4);
  header.set([8, 2, 0, 0, 0], 8); // eight bits per channel, red, green and blue
  const pixels = rows.map((row) => Buffer.from([0, ...row.flat()]));
  return Buffer.concat([
    Buffer.from([0x89, ...Buffer.from('PNG\r\n'), 0x1a, 0x0a]),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(Buffer.concat(pixels))),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

const red = [255, 0, 0];
const blue = [0, 0, 255];
/** Red on the left, blue on the right. */
const image = png([
  [red, blue],
  [red, blue],
]);

/**
 * The square as glTF; its image is a file beside it, or in its buffer. A morph target may shift it to
 * the right.
 */
function square({ imageFile, shift } = {}) {
  const positions = corners.flatMap(([x, y]) => [x, y, 0]);
  const uvs = Float32Array.from(corners.flatMap(([x, y]) => [(x + 1) / 2, (1 - y) / 2]));
  const { json, buffer } = gltf({ positions, indices: triangles }, { translation: [100, 0, 0] });
  let bytes = buffer;
  const addView = (content) => {
    const view = { buffer: 0, byteOffset: bytes.length, byteLength: content.length };
    bytes = Buffer.concat([bytes, content]);
    return json.bufferViews.push(view) - 1;
  };
  const view = addView(Buffer.from(uvs.buffer));
  json.accessors.push({ bufferView: view, componentType: 5126, count: 4, type: 'VEC2' });
  const [primitive] = json.meshes[0].primitives;
  Object.assign(primitive, { material: 0, attributes: { POSITION: 0, TEXCOORD_0: 2 } });
  if (shift) {
    const offset = [shift, 0, 0];
    const shifts = Float32Array.from(corners.flatMap(() => offset));
    const bounds = { type: 'VEC3', min: offset, max: offset };
    const target = {
      bufferView: addView(Buffer.from(shifts.buffer)),
      componentType: 5126,
      count: 4,
    };
    primitive.targets = [{ POSITION: json.accessors.push({ ...target, ...bounds }) - 1 }];
    json.meshes[0].weights = [1];
  }
  const source = imageFile
    ? { uri: imageFile }
    : { bufferView: addView(image), mimeType: 'image/png' };
  const uri = `data:application/octet-stream;base64,${bytes.toString('base64')}`;
  return JSON.stringify({
    ...json,
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0, sampler: 0 }],
    samplers: [{ magFilter: 9728, minFilter: 9728 }],
    images: [source],
    buffers: [{ byteLength: bytes.length, uri }],
  });
}

/** The square as PLY, with a colour at every vertex if there are any. */
function ply(colours) {
  const channels = colours ? ['red', 'green', 'blue'] : [];
  const vertices = corners.map(([x, y], i) => [x, y, 0, ...(colours?.[i] ?? [])].join(' '));
  const header = [
    'ply',
    'format ascii 1.0',
    'element vertex 4',
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    ...channels.map((channel) => `property uchar ${channel}`),
    'element face 2',
    'property list uchar int vertex_indices',
    'end_header',
  ];
  return [...header, ...vertices, '3 0 1 2', '3 0 2 3', ''].join('\n');
}

/** Opens files, shows only their own material, and returns what it is said to be. */
async function shown(viewer, files) {
  await viewer.set({ layers: ['regions'] });
  await viewer.after('load', () => viewer.choose(files));
  const { isFound, textures, problem } = await viewer.after('original', () =>
    viewer.set({ layers: ['original'] }),
  );
  assert.equal(problem, undefined);
  return { isFound, textures };
}

/**
 * How many pixels of the view are of a colour, at the left and at the right of its middle, and how many
 * red ones are further right than a blue one.
 */
async function countsOf(viewer) {
  const picture = await viewer.picture(['original']);
  return viewer.evaluate((viewer, picture) => {
    const { data, width } = viewer.pictures[picture];
    const counts = { red: [0, 0], blue: [0, 0], redBehindBlue: 0 };
    let isBehindBlue = false; // in the current row of pixels
    for (let i = 0; i < data.length; i += 4) {
      const x = (i / 4) % width;
      const side = x < width / 2 ? 0 : 1;
      if (x === 0) isBehindBlue = false;
      const [r, g, b, alpha] = data.subarray(i, i + 4);
      if (alpha === 255 && r > 120 && g < 40 && b < 40) {
        ++counts.red[side];
        if (isBehindBlue) ++counts.redBehindBlue;
      }
      if (alpha === 255 && b > 120 && r < 40 && g < 40) {
        ++counts.blue[side];
        isBehindBlue = true;
      }
    }
    return counts;
  }, picture);
}

/** Row by row: the colours do not meet in the middle of the view, since the nearer half is larger. */
function assertRedThenBlue({ red, blue, redBehindBlue }, what) {
  assert.ok(red[0] > 1000 && blue[1] > 1000, `${what}: ${red} and ${blue}`);
  assert.equal(redBehindBlue, 0, `${what}: ${red} and ${blue}`);
}

test('textures and vertex colours are shown where the file has them', async () => {
  // So wide that the model is in the middle of the view, not beside the toolbar.
  const viewer = await browser.open({ viewport: { width: 1100, height: 420 } });
  await viewer.evaluate((viewer) => viewer.setAttribute('sites', '2'));

  const inside = await shown(viewer, { 'inside.gltf': square() });
  assert.deepEqual(inside, { isFound: true, textures: 1 });
  assertRedThenBlue(await countsOf(viewer), 'a texture in the file');

  await shown(viewer, {
    'beside.gltf': square({ imageFile: 'colours.png' }),
    'colours.png': image,
  });
  assertRedThenBlue(await countsOf(viewer), 'a texture beside the file');

  await shown(viewer, { 'shifted.gltf': square({ shift: 3 }) });
  assertRedThenBlue(await countsOf(viewer), 'with a morph target');

  const [left, right] = [red, blue];
  const coloured = await shown(viewer, { 'own.ply': ply([left, right, right, left]) });
  assert.deepEqual(coloured, { isFound: true, textures: 0 });
  const counts = await countsOf(viewer);
  assert.ok(counts.red[0] > 100 && counts.blue[1] > 100, JSON.stringify(counts));

  const note = viewer.page.locator('#original-note');
  assert.equal(await note.isVisible(), false);
  assert.deepEqual(await shown(viewer, { 'bare.ply': ply() }), { isFound: false, textures: 0 });
  assert.match(await note.textContent(), /no colours to show: they are read from glTF and PLY/);
  assert.ok((await viewer.coverage(await viewer.picture(['original']))) > 0.05, 'it is neutral');

  await viewer.after('original', () => viewer.set({ layers: ['regions'] }));
  assert.equal(await note.isHidden(), true);
});

test('a picture that nobody waits for any more is not fetched to its end', async () => {
  const viewer = await browser.open();
  const { page } = viewer;
  await page.route('**/far.gltf', (route) =>
    route.fulfill({ body: square({ imageFile: 'never.png' }) }),
  );
  await page.route('**/never.png', () => {});
  await viewer.after('diagram', () => viewer.evaluate((viewer) => void viewer.load('far.gltf')));
  const asked = page.waitForRequest('**/never.png');
  await viewer.set({ layers: ['original'] });
  await asked;
  const ended = page.waitForEvent('requestfailed', { timeout: 5000 });
  await viewer.set({ layers: ['regions'] });
  assert.match((await ended).url(), /never\.png$/);
});

test('an unlit material is drawn like any other', async () => {
  const viewer = await browser.open();
  const { buffers, ...json } = JSON.parse(square());
  const normals = Float32Array.from(corners.flatMap(() => [0, 0, 1]));
  const uri = `data:;base64,${Buffer.from(normals.buffer).toString('base64')}`;
  const bufferView = json.bufferViews.push({ buffer: buffers.length, byteLength: 48 }) - 1;
  buffers.push({ byteLength: 48, uri });
  const accessor = { bufferView, componentType: 5126, count: 4, type: 'VEC3' };
  json.meshes[0].primitives[0].attributes.NORMAL = json.accessors.push(accessor) - 1;
  json.materials[0].extensions = { KHR_materials_unlit: {} };
  const unlit = JSON.stringify({ ...json, buffers, extensionsUsed: ['KHR_materials_unlit'] });
  const colours = await shown(viewer, { 'unlit.gltf': unlit });
  assert.deepEqual(colours, { isFound: true, textures: 1 });
});

test('pictures that are not drawn are not read', async () => {
  const viewer = await browser.open();
  const { textures, images, ...json } = JSON.parse(square());
  textures.push({ source: images.push({ uri: 'missing.png' }) - 1 });
  json.materials[0].normalTexture = { index: 1 };
  const bumpy = JSON.stringify({ ...json, textures, images });
  const messages = [];
  viewer.page.on('console', (message) => messages.push(message.text()));
  assert.deepEqual(await shown(viewer, { 'bumpy.gltf': bumpy }), { isFound: true, textures: 1 });
  assert.deepEqual(messages, []);
});

test('bisectors are seen on a surface of any colour', async () => {
  const viewer = await browser.open({
    viewport: { width: 1100, height: 420 },
    colorScheme: 'light',
  });
  await viewer.evaluate((viewer) => viewer.setAttribute('sites', '2'));
  const black = [4, 4, 4];
  await shown(viewer, { 'black.ply': ply([black, black, black, black]) });
  await viewer.settled();
  const light = async (layers) =>
    viewer.evaluate(
      (viewer, picture) => {
        const { data } = viewer.pictures[picture];
        let count = 0;
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3] === 255 && Math.min(data[i], data[i + 1], data[i + 2]) > 150) ++count;
        return count;
      },
      await viewer.picture(layers),
    );
  assert.equal(await light(['original']), 0);
  const seen = await light(['original', 'bisectors']);
  assert.ok(seen > 50, `${seen} light pixels beside the bisector`);
});
