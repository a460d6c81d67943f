// SPDX-License-Identifier: MIT
//
// Distances per vertex and paths: that they arrive in terms of the input, agree with the diagram, and
// that others can read the files. That they are right is for the tests of the core to say.

import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import {
  distancesGlb,
  distancesJson,
  distancesPly,
  load,
  pathsJson,
  pathsObj,
} from 'geodesic-voronoi';
import { assertValidGlb, readPly, threeMeshes } from './files.mjs';
import { apart, bumpySphere, grid, octahedron, placeOf, pointAt, withFlipped } from './meshes.mjs';
import { near } from './expectations.mjs';

const gvd = await load();

/** The first side of a triangle and what lies to its left, as unit vectors; in the plane z = 0. */
function frameOf({ positions, indices }, face) {
  const [a, b] = [0, 1].map((k) => 3 * indices[3 * face + k]);
  const [x, y] = [positions[b] - positions[a], positions[b + 1] - positions[a + 1]];
  const length = Math.hypot(x, y);
  return [x / length, y / length];
}

for (const metric of ['exact', 'dgpc'])
  describe(`distances, ${metric}`, () => {
    test('are those of the diagram at the vertices', async () => {
      const mesh = await gvd.mesh(bumpySphere(16, 24));
      const sites = await mesh.sampleSites(12);
      const { label, distance, direction, ...rest } = await mesh.distances(sites, {
        metric,
      });
      assert.deepEqual(rest, { metric, sites });
      const count = mesh.positions.length / 3;
      assert.equal(label.length, count);
      assert.equal(direction.length, 2 * count);
      const diagram = await mesh.voronoi(sites, { metric });
      const located = await diagram.locate({ vertex: [...label.keys()] });
      assert.deepEqual(label, located.label);
      distance.forEach((d, v) => near(d, located.distance[v]));
      for (let v = 0; v < count; ++v) near(Math.hypot(direction[2 * v], direction[2 * v + 1]), 1);
    });

    test('in the plane, distance and direction lead from the site to the vertex', async () => {
      const plane = grid(7);
      const sites = await (await gvd.mesh(plane)).sampleSites(9, { seed: 4 });
      const turned = sites.face[0];
      for (const source of [plane, withFlipped(plane, turned)]) {
        const mesh = await gvd.mesh(source);
        const places = Array.from(sites.face, (face, i) =>
          placeOf(mesh, face, sites.bary.subarray(3 * i)),
        );
        const { label, distance, direction } = await mesh.distances(sites, { metric });
        label.forEach((site, v) => {
          const face = sites.face[site];
          const [x, y] = frameOf(mesh, face);
          // Of a triangle whose corners run clockwise, the left side is on the right.
          const left = source !== plane && face === turned ? -1 : 1;
          const [along, across] = [direction[2 * v], left * direction[2 * v + 1]];
          near(places[site][0] + distance[v] * (along * x - across * y), mesh.positions[3 * v]);
          near(places[site][1] + distance[v] * (along * y + across * x), mesh.positions[3 * v + 1]);
        });
      }
    });

    test('what is out of reach, isolated, at the same place', async () => {
      const { positions, indices } = apart(octahedron(), grid(1));
      const mesh = await gvd.mesh({
        positions: [...positions, 9, 9, 9, ...positions.slice(3, 6)],
        indices,
      });
      const { label, distance, direction } = await mesh.distances({ vertex: [0, 3] }, { metric });
      assert.deepEqual([...label], [0, 0, 0, 1, 0, 0, -1, -1, -1, -1, -1, 0]);
      assert.deepEqual([...distance.subarray(6, 11)], new Array(5).fill(Infinity));
      assert.ok(direction.subarray(12, 22).every(Number.isNaN));
      assert.equal(distance[11], distance[1]);
      assert.deepEqual(direction.slice(22), direction.slice(2, 4));
      assert.deepEqual([distance[0], distance[3]], [0, 0]);
      assert.deepEqual([...direction.subarray(0, 2)], [1, 0]);
    });
  });

test('PLY and GLB hold the mesh with its distances, JSON the arrays', async () => {
  const shape = apart(octahedron(), grid(2));
  const mesh = await gvd.mesh({
    positions: [...shape.positions, NaN, 0, 0],
    indices: [...shape.indices, 0, 1, 15],
    normals: [...shape.positions.map((x, i) => 2 * x * (i < 18)), 0, 0, 0],
    uvs: new Array(32).fill(0.5),
  });
  const distances = await mesh.distances({ vertex: [0, 5] });
  const { label, distance, direction } = distances;

  const { vertex, face } = readPly(distancesPly(distances, { mesh, scale: 3 }));
  assert.equal(face.length, mesh.indices.length / 3);
  vertex.forEach((row, v) => {
    assert.equal(row.label, label[v]);
    assert.equal(row.distance, 3 * distance[v]);
    assert.deepEqual([row.direction_x, row.direction_y], [...direction.subarray(2 * v, 2 * v + 2)]);
    assert.deepEqual(row.x, 3 * mesh.positions[3 * v]);
  });

  const bytes = distancesGlb(distances, { mesh, scale: 3 });
  await assertValidGlb(bytes);
  const [{ geometry }] = await threeMeshes(bytes);
  assert.equal(geometry.index.count, mesh.indices.length - 3, 'without what is not finite');
  const attribute = (name) => [...geometry.attributes[name].array];
  assert.deepEqual(attribute('_label'), [...label]);
  assert.deepEqual(
    attribute('_distance'),
    Array.from(distance, (d) => (d === Infinity ? -1 : Math.fround(3 * d))),
  );
  assert.equal(geometry.attributes.normal.count, vertex.length);

  const json = JSON.parse(JSON.stringify(distancesJson(distances, { scale: 3 })));
  assert.deepEqual(json.label, [...label]);
  json.distance.forEach((d, v) => assert.equal(d ?? Infinity, 3 * distance[v]));
  json.direction.forEach((x, i) => assert.equal(x ?? NaN, direction[i]));
});

test('a path is as long as its distance, and crosses edges on its way', async () => {
  const mesh = await gvd.mesh(bumpySphere(16, 24));
  const points = await mesh.sampleSites(24, { seed: 2 });
  for (let i = 0; i < 12; ++i) {
    const [from, to] = [pointAt(points, i), pointAt(points, 12 + i)];
    const path = await mesh.path(from, to);
    const diagram = await mesh.voronoi(to);
    const { distance } = await diagram.locate(from);
    near(path.length, distance[0], 1e-9 * distance[0], 'length');
    const { face, bary, position } = path.points;
    const toSite = await diagram.path(from);
    near(toSite.length, path.length, 1e-9 * path.length, 'to the site');
    assert.equal(toSite.points.position.length, position.length);
    toSite.points.position.forEach((x, p) => near(x, position[p]));
    assert.equal(bary.length, 3 * face.length);
    const end = face.length - 1;
    assert.equal(face[0], from.face[0]);
    let length = 0;
    for (let p = 1; p <= end; ++p) {
      const step = [0, 1, 2].map((k) => position[3 * p + k] - position[3 * p - 3 + k]);
      length += Math.hypot(...step);
    }
    near(length, path.length, 1e-9 * length, 'in space');
    for (let k = 0; k < 3; ++k) {
      near(position[k], placeOf(mesh, from.face[0], from.bary)[k]);
      near(position[3 * end + k], placeOf(mesh, to.face[0], to.bary)[k]);
    }
    for (let p = 1; p < end; ++p)
      assert.ok([...bary.subarray(3 * p, 3 * p + 3)].includes(0), 'on an edge');
    diagram.dispose();
  }
});

test('a path leads from a point to its own site, also after changes', async () => {
  for (const metric of ['exact', 'dgpc']) {
    const mesh = await gvd.mesh(withFlipped(grid(6), 17));
    const diagram = await mesh.voronoi({ vertex: [0, 48] }, { metric });
    const check = async (vertex, expected, length) => {
      const path = await diagram.path({ vertex: [vertex] });
      near(path.length, length);
      const end = path.points.position.slice(-3);
      [0, 1, 2].forEach((k) => near(end[k], mesh.positions[3 * expected + k]));
    };
    await check(1, 0, 1 / 6);
    await check(40, 48, Math.SQRT2 / 6);
    await diagram.moveSite(1, { vertex: [6] });
    await check(13, 6, 1 / 6);
    await check(0, 0, 0);
  }
});

test('without a path there are no points, and its length is Infinity', async () => {
  const mesh = await gvd.mesh(apart(octahedron(), grid(1)));
  const { points, length } = await mesh.path({ vertex: [0] }, { vertex: [7] });
  assert.equal(length, Infinity);
  assert.deepEqual([points.face.length, points.bary.length, points.position.length], [0, 0, 0]);
  assert.equal(pathsJson([{ points, length }]).paths[0].length, null);
  assert.doesNotMatch(pathsObj([{ points, length }]), /^[vl] /m);
});
