// SPDX-License-Identifier: MIT
//
// Duals and regions as polygons: that they arrive whole and valid, and that others can read the files.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load, polygonGlb, polygonJson, polygonObj, polygonPly } from 'geodesic-voronoi';
import {
  areaOf,
  assertValidGlb,
  listsOf,
  readObj,
  readPly,
  surfaceOf,
  threeMeshes,
  total,
  trianglesOf,
} from './files.mjs';
import { apart, bumpySphere, grid, octahedron, pointAt, presentSites, triples } from './meshes.mjs';
import { near } from './expectations.mjs';

const gvd = await load();

async function validDiagram(input = grid(8), count = 12) {
  const mesh = await gvd.mesh(input);
  const diagram = await (await mesh.voronoi(await mesh.sampleSites(count, { seed: 3 }))).repair();
  return { mesh, diagram };
}

test('a dual has a vertex per site, in its place, and the topology of the surface', async () => {
  for (const input of [grid(8), octahedron(), apart(octahedron(), grid(5))]) {
    const { mesh, diagram } = await validDiagram(input);
    const { sites } = diagram;
    const dual = await diagram.dual();
    assert.deepEqual([...dual.points.face.subarray(0, sites.face.length)], [...sites.face]);
    assert.deepEqual([...dual.vertexLabel.subarray(0, sites.face.length)], [...sites.face.keys()]);
    assert.equal(dual.faceLabel.length, 0);
    assert.deepEqual(await diagram.violations(), []);
    const primal = await diagram.dual({ primal: true });
    assert.deepEqual(
      [...primal.faceLabel].sort((a, b) => a - b),
      [...sites.face.keys()],
    );
    for (const polygons of [dual, primal]) {
      const { euler, isOriented } = surfaceOf(listsOf(polygons.faces));
      assert.ok(isOriented);
      assert.equal(euler, mesh.info.eulerCharacteristic);
      assert.equal(polygons.topology.eulerCharacteristic, euler);
      for (const key of ['components', 'boundaryLoops', 'genus'])
        assert.equal(polygons.topology[key], mesh.info[key], key);
    }
  }
});

test('the triangles of a dual are a manifold where one region cuts another off', async () => {
  const mesh = await gvd.mesh(grid(4));
  // The second sites have a Voronoi point of three regions on the boundary, which is a pentagon.
  for (const sites of [await mesh.sampleSites(5, { seed: 2 }), { vertex: [1, 7, 23, 3] }]) {
    const diagram = await mesh.voronoi(sites);
    assert.deepEqual(await diagram.violations(), []);
    const { points } = (await diagram.dual()).triangles;
    const { euler, isOriented } = surfaceOf(triples(points));
    assert.ok(isOriented);
    assert.equal(euler, 1);
  }
});

test('the sides of a dual are paths between the sites of its arcs', async () => {
  const { diagram } = await validDiagram(grid(12), 10);
  // Of a diagram that has changed, the order of arcs is another.
  const pairsOf = (labels) =>
    Array.from({ length: labels.length / 2 }, (_, i) =>
      labels.subarray(2 * i, 2 * i + 2).join(),
    ).sort();
  const isWhole = async () => {
    const { labels, offset, points } = await diagram.dualPaths();
    assert.deepEqual(pairsOf(labels), pairsOf(diagram.data.arcs.labels));
    assert.equal(points.position.length, 3 * offset.at(-1));
    const sites = await Promise.all(
      [...diagram.sites.face.keys()].map(async (i) => {
        return (await diagram.path(pointAt(diagram.sites, i))).points.position;
      }),
    );
    const at = (i) => [...points.position.subarray(3 * i, 3 * i + 3)];
    labels.forEach((label, i) => {
      const path = Math.floor(i / 2);
      const end = at(i % 2 === 0 ? offset[path] : offset[path + 1] - 1);
      end.forEach((x, k) => near(x, sites[label].at(k - 3), 1e-12));
    });
    // The surface is a plane: paths between neighbours are straight, or bend at the end of their arc.
    const lengths = labels
      .filter((_, i) => i % 2 === 0)
      .map((_, path) => {
        let length = 0;
        for (let i = offset[path]; i + 1 < offset[path + 1]; ++i) {
          length += Math.hypot(...at(i).map((x, k) => x - at(i + 1)[k]));
        }
        const [first, last] = [at(offset[path]), at(offset[path + 1] - 1)];
        return Math.round((1e9 * length) / Math.hypot(...first.map((x, k) => x - last[k]))) / 1e9;
      });
    assert.ok(lengths.filter((ratio) => ratio === 1).length >= 1, `${lengths}`);
  };
  await isWhole();
  await diagram.moveSite(2, { vertex: [40] });
  await isWhole();
});

test('violations are named with their regions', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  assert.deepEqual(await diagram.violations(), [
    {
      kind: 'closed-border',
      labels: [0, 1],
      message: 'regions 0 and 1 meet along a closed curve',
    },
  ]);
});

test('an edge of a dual that is no manifold counts once', async () => {
  // Opposite sites of a band: regions meet twice, so the dual's sides run there and back again.
  const mesh = await gvd.mesh(octahedron());
  let found = 0;
  for (let seed = 1; seed <= 20; ++seed) {
    const diagram = await mesh.voronoi(await mesh.sampleSites(4, { seed }));
    for (const primal of [false, true]) {
      const { faces, topology } = await diagram.dual({ primal });
      const edges = new Set(
        listsOf(faces).flatMap((list) =>
          list.map((from, i) => [from, list[(i + 1) % list.length]].sort((a, b) => a - b).join()),
        ),
      );
      assert.equal(topology.edges, edges.size);
      assert.equal(
        topology.eulerCharacteristic,
        topology.vertices - topology.edges + topology.faces,
      );
      found += !topology.isManifold;
    }
  }
  assert.ok(found > 0);
});

test('repair keeps the sites, adds some, and leaves what is valid alone', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  const valid = await diagram.repair();
  assert.deepEqual([...valid.sites.face.subarray(0, 2)], [...diagram.sites.face]);
  assert.ok(valid.sites.face.length > 2);
  assert.equal(await valid.repair(), valid);
  assert.equal((await diagram.dual()).points.face.length, 2, 'the first one is still there');
});

test('repair gives added sites the labels of removed ones, and keeps the detail', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 1, 3] }, { detail: 1 });
  await diagram.removeSite(1);
  const valid = await diagram.repair();
  const { face } = valid.sites;
  assert.deepEqual([face[0], face[2]], [diagram.sites.face[0], diagram.sites.face[2]]);
  assert.ok(face.every((each) => each >= 0));
  assert.deepEqual(await valid.violations(), []);
  const anew = await mesh.voronoi(valid.sites, { detail: 1 });
  assert.deepEqual(valid.data.loops, anew.data.loops);
});

test('repair may be limited and given up', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  await assert.rejects(diagram.repair({ maxAdded: 1 }), {
    code: 'too-few-sites',
    message: /regions \d/,
  });
  await assert.rejects(diagram.repair({ maxAdded: -1 }), { code: 'invalid-argument' });
  await assert.rejects(
    diagram.repair({ signal: AbortSignal.abort(new Error('enough')) }),
    /enough/,
  );
  const twice = await mesh.voronoi({ vertex: [0, 0] });
  await assert.rejects(twice.repair(), { message: /site 1 has no region/ });
});

test('GLB, OBJ and PLY hold the polygons', async () => {
  const { mesh, diagram } = await validDiagram();
  for (const primal of [false, true]) {
    const polygons = await diagram.dual({ primal });
    const lists = listsOf(polygons.faces);
    const place = (point) => [...polygons.points.position.subarray(3 * point, 3 * point + 3)];

    const bytes = polygonGlb(polygons, { mesh, scale: 10 });
    await assertValidGlb(bytes);
    const [{ geometry }] = await threeMeshes(bytes);
    const triangles = trianglesOf(geometry);
    assert.equal(triangles.length, polygons.triangles.face.length);
    assert.equal(triangles.length, total(lists.map(({ length }) => length - 2)));
    const area = total(triangles.map(areaOf));
    const expected = 100 * total(lists.map((list) => areaOf(list.map(place))));
    near(area / expected, 1, 1e-5);
    const again = await gvd.mesh(bytes);
    assert.equal(again.info.eulerCharacteristic, mesh.info.eulerCharacteristic);
    assert.equal(again.info.inputFaces, triangles.length);

    const obj = readObj(polygonObj(polygons, { mesh }));
    assert.deepEqual(
      obj.v,
      Array.from(polygons.points.face, (_, i) => place(i)),
    );
    assert.deepEqual(
      obj.faces.map(({ corners }) => corners.map(([point]) => point)),
      lists,
    );
    assert.deepEqual(
      obj.faces.map(({ group }) => group),
      lists.map((_, f) => (primal ? `region_${polygons.faceLabel[f]}` : '')),
    );

    const { vertex, face } = readPly(polygonPly(polygons, { mesh }));
    assert.deepEqual(
      face.map(({ vertex_indices: corners }) => corners),
      lists,
    );
    const labels = (primal ? face : vertex).map(({ label }) => label);
    assert.deepEqual(labels, [...(primal ? polygons.faceLabel : polygons.vertexLabel)]);

    const json = polygonJson(polygons, { scale: 3 });
    assert.deepEqual(json.faces, lists);
    assert.equal(json.points.position[1], 3 * polygons.points.position[1]);
  }
});

test('where there is no polygon, files are valid all the same', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0] });
  const dual = await diagram.dual();
  await assertValidGlb(polygonGlb(dual));
  assert.deepEqual(readObj(polygonObj(dual)).faces, []);
  assert.deepEqual(readPly(polygonPly(dual)).face, []);
  // Two regions with one closed border have no corners, three have polygons of two.
  const three = await (await mesh.voronoi({ vertex: [0, 1, 2] })).dual({ primal: true });
  for (const { corners } of readObj(polygonObj(three)).faces) assert.ok(corners.length >= 3);
});

test('quality of a dual as a remesh', async () => {
  const { diagram } = await validDiagram(grid(20), 60);
  const quality = await diagram.remeshQuality();
  assert.equal(quality.triangles, (await diagram.dual()).triangles.face.length);
  assert.ok(quality.minAngle > 0 && quality.meanMinAngle <= 60);
  assert.ok(quality.minValence >= 3 && quality.maxValence < 12);
  assert.ok(quality.regularShare >= 0 && quality.regularShare <= 1);
  // Flat, and corners of the square are cut.
  assert.ok(quality.hausdorff > 0 && quality.hausdorff < 0.3);
});

/** A ball with five long spikes, each of which needs a ring of sites. */
function star() {
  const { positions, indices } = bumpySphere(24, 40);
  const places = [];
  for (let i = 0; i < positions.length; i += 3) {
    const place = positions.slice(i, i + 3);
    const length = Math.hypot(...place);
    const spike = 0.5 + 0.5 * Math.cos(5 * Math.atan2(place[1], place[0]));
    const radius = 0.3 + 6 * ((Math.hypot(place[0], place[1]) / length) * spike) ** 4;
    places.push(...place.map((x) => (radius * x) / length));
  }
  return { positions: places, indices };
}

test('each round of a remesh adds at most half as many sites as the one before', async () => {
  const mesh = await gvd.mesh(star());
  const sites = await mesh.sampleSites(20);
  let last;
  for await (last of mesh.cvt(sites, { iterations: 5 }));
  const once = await (await mesh.voronoi(last.sites)).repair();
  const added = once.sites.face.length - 20;
  assert.ok(added > 20, 'there is something to add');
  const remeshed = await mesh.remesh(sites, { iterations: 5 });
  const inRounds = added + Math.floor(added / 2) + Math.floor(added / 4);
  assert.ok(remeshed.sites.face.length <= 20 + inRounds, `${remeshed.sites.face.length}`);
  assert.deepEqual(await remeshed.violations(), []);
  // The limit holds for all rounds together.
  const limited = await mesh.remesh(sites, { iterations: 5, maxAdded: added });
  assert.equal(limited.sites.face.length, once.sites.face.length);
  await assert.rejects(mesh.remesh(sites, { iterations: 5, maxAdded: 1 }), {
    code: 'too-few-sites',
  });
});

test('the sites that a remesh adds last move towards their centroids if that makes angles larger', async () => {
  const mesh = await gvd.mesh(star());
  const angleOf = async (diagram) => (await diagram.remeshQuality()).minAngle;
  const gains = [];
  for (const seed of [1, 2, 3, 4]) {
    const sites = await mesh.sampleSites(12, { seed });
    let last;
    for await (last of mesh.cvt(sites, { iterations: 3 }));
    const once = await (await mesh.voronoi(last.sites)).repair();
    const count = once.sites.face.length;
    // So there is one round.
    const settled = await mesh.remesh(sites, { iterations: 3, maxAdded: count - 12 });
    assert.equal(settled.sites.face.length, count);
    assert.deepEqual(settled.sites.face.slice(0, 12), once.sites.face.slice(0, 12));
    assert.deepEqual(await settled.violations(), []);
    gains.push((await angleOf(settled)) - (await angleOf(once)));
  }
  assert.ok(
    gains.every((gain) => gain >= 0),
    `${gains}`,
  );
  assert.ok(Math.max(...gains) > 0.1, `${gains}`);
});

test('after sites have come and gone, it is about those that are there', async () => {
  const mesh = await gvd.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0, 3] });
  await diagram.insertSite({ vertex: [1] });
  const { regions } = await diagram.partition();
  assert.equal(regions.area.length, 3);
  diagram.regions.forEach(({ area }, i) => near(regions.area[i], area, 1e-12));
  assert.equal((await diagram.dual()).points.face.length, 3);
  assert.ok((await diagram.repair()).sites.face.length > 3);
  await diagram.removeSite(1);
  assert.equal((await diagram.partition()).regions.area[1], 0);
  assert.deepEqual([...(await diagram.dual()).vertexLabel], [0, 2]);
  assert.deepEqual(
    (await diagram.violations()).map(({ labels }) => labels),
    [[0, 2]],
  );
  assert.ok((await diagram.repair()).sites.face.filter((face) => face >= 0).length > 2);
});

test('after a site has been removed, everything is about the others, by their labels', async () => {
  for (const metric of ['exact', 'dgpc']) {
    const mesh = await gvd.mesh(grid(12));
    const valid = await (
      await mesh.voronoi(await mesh.sampleSites(12, { seed: 3 }), { metric })
    ).repair();
    const diagram = await mesh.voronoi(valid.sites, { metric });
    await diagram.removeSite(4);
    const { face, bary } = diagram.sites;
    assert.deepEqual([face[4], ...bary.subarray(12, 15)], [-1, 0, 0, 0]);
    const { sites: others, labels } = presentSites(diagram.sites);
    const anew = await mesh.voronoi(others, { metric });

    const [dual, expected] = [await diagram.dual(), await anew.dual()];
    assert.deepEqual(
      [...dual.vertexLabel],
      Array.from(expected.vertexLabel, (label) => labels[label]),
    );
    assert.equal(dual.faces.points.length, expected.faces.points.length);
    assert.deepEqual(
      [...dual.points.face.subarray(0, labels.length)],
      [...expected.points.face.subarray(0, labels.length)],
    );
    const named = (violations, nameOf) =>
      violations.map(({ kind, labels: own }) => [kind, ...own.map(nameOf)]);
    assert.deepEqual(
      named(await diagram.violations(), (label) => label),
      named(await anew.violations(), (label) => labels[label]),
    );
    const [{ triangles }, { triangles: same }] = [
      await diagram.remeshQuality(),
      await anew.remeshQuality(),
    ];
    assert.equal(triangles, same);
    const repaired = await diagram.repair();
    assert.deepEqual(await repaired.violations(), []);

    // The list of sites is one for all that takes sites, with the same labels.
    const again = await mesh.voronoi(diagram.sites, { metric });
    assert.deepEqual(again.data.faceLabel, diagram.data.faceLabel);
    assert.equal(again.regions[4].area, 0);
    await again.insertSite({ vertex: [0] });
    assert.ok(again.sites.face[4] >= 0);
    const { label, sites } = await mesh.distances(diagram.sites, { metric });
    assert.ok(!label.includes(4) && sites.face[4] === -1);
    for await (const state of mesh.cvt(diagram.sites, { metric, iterations: 2 }))
      assert.equal(
        state.sites.face.findIndex((each) => each < 0),
        4,
      );
    const remeshed = await mesh.remesh(diagram.sites, { metric, iterations: 1 });
    assert.deepEqual(await remeshed.violations(), []);
  }
});

test('lists of sites may end with labels that have none, but have to have one that has', async () => {
  const mesh = await gvd.mesh(octahedron());
  const none = { face: [-1, -1], bary: [0, 0, 0, 0, 0, 0] };
  await assert.rejects(mesh.voronoi(none), { message: 'there is no site' });
  await assert.rejects(mesh.cvt(none).next(), { message: 'there is no site' });
  const diagram = await mesh.voronoi({ face: [0, -1], bary: [1, 0, 0, 0, 0, 0] });
  assert.equal(diagram.regions.length, 2);
  assert.deepEqual([...(await diagram.dual()).vertexLabel], [0]);
  await diagram.insertSite({ vertex: [3] });
  assert.deepEqual([...diagram.sites.face], [0, 1]);
});
