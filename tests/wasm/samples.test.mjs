// SPDX-License-Identifier: MIT
//
// What has to hold on every sample model of the page: the parts of a partition are the surface, and
// repair makes a valid dual.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { load, partitionGlb } from 'geodesic-voronoi';
import { makeSamples } from '../../web/page/samples/samples.mjs';
import { areaOf, assertValidGlb, listsOf, placedTriangles, surfaceOf, total } from './files.mjs';
import { near } from './expectations.mjs';
import { triples } from './meshes.mjs';
import { temporaryFolder } from './temporary_folder.mjs';

const siteCount = 30;

/** The meshes by their files' names. */
const samples = new Map();
const gvd = await load();
const folder = temporaryFolder();
makeSamples(folder);
for (const file of readdirSync(folder))
  samples.set(file, await gvd.mesh(readFileSync(join(folder, file))));

/** The share of its input triangle that a triangle has, negative if it is turned over. */
function shareOf({ triangles: { bary } }, t) {
  const [a, b, c, d, e, f, g, h, i] = bary.subarray(9 * t, 9 * t + 9);
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

test('there are surfaces of genus 0, 1 and more, with and without boundary', () => {
  const infos = [...samples.values()].map(({ info }) => info);
  assert.equal(infos.length, 9);
  const genera = infos.map(({ genus }) => genus);
  assert.ok(genera.includes(0) && genera.includes(1) && Math.max(...genera) > 1);
  assert.equal(new Set(infos.map(({ boundaryLoops }) => boundaryLoops > 0)).size, 2);
});

for (const metric of ['dgpc', 'exact']) {
  test(`the parts of every sample model are its surface, ${metric}`, async () => {
    for (const [file, mesh] of samples) {
      const { area, boundaryLoops, eulerCharacteristic, repairs } = mesh.info;
      const diagram = await mesh.voronoi(await mesh.sampleSites(siteCount), { metric });
      const partition = await diagram.partition();
      const { triangles, regions } = partition;
      const corners = triples(triangles.points);

      // Regions share their points: what is left open is the boundary of the model.
      const surface = surfaceOf(corners);
      assert.ok(surface.isOriented, file);
      assert.equal(surface.euler, eulerCharacteristic, file);
      assert.equal(surface.loops, boundaryLoops, file);

      // The right way round, or as the mesh builder turned it: all parts of a triangle alike.
      const isTurned = new Map();
      triangles.face.forEach((face, t) => {
        const share = shareOf(partition, t);
        assert.notEqual(share, 0, file);
        assert.equal(isTurned.get(face) ?? share < 0, share < 0, file);
        isTurned.set(face, share < 0);
      });
      const turned = [...isTurned.values()].filter(Boolean);
      assert.equal(turned.length, repairs.flippedTriangles, file);

      assert.equal(regions.area.length, siteCount);
      near(total([...regions.area]) / area, 1, 1e-12, `${file}, regions`);
      near(total(placedTriangles(partition).map(areaOf)) / area, 1, 1e-12, `${file}, triangles`);
    }
  });
}

test('from 30 sites, repair makes a valid dual of every sample model', async () => {
  for (const [file, mesh] of samples) {
    const { components, boundaryLoops, genus, eulerCharacteristic } = mesh.info;
    const diagram = await (await mesh.voronoi(await mesh.sampleSites(siteCount))).repair();
    assert.deepEqual(await diagram.violations(), [], file);
    const { topology, faces } = await diagram.dual();
    assert.ok(topology.isManifold, file);
    assert.deepEqual(
      [topology.components, topology.boundaryLoops, topology.genus, topology.eulerCharacteristic],
      [components, boundaryLoops, genus, eulerCharacteristic],
      file,
    );
    const surface = surfaceOf(listsOf(faces));
    assert.ok(surface.isOriented, file);
    assert.equal(surface.euler, eulerCharacteristic, file);
    assert.equal(surface.loops, boundaryLoops, file);
    await assertValidGlb(partitionGlb(await diagram.partition(), { mesh }));
  }
});
