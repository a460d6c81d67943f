// SPDX-License-Identifier: MIT
//
// Long work is done in slices: the thread has its turn in between, callers hear how far it is, and may give
// up. What comes of it is the same.

import assert from 'node:assert/strict';
import { afterEach, test } from 'node:test';
import { load } from 'geodesic-voronoi';
import { bumpySphere, glb } from './meshes.mjs';

const gvd = await load();
const mesh = await gvd.mesh(bumpySphere(40, 60));
const diagram = await mesh.voronoi(await mesh.sampleSites(20));

/** What is told of a mesh: objects of two meshes differ. */
const opened = async (source, options) => {
  const { info, positions, indices } = await gvd.mesh(source, options);
  return { info, positions, indices };
};

const tasks = {
  'a mesh': (options) => opened(bumpySphere(40, 60), options),
  'a glTF': (options) => opened(glb(bumpySphere(40, 60)), options),
  'a mesh with a tolerance': (options) =>
    opened(bumpySphere(40, 60), { weld: 1e-4, minComponent: 3, ...options }),
  'a mesh of subdivided triangles': (options) =>
    opened(bumpySphere(40, 60), { maxEdge: 0.01, ...options }),
  'random points': (options) => mesh.sampleSites(1000, options),
  'random points by density': (options) =>
    mesh.sampleSites(1000, {
      density: Float64Array.from(mesh.positions.subarray(0, mesh.info.inputVertices), Math.abs),
      ...options,
    }),
  'farthest points': (options) => mesh.sampleSites(40, { sampling: 'farthest', ...options }),
  'farthest points by radius': (options) => mesh.sampleSites({ radius: 0.5 }, options),
  'a Poisson disk': (options) => mesh.sampleSites(40, { sampling: 'poisson', ...options }),
  'a Poisson disk by radius': (options) =>
    mesh.sampleSites({ radius: 0.5 }, { sampling: 'poisson', ...options }),
  'sites in the worst region': (options) => mesh.sampleSites(6, { sampling: 'size', ...options }),
  'farthest points on each component': (options) =>
    mesh.sampleSites(40, { sampling: 'farthest', perComponent: 1, ...options }),
  'a diagram': async (options) => (await mesh.voronoi(diagram.sites, options)).data,
  'a diagram in detail': async (options) =>
    (await mesh.voronoi(diagram.sites, { detail: 2, ...options })).data,
  'a diagram of places': async (options) =>
    (await mesh.voronoi({ position: mesh.positions.subarray(0, 900) }, options)).data,
  distances: (options) => mesh.distances(diagram.sites, options),
  'a path': (options) => mesh.path({ vertex: 0 }, { vertex: 900 }, options),
  'a remesh': async (options) =>
    (await mesh.remesh(diagram.sites, { iterations: 3, ...options })).data,
  'a repair': async (options) => (await (await mesh.voronoi({ vertex: 0 })).repair(options)).data,
  'the closest points of places': (options) =>
    mesh.closestPoints(
      Float64Array.from({ length: 300 }, (_, i) => Math.sin(i)),
      options,
    ),
  'the places of points': (options) =>
    mesh.positionsOf({ face: Array(4000).fill(5), bary: Array(12000).fill(1 / 3) }, options),
  'a density by curvature': (options) => mesh.curvatureDensity(options),
  'points located': (options) =>
    diagram.locate({ vertex: Array.from({ length: 500 }, (_, v) => v) }, options),
  'a place in the worst region': async (options) =>
    (await mesh.voronoi(diagram.sites)).worstRegionPoint('distortion', options),
  'a diagram after a change': async (options) => {
    const own = await mesh.voronoi(diagram.sites);
    await own.insertSite({ vertex: [7] });
    return own.fetchData(options);
  },
  'a partition': (options) => diagram.partition(options),
  'a dual': (options) => diagram.dual(options),
  'the regions as polygons': (options) => diagram.dual({ primal: true, ...options }),
  'the paths of a dual': (options) => diagram.dualPaths(options),
  'violations of a dual': (options) => diagram.violations(options),
  'the quality of a dual': (options) => diagram.remeshQuality(options),
};

/** A clock that is always later than the end of a slice: how fast the machine is must not matter. */
let clock = 0;
const now = performance.now;
const hurry = () => {
  performance.now = () => (clock += 1000);
};
afterEach(() => {
  performance.now = now;
});

for (const [name, task] of Object.entries(tasks)) {
  test(`${name}: in slices, as at one go, and given up after one of them`, async () => {
    performance.now = () => 0; // no slice ends
    const expected = await task({});

    hurry();
    const shares = [];
    let turns = 0;
    let turn = setImmediate(function next() {
      ++turns;
      turn = setImmediate(next);
    });
    const result = await task({ onProgress: (share) => shares.push(share) });
    clearImmediate(turn);
    assert.deepEqual(result, expected);
    assert.ok(turns > 0, 'nothing else had its turn');
    assert.ok(shares.length > 2, `${shares}`);
    shares.forEach((share, i) => {
      assert.ok(share >= (shares[i - 1] ?? 0) && share <= 1, `${shares}`);
    });
    assert.equal(shares.at(-1), 1);

    const control = new AbortController();
    const heard = [];
    const givenUp = task({
      signal: control.signal,
      onProgress: (share) => {
        heard.push(share);
        control.abort(new Error('enough'));
      },
    });
    await assert.rejects(givenUp, { message: 'enough' });
    assert.equal(heard.length, 1);

    performance.now = now;
    assert.deepEqual(await task({}), expected);
  });
}

test('the share of a diagram in detail goes on while it is traced', async () => {
  hurry();
  const shares = [];
  await mesh.voronoi(diagram.sites, { detail: 2, onProgress: (share) => shares.push(share) });
  assert.ok(shares.filter((share) => share > 0.2 && share < 1).length > 10, `${shares}`);
});

test('the texts of a result are copied in slices', async () => {
  const triangles = Array.from({ length: 99 }, (_, i) => [i, 0, 0, i + 0.5, 0, 0, i, 0.5, 0]);
  const apart = await gvd.mesh({ positions: triangles.flat() });
  const withOneSite = await apart.voronoi({ vertex: 0 });
  hurry();
  const shares = [];
  const violations = await withOneSite.violations({ onProgress: (share) => shares.push(share) });
  assert.equal(violations.filter(({ kind }) => kind === 'unreachable').length, 98);
  assert.ok(shares.filter((share) => share === 1).length > 2 * 98, `${shares}`);
});

test('a change of a site: in slices, as at one go, and not given up when it has begun', async () => {
  const change = async (options) => {
    const own = await mesh.voronoi(diagram.sites);
    const { labels, faces } = await own.insertSite({ vertex: [7] }, options);
    return { labels, faces, loops: own.data.loops };
  };
  performance.now = () => 0; // no slice ends
  const expected = await change({});

  hurry();
  const control = new AbortController();
  const shares = [];
  const onProgress = (share) => {
    shares.push(share);
    control.abort();
  };
  assert.deepEqual(await change({ onProgress, signal: control.signal }), expected);
  assert.ok(shares.length > 2, `${shares}`);
  shares.forEach((share, i) => {
    assert.ok(share >= (shares[i - 1] ?? 0) && share <= 1, `${shares}`);
  });
});

test('a diagram that is disposed, or a library, ends the work on it', async () => {
  hurry();
  const own = await mesh.voronoi(diagram.sites);
  const partition = own.partition({ onProgress: () => own.dispose() });
  await assert.rejects(partition, { code: 'disposed' });

  const library = await load();
  const other = library.mesh(bumpySphere(40, 60), { onProgress: () => library.dispose() });
  await assert.rejects(other, { code: 'disposed' });
});

test('what waits for its turn is given up at once, and what comes after it waits on', async () => {
  hurry();
  const own = await mesh.voronoi(diagram.sites);
  const queues = [
    [() => own.partition(), (task) => own.dual(task), () => own.violations()],
    [
      (task) => mesh.curvatureDensity(task),
      (task) => mesh.distances(own.sites, task),
      () => mesh.curvatureDensity(),
    ],
  ];
  for (const [first, second, third] of queues) {
    const order = [];
    const control = new AbortController();
    const long = first({}).finally(() => order.push('first'));
    const waiting = second({ signal: control.signal }).catch(({ message }) => order.push(message));
    const last = third().finally(() => order.push('third'));
    control.abort(new Error('given up'));
    await Promise.all([long, waiting, last]);
    assert.deepEqual(order, ['given up', 'first', 'third']);
  }
});

test('what is asked of a diagram while it is at work has its turn after that', async () => {
  hurry();
  const own = await mesh.voronoi(diagram.sites);
  const order = [];
  const partition = own.partition().finally(() => order.push('partition'));
  const change = own.removeSite(19).finally(() => order.push('change'));
  assert.equal((await partition).regions.area.length, 20);
  assert.equal((await change).label, 19);
  assert.deepEqual(order, ['partition', 'change']);
  assert.equal((await own.partition()).regions.area.length, 19);
});
