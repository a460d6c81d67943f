// SPDX-License-Identifier: MIT
//
// Points as callers and files give them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { diagramJson, load, pointsJson } from 'geodesic-voronoi';
import { readPointsFile } from '../../dist/input/points_reader.js';
import { grid, octahedron } from './meshes.mjs';
import { fails } from './expectations.mjs';

const gvd = await load();
const mesh = await gvd.mesh(octahedron());

const plain = ({ face, bary }) => ({ face: [...face], bary: [...bary] });

test('points in a file are read in every form', async () => {
  const one = { face: [3], bary: [0.25, 0.25, 0.5] };
  const at = [...(await mesh.positionsOf(one))];
  const read = async (json) => plain(await mesh.readPoints(JSON.parse(JSON.stringify(json))));
  assert.deepEqual(await read(one), one);
  assert.deepEqual(await read({ ...one, position: at, mesh: { faces: 8 } }), one);
  assert.deepEqual((await read({ position: at })).face, one.face);
  assert.deepEqual((await read([at, at])).face, [3, 3]);
  const { face, bary } = await mesh.readPoints({ vertex: [0, 5] });
  const places = [0, 5].flatMap((v) => [...mesh.positions.slice(3 * v, 3 * v + 3)]);
  assert.deepEqual([...(await mesh.positionsOf({ face, bary }))], places);

  const sites = await mesh.sampleSites(4);
  const diagram = await mesh.voronoi(sites);
  assert.deepEqual(await read(diagramJson(diagram)), pointsJson(sites));
  await diagram.removeSite(1);
  assert.deepEqual((await read(diagramJson(diagram))).face[1], -1);
});

test('points in a file are refused where they are none, or are those of another mesh', async () => {
  const plane = await gvd.mesh(grid(1));
  await assert.rejects(
    mesh.readPoints('{"vertex": [0]}'),
    fails('invalid-argument', 'this is a text: parse it by JSON.parse'),
  );
  for (const json of [null, 7, [], [0, 0, 0], [[0, 0]], {}, { face: [0] }, { sites: {} }]) {
    await assert.rejects(
      mesh.readPoints(json),
      fails('invalid-argument', /^there are no points: /),
    );
  }
  await assert.rejects(
    mesh.readPoints({ mesh: { faces: 12 }, vertex: [0] }),
    fails(
      'invalid-point',
      'the points belong to another mesh, of another file or made with other options: to one with 12 triangles, not 8',
    ),
  );
  await assert.rejects(
    plane.readPoints(diagramJson(await mesh.voronoi({ vertex: [0, 1] }))),
    fails(
      'invalid-point',
      'the points belong to another mesh, of another file or made with other options: to one with 8 triangles, not 2',
    ),
  );
  await assert.rejects(
    mesh.readPoints({ face: [0, 8], bary: [1, 0, 0, 1, 0, 0] }),
    fails('invalid-point', 'point 1: there is no triangle 8'),
  );
  await assert.rejects(
    mesh.readPoints({ face: [0], bary: [1, 1, 1] }),
    fails('invalid-point', 'point 0: the barycentric coordinates sum to 3, not 1'),
  );
  await assert.rejects(
    mesh.readPoints({ face: [0], bary: [1, 0] }),
    fails('invalid-argument', /^points\.bary has 2 numbers, not 3: /),
  );
});

test('files of many places are read in slices', async ({ mock }) => {
  let clock = 0;
  mock.method(performance, 'now', () => (clock += 1000)); // every step is a slice
  const rows = Array.from({ length: 2000 }, (_, i) => `${i} 0 0\n`).join('');
  const header = ['x', 'y', 'z'].map((axis) => `property float ${axis}\n`).join('');
  const ply = `ply\nformat ascii 1.0\nelement vertex 2000\n${header}end_header\n`;
  for (const text of [rows, rows.replaceAll(' ', ','), ply + rows]) {
    let turns = 0;
    let turn = setImmediate(function next() {
      ++turns;
      turn = setImmediate(next);
    });
    const { position } = await readPointsFile(new TextEncoder().encode(text));
    clearImmediate(turn);
    assert.deepEqual([position.length, position[3 * 1999]], [6000, 1999]);
    assert.ok(turns > 10, `${turns} turns`);
  }
});

test('points are not given in two ways at once', async () => {
  const triangle = { face: [0], bary: [1, 0, 0] };
  const both = (form) =>
    fails(
      'invalid-argument',
      `sites has both vertex and ${form}: only one can say where points are`,
    );
  await assert.rejects(mesh.voronoi({ ...triangle, vertex: [2] }), both('face'));
  await assert.rejects(mesh.voronoi({ position: [1, 0, 0], vertex: [2] }), both('position'));
  // The places of results, which say the same.
  const known = await mesh.closestPoints([1, 0, 0]);
  assert.equal((await mesh.voronoi({ ...known, position: [1, 0, 0] })).sites.face.length, 1);
});

test('without indices, every three vertices are a triangle', async () => {
  const { positions, indices } = octahedron();
  const corners = Array.from(indices).flatMap((v) => [...positions.slice(3 * v, 3 * v + 3)]);
  const { info } = await gvd.mesh({ positions: corners });
  assert.deepEqual([info.faces, info.vertices, info.boundaryLoops], [8, 6, 0]);
  await assert.rejects(
    gvd.mesh({ positions: corners.slice(3) }),
    fails(
      'invalid-argument',
      'positions has 69 numbers: without indices, every triangle needs nine',
    ),
  );
  await assert.rejects(
    gvd.mesh({ positions, index: indices }),
    fails('invalid-argument', /^positions come with "index", but without indices: the fields are/),
  );
  await gvd.mesh(await gvd.mesh({ positions, indices })); // with fields of its own
});
