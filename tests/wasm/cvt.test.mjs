// SPDX-License-Identifier: MIT
//
// That centroidal tessellations arrive iteration by iteration, on this thread and from a worker.

import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load } from 'geodesic-voronoi';
import { grid, octahedron, withFlipped } from './meshes.mjs';
import { fails, near } from './expectations.mjs';

const gvd = await load();
const mesh = await gvd.mesh(grid(8));
const sites = await mesh.sampleSites(12, { seed: 3 });
after(() => gvd.dispose());

async function collect(states) {
  const all = [];
  for await (const state of states) all.push(state);
  return all;
}

test('a state per iteration, the first that of the sites given', async () => {
  const states = await collect(mesh.cvt(sites, { iterations: 10 }));
  assert.deepEqual(
    states.map(({ iteration }) => iteration),
    [...states.keys()],
  );
  assert.equal(states.length, 11);
  assert.deepEqual(states[0].sites, sites);
  assert.equal(states[0].largestMove, 0);
  states.slice(1).forEach(({ energy, largestMove, data }, i) => {
    assert.ok(energy <= states[i].energy * (1 + 1e-12));
    assert.ok(largestMove > 0);
    assert.equal(data, undefined);
  });
});

test('ends without a further state when no step lowers the energy', async () => {
  const small = await gvd.mesh(grid(2));
  const start = await small.sampleSites(2, { seed: 2 });
  const states = await collect(small.cvt(start, { iterations: 200 }));
  assert.ok(states.length < 201);
  assert.deepEqual(
    states.map(({ iteration }) => iteration),
    [...states.keys()],
  );
});

test('with the diagram of its sites, if asked for', async () => {
  for await (const { sites: moved, data } of mesh.cvt(sites, { iterations: 2, data: true })) {
    // Sites given are normalised, which may change their last bits.
    const { data: expected } = await mesh.voronoi(moved);
    assert.equal(data.siteCount, 12);
    assert.deepEqual(data.faceLabel, expected.faceLabel);
    assert.deepEqual(data.segments, expected.segments);
    data.regionArea.forEach((area, l) => near(area, expected.regionArea[l], 1e-12));
  }
});

test('with a diagram that can be asked and changed, and outlives the iterations that follow', async () => {
  const diagrams = [];
  for await (const { iteration, sites: moved, data, diagram } of mesh.cvt(sites, {
    iterations: 3,
    diagrams: true,
  })) {
    assert.equal(diagram.data, data);
    assert.equal(diagram.sites, moved);
    assert.equal(diagram.metric, 'exact');
    diagrams.push({ iteration, diagram });
  }
  assert.equal(diagrams.length, 4);
  for (const { diagram } of diagrams) {
    const expected = await mesh.voronoi(diagram.sites);
    const { label, distance } = await diagram.locate({ vertex: [0, 40, 80] });
    const wanted = await expected.locate({ vertex: [0, 40, 80] });
    assert.deepEqual(label, wanted.label);
    distance.forEach((d, i) => near(d, wanted.distance[i], 1e-12));
    assert.equal(
      (await diagram.dual()).vertexLabel.length,
      (await expected.dual()).vertexLabel.length,
    );
    const { label: added } = await diagram.insertSite({ vertex: [40] });
    assert.equal(added, 12);
    assert.equal(diagram.regions.length, 13);
    diagram.dispose();
  }
});

test('by the metric that is asked for', async () => {
  const states = await collect(mesh.cvt(sites, { iterations: 2, metric: 'dgpc', diagrams: true }));
  const [, { diagram }, last] = states;
  assert.equal(diagram.metric, 'dgpc');
  assert.ok(last.energy < states[0].energy);
});

test('fixed sites stay, others go where the density is', async () => {
  const density = Float64Array.from({ length: mesh.info.inputVertices }, (_, v) =>
    Math.exp(-8 * mesh.positions[3 * v]),
  );
  const states = await collect(mesh.cvt(sites, { density, fixedSites: [5] }));
  const last = states.at(-1).sites;
  assert.equal(last.face[5], sites.face[5]);
  assert.deepEqual(last.bary.slice(15, 18), sites.bary.slice(15, 18));
  assert.notDeepEqual(last.face, sites.face);
});

test('the density of a subdivided mesh may be given by the vertices from before', async () => {
  const arrays = grid(4);
  const density = Array.from({ length: 25 }, (_, v) => 1 + (v % 5));
  const finer = await gvd.mesh({ ...arrays, density }, { maxEdge: 0.1 });
  assert.ok(finer.info.inputVertices > 25);
  const last = async (density) => {
    const start = await finer.sampleSites(6, { density });
    return (await collect(finer.cvt(start, { density, iterations: 3 }))).at(-1);
  };
  const given = await last(density);
  assert.deepEqual(given, await last('attribute'));
  assert.deepEqual(given, await last(finer.density));
  assert.notDeepEqual(given.sites, (await last([])).sites);
});

test('points are those of the input, turned triangles too', async () => {
  const other = await gvd.mesh(withFlipped(octahedron(), 2));
  const [first] = await collect(other.cvt({ vertex: [0, 3] }, { iterations: 0 }));
  assert.equal(first.sites.face.length, 2);
});

test('leaving the loop, aborting and disposing end it', async () => {
  for await (const { iteration } of mesh.cvt(sites)) if (iteration === 2) break;

  const controller = new AbortController();
  const aborted = collect(mesh.cvt(sites, { iterations: 1000, signal: controller.signal }));
  controller.abort(new Error('enough'));
  await assert.rejects(aborted, /enough/);

  const states = mesh.cvt(sites);
  await states.next();
  await states.return();
  assert.deepEqual(await states.next(), { value: undefined, done: true });

  const disposed = await gvd.mesh(octahedron());
  disposed.dispose();
  await assert.rejects(collect(disposed.cvt({ vertex: [0] })), fails('disposed'));
});

test('densities and fixed sites that do not fit are refused', async () => {
  const refused = (options, message) =>
    assert.rejects(collect(mesh.cvt(sites, options)), fails('invalid-argument', message));
  await refused({ density: [1, 2] }, /the number of densities is 2/);
  await refused({ fixedSites: [12] }, /site 12/);
});

test('remesh: the sites given and some more, moved, with a valid dual', async () => {
  const sphere = await gvd.mesh(octahedron());
  for (const start of [{ vertex: [0, 3] }, await sphere.sampleSites(20)]) {
    const diagram = await sphere.remesh(start, { iterations: 5 });
    assert.ok(diagram.sites.face.length >= (start.vertex ?? start.face).length);
    assert.deepEqual(await diagram.violations(), []);
    assert.equal((await diagram.dual()).topology.eulerCharacteristic, 2);
  }
  await assert.rejects(sphere.remesh({ vertex: [0, 3] }, { maxAdded: 1 }), fails('too-few-sites'));
});

test('remesh: with a density, and sites that stay', async () => {
  const start = await mesh.sampleSites(30, { seed: 3 });
  const density = Float64Array.from({ length: mesh.info.inputVertices }, (_, v) =>
    Math.exp(-4 * mesh.positions[3 * v]),
  );
  const nearOrigin = async (options) => {
    const diagram = await mesh.remesh(start, { iterations: 20, ...options });
    const { position } = (await diagram.dual()).points;
    return diagram.sites.face.filter((_, i) => position[3 * i] < 0.3).length;
  };
  assert.ok((await nearOrigin({ density })) > 1.3 * (await nearOrigin({})));
  const { sites: moved } = await mesh.remesh(start, { iterations: 5, fixedSites: [3] });
  assert.deepEqual(moved.bary.subarray(9, 12), start.bary.subarray(9, 12));
  assert.notDeepEqual(moved.bary.subarray(12, 15), start.bary.subarray(12, 15));
});
