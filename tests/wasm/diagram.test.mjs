// SPDX-License-Identifier: MIT
//
// That what the core computes arrives whole and in terms of the input. Whether it is right is for
// the tests of the core to say.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'geodesic-voronoi';
import { areaOf, listsOf } from './files.mjs';
import { apart, grid, octahedron, placeOf, withFlipped } from './meshes.mjs';
import { fails, near } from './expectations.mjs';

const gvd = await load();

const centre = [1 / 3, 1 / 3, 1 / 3];

/** Checks everything that a diagram's arrays promise whatever the surface. */
function checkArrays(mesh, { data, regions }) {
  const { points, segments, arcs, voronoiPoints, loops, cells, faceLabel } = data;
  const pointCount = points.face.length;
  const place = (i) => [...points.position.subarray(3 * i, 3 * i + 3)];

  assert.equal(points.bary.length, 3 * pointCount);
  assert.equal(points.position.length, 3 * pointCount);
  for (let i = 0; i < pointCount; ++i) {
    const position = placeOf(mesh, points.face[i], points.bary.subarray(3 * i));
    position.forEach((x, axis) => near(points.position[3 * i + axis], x));
  }

  assert.equal(segments.points.length, 2 * segments.face.length);
  assert.equal(segments.labels.length, 2 * segments.face.length);
  const arcPoints = listsOf(arcs);
  assert.equal(arcs.labels.length, 2 * arcPoints.length);
  segments.arc.forEach((arc, i) => {
    const [tail, tip] = segments.points.subarray(2 * i);
    assert.ok(arcPoints[arc].some((point, j) => point === tail && arcPoints[arc][j + 1] === tip));
    const labels = segments.labels.subarray(2 * i, 2 * i + 2);
    assert.deepEqual(labels, arcs.labels.subarray(2 * arc, 2 * arc + 2));
    assert.ok(labels[0] < labels[1]);
    assert.equal(faceLabel[segments.face[i]], -2);
  });

  assert.equal(voronoiPoints.labelOffset.length, voronoiPoints.point.length + 1);
  assert.equal(voronoiPoints.labelOffset.at(-1), voronoiPoints.labels.length);

  const areas = new Float64Array(data.siteCount);
  assert.equal(faceLabel.length, mesh.indices.length / 3);
  faceLabel.forEach((label, f) => {
    const corners = [0, 1, 2].map((c) =>
      placeOf(
        mesh,
        f,
        [0, 1, 2].map((k) => Number(k === c)),
      ),
    );
    if (label >= 0) areas[label] += areaOf(corners);
  });
  listsOf(cells).forEach((polygon, i) => {
    assert.equal(faceLabel[cells.face[i]], -2);
    areas[cells.label[i]] += areaOf(polygon.map(place));
  });
  areas.forEach((area, label) => near(data.regionArea[label], area));

  assert.equal(regions.length, data.siteCount);
  const loopPoints = listsOf(loops);
  assert.equal(loops.label.length, loopPoints.length);
  regions.forEach((region, label) => {
    assert.equal(region.label, label);
    assert.equal(region.area, data.regionArea[label]);
    assert.deepEqual(
      region.loops.map((loop) => [...loop]),
      loopPoints.filter((_, i) => loops.label[i] === label),
    );
    for (const other of region.neighbours) assert.ok(regions[other].neighbours.includes(label));
  });
}

test('an outline of 60,000 steps, which is longer than a slice', async () => {
  const n = 30_000;
  const positions = Array.from({ length: n + 1 }, (_, i) => [i, 0, 0, i, 1, 0]).flat();
  const quad = (i) => [i, i + 2, i + 1, i + 1, i + 2, i + 3];
  const strip = await gvd.mesh({
    positions,
    indices: Array.from({ length: n }, (_, i) => quad(2 * i)).flat(),
  });
  const { regions } = await strip.voronoi({ vertex: [0] }, { metric: 'dgpc' }); // the quicker one
  assert.equal(regions[0].loops[0].length, 2 * (n + 1));
  near(regions[0].area, n, 1e-6);
});

test('the arrays of a diagram fit together, and the areas make up the surface', async () => {
  for (const shape of [grid(7), octahedron()]) {
    const mesh = await gvd.mesh(shape);
    for (const detail of [0, 2]) {
      const diagram = await mesh.voronoi(await mesh.sampleSites(9), { detail });
      checkArrays(mesh, diagram);
      near(
        diagram.data.regionArea.reduce((a, b) => a + b),
        mesh.info.area,
      );
      assert.ok(diagram.data.segments.face.length > 0);
      assert.ok(diagram.data.voronoiPoints.point.length > 0);
    }
  }
});

test('results are in terms of the input, also where its triangles were turned over or dropped', async () => {
  const { positions, indices } = withFlipped(grid(4), 9);
  const mesh = await gvd.mesh({ positions, indices: [0, 1, 1, ...indices] });
  assert.equal(mesh.info.repairs.flippedTriangles, 1);
  const straight = await gvd.mesh({ positions, indices: [0, 1, 1, ...grid(4).indices] });
  // Site 1 has corners of weights that differ, in the triangle that is turned over.
  const sites = { face: [2, 10, 30], bary: [...centre, 0.5, 0.2, 0.3, ...centre] };
  const turned = { face: sites.face, bary: [...centre, 0.5, 0.3, 0.2, ...centre] };
  const diagram = await mesh.voronoi(sites);
  checkArrays(mesh, diagram);
  assert.equal(diagram.data.faceLabel[0], -3);
  const expected = await straight.voronoi(turned);
  diagram.data.regionArea.forEach((area, i) => near(area, expected.data.regionArea[i]));
});

test('what no site reaches has label -1, and Infinity for a distance', async () => {
  const mesh = await gvd.mesh(apart(octahedron(), grid(1)));
  const diagram = await mesh.voronoi({ vertex: [0] });
  assert.deepEqual([...diagram.data.faceLabel], [0, 0, 0, 0, 0, 0, 0, 0, -1, -1]);
  const { label, distance } = await diagram.locate({ vertex: [6, 0, 2] });
  assert.deepEqual([...label], [-1, 0, 0]);
  assert.equal(distance[0], Infinity);
  near(distance[1], 0);
  near(distance[2], Math.SQRT2);
});

test('one site: the whole surface is its region', async () => {
  const mesh = await gvd.mesh(octahedron());
  const { data, regions } = await mesh.voronoi({ vertex: [2] });
  assert.equal(data.arcs.labels.length, 0);
  near(regions[0].area, mesh.info.area);
  assert.deepEqual(regions[0].loops, []);
  assert.deepEqual(regions[0].neighbours, []);
});

test('copies of a region have all that it has', async () => {
  const mesh = await gvd.mesh(grid(3));
  const [region] = (await mesh.voronoi({ vertex: [0, 15] })).regions;
  const { label, area, neighbours, loops } = region;
  const all = { label, area, neighbours, loops };
  assert.deepEqual({ ...region }, all);
  assert.deepEqual(structuredClone(region), all);
  const lists = { ...all, loops: loops.map((loop) => [...loop]) };
  assert.deepEqual(JSON.parse(JSON.stringify(region)), lists);
});

test('sites given by vertices are those given by faces', async () => {
  const mesh = await gvd.mesh(grid(3));
  const { sites } = await mesh.voronoi({ vertex: [0, 15] });
  assert.deepEqual(placeOf(mesh, sites.face[0], sites.bary), [0, 0, 0]);
  assert.deepEqual(placeOf(mesh, sites.face[1], sites.bary.subarray(3)), [1, 1, 0]);
});

test('sites that are not on the surface are refused with their index', async () => {
  const mesh = await gvd.mesh(octahedron());
  const cases = [
    [{ face: [0, 8], bary: [...centre, ...centre] }, 'invalid-point', /1.*8/],
    [{ face: [-1], bary: centre }, 'invalid-point', /-1/],
    [{ face: [0], bary: [NaN, 0, 0] }, 'invalid-point', /0/],
    [{ face: [0], bary: [0.5, 0.5, 0.5] }, 'invalid-point'],
    [{ face: [0], bary: [1.5, -0.5, 0] }, 'invalid-point'],
    [{ vertex: [6] }, 'invalid-point', /6/],
  ];
  for (const [sites, code, message] of cases) {
    await assert.rejects(mesh.voronoi(sites), fails(code, message));
  }
  const diagram = await mesh.voronoi({ vertex: [0] });
  await assert.rejects(diagram.locate({ face: [9], bary: centre }), fails('invalid-point', /9/));
  assert.deepEqual((await diagram.locate({ face: [], bary: [] })).label, new Int32Array(0));
});

test('progress rises to 1, and other work has its turn meanwhile', async () => {
  const mesh = await gvd.mesh(grid(150));
  const shares = [];
  let turns = 0;
  const timer = setInterval(() => ++turns, 1);
  const sites = await mesh.sampleSites(300);
  await mesh.voronoi(sites, { onProgress: (share) => shares.push(share) });
  clearInterval(timer);
  assert.ok(shares.length > 1);
  assert.ok(shares.every((share, i) => share >= (shares[i - 1] ?? 0)));
  assert.equal(shares.at(-1), 1);
  assert.ok(turns > 0);
});

test('what a listener throws ends the task', async () => {
  const mesh = await gvd.mesh(grid(20));
  const onProgress = () => {
    throw new Error('no screen');
  };
  await assert.rejects(mesh.voronoi({ vertex: [0] }, { onProgress }), /no screen/);
});

test('a site is inserted, whatever a listener throws, and when', async () => {
  const mesh = await gvd.mesh(grid(20));
  for (const end of [0, 1]) {
    const diagram = await mesh.voronoi({ vertex: [0] });
    const onProgress = (share) => {
      if (share >= end) throw new Error('no screen');
    };
    await assert.rejects(diagram.insertSite({ vertex: 40 }, { onProgress }), /no screen/);
    assert.equal(diagram.sites.face.length, 2);
    assert.equal(diagram.regions.length, 2);
    assert.equal((await diagram.insertSite({ vertex: 80 })).label, 2);
    assert.deepEqual([...(await diagram.locate({ vertex: [0, 40, 80] })).label], [0, 1, 2]);
  }
});

test('points are looked up as a part of the task, which can be given up', async () => {
  const mesh = await gvd.mesh(grid(20));
  const position = Array.from({ length: 30000 }, () => [3, 4, 5]).flat();
  const controller = new AbortController();
  const diagram = mesh.voronoi({ position }, { signal: controller.signal });
  await Promise.resolve();
  controller.abort(new Error('changed my mind'));
  await assert.rejects(diagram, /changed my mind/);
});

test('a tessellation checks and copies what it is given at the call', async () => {
  const mesh = await gvd.mesh(grid(20));
  const refused = mesh.cvt({ vertex: [0] }, { iterations: -1 });
  await assert.rejects(refused.next(), fails('invalid-argument'));
  const vertex = [0, 40];
  const states = mesh.cvt({ vertex }, { iterations: 0 });
  vertex[1] = 80;
  const { value } = await states.next();
  assert.deepEqual(value.sites.face, (await mesh.readPoints({ vertex: [0, 40] })).face);
});

test('a mesh is freed if a listener throws once it is made', async (t) => {
  const { instantiate } = WebAssembly;
  const memories = [];
  t.mock.method(WebAssembly, 'instantiate', async (...args) => {
    const instance = await instantiate(...args);
    memories.push(instance.exports.memory);
    return instance;
  });
  const fresh = await load();
  const input = grid(200);
  const onProgress = (share) => {
    if (share === 1) throw new Error('no screen');
  };
  const openOnce = () => assert.rejects(fresh.mesh(input, { onProgress }), /no screen/);
  const bytes = () => memories.reduce((sum, { buffer }) => sum + buffer.byteLength, 0);
  await openOnce();
  const before = bytes();
  for (let i = 0; i < 5; ++i) await openOnce();
  assert.equal(bytes(), before);
});

test('tasks at the same time do not disturb each other', async () => {
  const mesh = await gvd.mesh(grid(60));
  const seeds = [1, 2, 3];
  const compute = async (seed) => (await mesh.voronoi(await mesh.sampleSites(200, { seed }))).data;
  const together = await Promise.all(seeds.map(compute));
  for (const [i, seed] of seeds.entries()) assert.deepEqual(together[i], await compute(seed));
});

test('arrays stay valid while the memory of the module grows', async () => {
  const fresh = await load();
  const small = await fresh.mesh(octahedron());
  const diagram = await small.voronoi({ vertex: [0, 3] });
  const before = structuredClone(diagram.data);
  const large = await fresh.mesh(grid(400));
  await large.voronoi(await large.sampleSites(50));
  assert.deepEqual(diagram.data, before);
  assert.deepEqual([...(await diagram.locate({ vertex: [0, 3] })).label], [0, 1]);
});

test('what is disposed says so, and may be disposed again', async () => {
  const library = await load();
  const mesh = await library.mesh(octahedron());
  const diagram = await mesh.voronoi({ vertex: [0] });
  const second = await mesh.voronoi({ vertex: [1] });
  diagram.dispose();
  diagram.dispose();
  await assert.rejects(diagram.locate({ vertex: [0] }), fails('disposed', /diagram/));
  near(diagram.regions[0].area, mesh.info.area);
  mesh.dispose();
  mesh.dispose();
  await assert.rejects(mesh.voronoi({ vertex: [0] }), fails('disposed', /mesh/));
  await assert.rejects(mesh.sampleSites(1), fails('disposed', /mesh/));
  assert.deepEqual([...(await second.locate({ vertex: [1] })).label], [0]);
  library.dispose();
  library.dispose();
  await assert.rejects(second.locate({ vertex: [1] }), fails('disposed', /library/));
  await assert.rejects(library.mesh(octahedron()), fails('disposed', /library/));
  second.dispose();
});

test('disposing the library ends its tasks', async () => {
  const library = await load();
  const mesh = await library.mesh(grid(150));
  const running = mesh.voronoi(await mesh.sampleSites(300));
  library.dispose();
  await assert.rejects(running, fails('disposed'));
});

test('Symbol.dispose disposes', async () => {
  const mesh = await gvd.mesh(octahedron());
  mesh[Symbol.dispose]();
  await assert.rejects(mesh.sampleSites(1), fails('disposed'));
});
