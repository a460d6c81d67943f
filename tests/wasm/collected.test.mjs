// SPDX-License-Identifier: MIT
//
// What the garbage collector may free, and what not.

import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { load } from 'geodesic-voronoi';
import { grid } from './meshes.mjs';

setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc');

const gvd = await load();
after(() => gvd.dispose());

test('a mesh or a diagram that nobody refers to any more stays until its call is done', async (t) => {
  const collecting = setInterval(collect, 1);
  t.after(() => clearInterval(collecting));
  const mesh = await gvd.mesh(grid(60));
  const sites = await mesh.sampleSites(40);
  const places = Float64Array.from({ length: 90_000 }, (_, i) => (i % 97) / 97);
  const lengths = [];
  for (let i = 0; i < 3; ++i) {
    const closest = await (await gvd.mesh(grid(60))).closestPoints(places);
    const parts = await (await mesh.voronoi(sites)).partition();
    lengths.push(closest.face.length, parts.regions.area.length);
  }
  assert.deepEqual(lengths, [30_000, 40, 30_000, 40, 30_000, 40]);
});

test('a mesh or a diagram whose call is aborted just as it ends is freed', async (t) => {
  const { now } = performance;
  performance.now = () => 0; // all work is done in one slice
  t.after(() => (performance.now = now));
  const mesh = await gvd.mesh(grid(40));
  const sites = await mesh.sampleSites(10);
  const calls = [(task) => gvd.mesh(grid(40), task), (task) => mesh.voronoi(sites, task)];
  for (const call of calls) {
    const abort = async (count) => {
      for (let i = 0; i < count; ++i) {
        const control = new AbortController();
        const called = call({ signal: control.signal }).then(
          (opened) => opened.dispose(),
          () => {},
        );
        for (let turn = i % 4; turn > 0; --turn) await undefined;
        control.abort();
        await called;
      }
      return process.memoryUsage().external;
    };
    const before = await abort(40);
    const added = (await abort(400)) - before;
    assert.ok(added < 5e6, `${call}: ${added} bytes more`);
  }
});

test('a tessellation that is left without a word is freed, and one that its listener ends', async () => {
  const mesh = await gvd.mesh(grid(40));
  const sites = await mesh.sampleSites(40);
  const fail = () => {
    throw new Error('enough');
  };
  const tessellations = [
    () => mesh.cvt(sites).next(),
    () =>
      mesh
        .cvt(sites, { diagrams: true, onProgress: fail })
        .next()
        .catch(() => {}),
  ];
  for (const tessellate of tessellations) {
    const begin = async (count) => {
      for (let i = 0; i < count; ++i) {
        await tessellate();
        if (i % 5 > 0) continue;
        collect();
        await pause(1); // the time to free what was collected
      }
      return process.memoryUsage().external;
    };
    const before = await begin(30);
    const added = (await begin(90)) - before;
    assert.ok(added < 5e6, `${tessellate}: ${added} bytes more`);
  }
});
