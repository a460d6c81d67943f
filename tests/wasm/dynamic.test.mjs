// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { load } from 'geodesic-voronoi';
import { bumpySphere, pointAt, presentSites } from './meshes.mjs';

for (const metric of ['exact', 'dgpc'])
  describe(`sites that come, go and move, ${metric}`, () => {
    let library;
    let mesh;

    before(async () => {
      library = await load();
      mesh = await library.mesh(bumpySphere(24, 36));
    });
    after(() => library.dispose());

    /** The diagram of the sites there are, and the label that each of them has in `diagram`. */
    const computedAnew = async (diagram) => {
      const { sites, labels } = presentSites(diagram.sites);
      return { anew: await mesh.voronoi(sites, { metric }), labels };
    };

    const close = (a, b) => Math.abs(a - b) <= 1e-12 * mesh.info.area;

    /** What identifies a diagram, whatever the order of its parts. */
    const summary = ({ data, regions }, labels) => ({
      faceLabel: data.faceLabel.map((label) => (label < 0 ? label : labels[label])),
      points: data.points.face.length,
      loops: Array.from(data.loops.label, (label) => labels[label]).sort((a, b) => a - b),
      steps: data.loops.points.length,
      arcs: Array.from({ length: data.arcs.labels.length / 2 }, (_, i) =>
        [labels[data.arcs.labels[2 * i]], labels[data.arcs.labels[2 * i + 1]]].join(),
      ).sort(),
      segments: data.segments.face.length,
      voronoiPoints: data.voronoiPoints.point.length,
      cells: Array.from(
        data.cells.face,
        (face, i) => `${face}:${labels[data.cells.label[i]]}`,
      ).sort(),
      corners: data.cells.points.length,
      neighbours: regions
        .filter(({ label }) => labels[label] !== undefined)
        .map(({ neighbours }) => neighbours.map((label) => labels[label]))
        .filter((list, _, all) => all.length > 0 && list.length > 0),
    });

    const assertUpToDate = async (diagram) => {
      const { anew, labels } = await computedAnew(diagram);
      const own = [...diagram.sites.face.keys()];
      assert.deepEqual(summary(diagram, own), summary(anew, labels));
      labels.forEach((label, i) =>
        assert.ok(close(diagram.regions[label].area, anew.regions[i].area), `area of ${label}`),
      );
      const probes = await mesh.sampleSites(50, { seed: 9 });
      const [known, expected] = await Promise.all([diagram.locate(probes), anew.locate(probes)]);
      assert.deepEqual(
        [...known.label],
        Array.from(expected.label, (label) => labels[label]),
      );
      anew.dispose();
    };

    it('gives the diagram of the present sites after every change', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(30), { metric });
      const places = await mesh.sampleSites(24, { seed: 5 });
      for (let i = 0; i < 24; i += 3) {
        const { label } = await diagram.insertSite(pointAt(places, i));
        assert.equal(diagram.sites.face[label], places.face[i]);
        await assertUpToDate(diagram);
        await diagram.moveSite((7 * i) % 30, pointAt(places, i + 1));
        await assertUpToDate(diagram);
        await diagram.removeSite(i % 2 ? label : (5 * i + 1) % 30);
        await assertUpToDate(diagram);
        await diagram.insertSite(pointAt(places, i + 2));
      }
      diagram.dispose();
    });

    it('merges several changes at once', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(12), { metric });
      const places = await mesh.sampleSites(6, { seed: 5 });
      await Promise.all([0, 1, 2, 3].map((i) => diagram.moveSite(2 * i, pointAt(places, i))));
      await diagram.removeSite(11);
      await assertUpToDate(diagram);
      diagram.dispose();
    });

    it('calls are carried out in their order, whether awaited or not', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(12), { metric });
      const place = await mesh.sampleSites(1, { seed: 5 });
      const before = diagram.locate(place);
      void diagram.insertSite(place);
      const after = diagram.locate(place);
      const path = diagram.path(place);
      const partition = diagram.partition();
      // A vertex has to be looked up first; what comes after it waits for that.
      const vertex = diagram.locate({ vertex: 7 });
      void diagram.moveSite(12, { vertex: 7 });
      assert.notEqual((await before).label[0], 12);
      assert.equal((await after).label[0], 12);
      assert.equal((await path).length, 0);
      assert.equal((await partition).regions.area.length, 13);
      assert.ok((await vertex).distance[0] > 0);
      assert.equal((await diagram.locate({ vertex: 7 })).distance[0], 0);
      diagram.dispose();
    });

    it('arguments are copied at the call, and refused at once if they are wrong', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(12), { metric });
      const places = await mesh.sampleSites(3, { seed: 5 });
      const used = pointAt(places, 0);
      const changes = [];
      for (let i = 0; i < 3; ++i) {
        used.face.set(places.face.subarray(i, i + 1));
        used.bary.set(places.bary.subarray(3 * i, 3 * i + 3));
        changes.push(diagram.insertSite(used));
      }
      const ended = [];
      changes[0].then(() => ended.push('change'));
      await diagram.moveSite(0, { vertex: [1, 2] }).catch(() => ended.push('misuse'));
      await Promise.all(changes);
      assert.deepEqual(ended, ['misuse', 'change']);
      assert.deepEqual([...diagram.sites.face.subarray(12)], [...places.face]);
      assert.deepEqual([...diagram.sites.bary.subarray(36)], [...places.bary]);
      diagram.dispose();
    });

    it('a repair is one of the sites as the changes before it leave them', async () => {
      const diagram = await mesh.voronoi({ vertex: [0, 1] }, { metric });
      void diagram.insertSite({ vertex: 100 });
      const repairing = diagram.repair();
      const inserting = diagram.insertSite({ vertex: 200 });
      const repaired = await repairing;
      await inserting;
      const sites = await mesh.voronoi({ vertex: [0, 1, 100] }, { metric });
      const expected = await sites.repair();
      assert.deepEqual(repaired.sites, expected.sites);
      for (const each of [diagram, repaired, sites, expected]) each.dispose();
    });

    it('all arrays are fetched in their turn, and are those that are put together here', async () => {
      const sites = await mesh.sampleSites(12);
      const places = await mesh.sampleSites(4, { seed: 5 });
      const [fetched, together] = [
        await mesh.voronoi(sites, { metric }),
        await mesh.voronoi(sites, { metric }),
      ];
      assert.equal(await fetched.fetchData(), fetched.data, 'nothing has changed');
      for (const diagram of [fetched, together]) {
        for (let i = 0; i < 3; ++i) void diagram.moveSite(i, pointAt(places, i));
      }
      const before = fetched.regions;
      const fetching = fetched.fetchData();
      const inserted = fetched.insertSite(pointAt(places, 3));
      const data = await fetching;
      assert.equal(data.siteCount, 12, 'what was asked for later is not in it');
      const changed = await together.removeSite(11);
      assert.equal(changed.label, 11);
      await inserted;
      await assertUpToDate(fetched);
      await fetched.removeSite(12);
      await fetched.removeSite(11);
      const own = [...sites.face.keys()];
      await fetched.fetchData();
      assert.deepEqual(summary(fetched, own), summary(together, own));
      assert.notEqual(fetched.regions, before, 'regions are of the new points');
      fetched.regions.forEach(({ label, area, loops }) => {
        assert.ok(close(area, together.regions[label].area));
        assert.equal(
          loops.flatMap((loop) => [...loop]).length,
          together.regions[label].loops.flatMap((loop) => [...loop]).length,
        );
      });
      for (const diagram of [fetched, together]) diagram.dispose();
    });

    it('carries changes out in the order in which they are asked for', async () => {
      const diagram = await mesh.voronoi({ vertex: [0, 100] }, { metric });
      const inserted = diagram.insertSite({ vertex: [300] });
      const removed = diagram.removeSite(2);
      assert.equal((await inserted).label, 2);
      await removed;
      assert.equal(diagram.sites.face.length, 2);
      assert.equal(diagram.regions.length, 2);
      await assertUpToDate(diagram);
      diagram.dispose();
    });

    it('a label that is free has an empty region; at the end it does not count', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(40), { metric });
      await diagram.removeSite(38);
      assert.equal(diagram.sites.face[38], -1);
      assert.equal(diagram.regions.length, 40);
      assert.equal(diagram.regions[38].area, 0);
      assert.ok(!(await diagram.dual()).vertexLabel.includes(38));
      await diagram.removeSite(39);
      assert.equal(diagram.sites.face.length, 38);
      assert.equal(diagram.data.siteCount, 38);
      await assertUpToDate(diagram);

      const { anew } = await computedAnew(diagram);
      const sizes = ({ vertexLabel, faces }) => [vertexLabel.length, faces.offset.length];
      assert.deepEqual(sizes(await diagram.dual()), sizes(await anew.dual()));
      assert.equal((await diagram.partition()).regions.area.length, 38);
      assert.equal((await diagram.insertSite({ vertex: [300] })).label, 38);
      await assertUpToDate(diagram);
      diagram.dispose();
    });

    it('names what has changed and nothing far from it', async () => {
      const diagram = await mesh.voronoi(await mesh.sampleSites(200), { metric });
      const before = diagram.data;
      const { label, labels, faces, part } = await diagram.moveSite(3, { vertex: [200] });
      assert.equal(label, 3);
      // With dgpc, all labels that spread near paths along edges that have changed start anew.
      assert.ok(labels.includes(3) && labels.length < (metric === 'exact' ? 50 : 150));
      assert.equal(part.faceLabel.length, faces.length);
      assert.equal(part.regionArea.length, labels.length);
      const changed = new Set(faces);
      diagram.data.faceLabel.forEach((now, face) => {
        if (!changed.has(face)) assert.equal(now, before.faceLabel[face]);
      });
      diagram.dispose();
    });

    it('lets all sites go and others come', async () => {
      const diagram = await mesh.voronoi({ vertex: [5] }, { metric });
      await diagram.removeSite(0);
      assert.ok(diagram.data.faceLabel.every((label) => label === -1));
      await diagram.insertSite({ vertex: [9] });
      await assertUpToDate(diagram);
      diagram.dispose();
    });

    it('refuses what cannot be, and nothing is lost', async () => {
      const diagram = await mesh.voronoi({ vertex: [0, 100] }, { metric });
      const reason = (code, message) => ({ code, message });
      await assert.rejects(diagram.removeSite(7), reason('invalid-argument', 'there is no site 7'));
      await assert.rejects(diagram.moveSite(-1, { vertex: [0] }), { code: 'invalid-argument' });
      await assert.rejects(diagram.insertSite({ vertex: [0, 1] }), { code: 'invalid-argument' });
      await assert.rejects(diagram.insertSite({ vertex: [1e6] }), { code: 'invalid-point' });
      await assert.rejects(diagram.insertSite({ face: [0], bary: [NaN, 0, 0] }), {
        code: 'invalid-point',
      });
      await assertUpToDate(diagram);
      diagram.dispose();
      await assert.rejects(diagram.removeSite(0), { code: 'disposed' });
    });
  });
