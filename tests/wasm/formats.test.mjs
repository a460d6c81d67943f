// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  diagramGlb,
  diagramJson,
  diagramObj,
  distancesGlb,
  load,
  partitionGlb,
  partitionStl,
  polygonGlb,
  polygonStl,
} from 'geodesic-voronoi';
import { assertValidGlb, jsonOf } from './files.mjs';
import { bumpySphere, grid } from './meshes.mjs';
import { fails, haveLinesTooLong, near } from './expectations.mjs';

const gvd = await load();
const mesh = await gvd.mesh(grid(5));
const diagram = await mesh.voronoi(await mesh.sampleSites(6));
const single = await mesh.voronoi({ vertex: [0] });

/** The length of all bisectors together. */
function length(places, pairs) {
  return pairs.reduce(
    (sum, [a, b]) => sum + Math.hypot(...places[a].map((x, k) => x - places[b][k])),
    0,
  );
}

function expectedLength() {
  const { points, segments } = diagram.data;
  const places = Array.from(points.face, (_, i) => [...points.position.subarray(3 * i, 3 * i + 3)]);
  const pairs = Array.from(segments.face, (_, i) => segments.points.subarray(2 * i, 2 * i + 2));
  return length(places, pairs);
}

test('JSON holds the diagram in plain arrays', () => {
  const json = JSON.parse(JSON.stringify(diagramJson(diagram)));
  const { data, regions } = diagram;
  assert.equal(json.metric, 'exact');
  assert.equal(json.scale, 1);
  assert.deepEqual(json.sites.bary, [...diagram.sites.bary]);
  assert.deepEqual(json.faceLabel, [...data.faceLabel]);
  assert.deepEqual(json.indifferentFaces, [...data.indifferentFaces]);
  // Points are numbered anew: by where they are, they are the same.
  const placesOf = (position) => (list) =>
    [...list].map((point) => position.slice(3 * point, 3 * point + 3).join());
  const written = placesOf(json.points.position);
  const known = placesOf([...data.points.position]);
  const { loops, ...region } = json.regions[2];
  assert.deepEqual(region, { area: regions[2].area, neighbours: regions[2].neighbours });
  assert.deepEqual(loops.map(written), regions[2].loops.map(known));
  assert.equal(json.arcs.length, data.arcs.offset.length - 1);
  assert.deepEqual(
    json.arcs.flatMap(({ points }) => written(points)),
    known(data.arcs.points),
  );
  assert.deepEqual(
    json.voronoiPoints.flatMap(({ point }) => written([point])),
    known(data.voronoiPoints.point),
  );
  assert.deepEqual(
    json.cells.flatMap(({ points }) => written(points)),
    known(data.cells.points),
  );
  assert.deepEqual(
    json.cells.map(({ face, label }) => [face, label]),
    Array.from(data.cells.face, (face, i) => [face, data.cells.label[i]]),
  );
  assert.deepEqual(
    json.arcs.flatMap(({ labels }) => labels),
    [...data.arcs.labels],
  );
  assert.deepEqual(
    json.voronoiPoints.flatMap(({ labels }) => labels),
    [...data.voronoiPoints.labels],
  );
});

test('JSON names the face of every piece of a bisector, and every point is named', async () => {
  for (const detail of [0, 2]) {
    const fine = await mesh.voronoi(diagram.sites, { detail });
    await fine.insertSite({ vertex: [14] });
    const json = diagramJson(fine);
    const named = new Set(json.voronoiPoints.map(({ point }) => point));
    for (const list of [...json.arcs, ...json.cells]) for (const p of list.points) named.add(p);
    for (const { loops } of json.regions) for (const p of loops.flat()) named.add(p);
    assert.deepEqual(
      [...named].sort((a, b) => a - b),
      [...json.points.face.keys()],
    );
    const cellsOf = new Map();
    for (const cell of json.cells)
      cellsOf.set(cell.face, [...(cellsOf.get(cell.face) ?? []), cell]);
    for (const { labels, points, faces } of json.arcs) {
      assert.equal(faces.length, points.length - 1);
      faces.forEach((face, i) => {
        const here = cellsOf
          .get(face)
          .filter(({ points: corners }) =>
            [points[i], points[i + 1]].every((point) => corners.includes(point)),
          );
        for (const label of labels) assert.ok(here.some((cell) => cell.label === label));
      });
    }
    json.faceLabel.forEach((label, face) => assert.equal(label === -2, cellsOf.has(face)));
    fine.dispose();
  }
});

test('JSON scales lengths and areas, and says so', () => {
  const json = diagramJson(diagram, { scale: 1000, unit: 'mm' });
  assert.deepEqual([json.scale, json.unit], [1000, 'mm']);
  const { position } = diagramJson(diagram).points;
  json.points.position.forEach((x, i) => near(x, 1000 * position[i], 1e-9));
  near(json.regions[0].area, 1e6 * diagram.regions[0].area, 1e-6);
});

test('OBJ draws every bisector once', () => {
  const lines = diagramObj(diagram.data, { scale: 10 })
    .trimEnd()
    .split('\n')
    .map((line) => line.split(' '));
  const rows = (key) => lines.filter(([first]) => first === key).map(([, ...rest]) => rest);
  const places = rows('v').map((row) => row.map(Number));
  const pairs = rows('l').flatMap((row) => row.slice(1).map((n, i) => [row[i] - 1, n - 1]));
  near(length(places, pairs), 10 * expectedLength(), 1e-9);
  assert.equal(rows('g').length, rows('l').length);
  assert.match(rows('g')[0][0], /^bisector_\d_\d$/);
});

test('GLB draws every bisector once', () => {
  const bytes = diagramGlb(diagram.data, { scale: 10 });
  const view = new DataView(bytes.buffer);
  assert.equal(view.getUint32(8, true), bytes.length);
  const jsonLength = view.getUint32(12, true);
  const json = jsonOf(bytes);
  const bin = 28 + jsonLength;
  assert.equal(json.meshes[0].primitives[0].mode, 1);
  const [vertices, indices] = json.accessors;
  const places = Array.from({ length: vertices.count }, (_, i) => [
    ...new Float32Array(bytes.slice(bin + 12 * i, bin + 12 * i + 12).buffer),
  ]);
  for (const k of [0, 1, 2]) {
    assert.equal(vertices.min[k], Math.min(...places.map((place) => place[k])));
    assert.equal(vertices.max[k], Math.max(...places.map((place) => place[k])));
  }
  const start = bin + json.bufferViews[1].byteOffset;
  const numbers = new Uint32Array(bytes.slice(start, start + 4 * indices.count).buffer);
  const pairs = Array.from({ length: indices.count / 2 }, (_, i) =>
    numbers.subarray(2 * i, 2 * i + 2),
  );
  near(length(places, pairs), 10 * expectedLength(), 1e-4);
});

test('a diagram without bisectors is a valid file all the same', () => {
  assert.deepEqual(diagramJson(single).arcs, []);
  assert.equal(
    diagramObj(single.data)
      .split('\n')
      .filter((line) => /^[vl] /.test(line)).length,
    0,
  );
  const bytes = diagramGlb(single.data);
  const json = jsonOf(bytes);
  assert.deepEqual(json.scenes, [{}]);
});

test('a GLB keeps a model together that is far from the origin', async () => {
  const shape = bumpySphere(24, 36);
  const from = [500000, 4649776, 120];
  const far = await gvd.mesh({
    ...shape,
    positions: shape.positions.map((x, i) => x + from[i % 3]),
  });
  const sites = await far.sampleSites(20);
  const apart = await far.voronoi(sites);
  const partition = await apart.partition();
  for (const scale of [1, 1000]) {
    for (const bytes of [
      partitionGlb(partition, { mesh: far, scale }),
      partitionGlb(partition, { mesh: far, scale, layout: 'features' }),
      distancesGlb(await far.distances(sites), { mesh: far, scale }),
    ]) {
      await assertValidGlb(bytes);
      const { info, positions } = await gvd.mesh(bytes);
      assert.equal(info.components, 1);
      assert.equal(info.boundaryLoops, 0);
      near(info.area / (scale * scale * far.info.area), 1, 1e-6);
      const top = positions.reduce((most, x, i) => (i % 3 === 2 ? Math.max(most, x) : most), 0);
      near(top / scale, 120 + Math.max(...shape.positions.filter((_, i) => i % 3 === 2)), 1e-6);
    }
    const { info } = await gvd.mesh(polygonGlb(await apart.dual(), { mesh: far, scale }));
    assert.equal(info.boundaryLoops, 0);
    await assertValidGlb(diagramGlb(apart, { scale }));
  }
});

test('coordinates too large for 32 bits are refused by the formats that have no others', async () => {
  const partition = await diagram.partition();
  const dual = await diagram.dual();
  for (const write of [
    (options) => partitionGlb(partition, options),
    (options) => diagramGlb(diagram, options),
    (options) => polygonGlb(dual, options),
    (options) => partitionStl(partition, options),
    (options) => polygonStl(dual, options),
  ])
    assert.throws(() => write({ scale: 1e60 }), {
      code: 'invalid-argument',
      message: /^multiplied by 1e\+60, coordinates are too large for the numbers of an? (GLB|STL)/,
    });
});

test('a text that would be longer than a string may be is refused by a sentence', (t) => {
  haveLinesTooLong(t);
  assert.throws(() => diagramObj(diagram.data), fails('out-of-memory', /text .* string .* binary/));
});
