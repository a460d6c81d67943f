// SPDX-License-Identifier: MIT
//
// Attributes, properties and methods of the element: its sites and what is asked of them.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { browserForTests } from './browser.mjs';
import { elementPages, emptyPage } from './element_pages.mjs';

const browser = await browserForTests(elementPages);

suite('attributes and properties', () => {
  test('an edit without a model is refused, in a sentence', async () => {
    const viewer = await emptyPage(browser);
    const refusals = await viewer.page.evaluate(async () => {
      const element = document.createElement('geodesic-voronoi');
      document.body.append(element);
      const site = { face: 0, bary: [1, 0, 0] };
      const edits = [
        () => element.addSite(site),
        () => {
          element.sites = { face: [0], bary: [1, 0, 0] };
        },
        () => {
          element.density = [1];
        },
        () => element.sampleSites(5),
        () => element.playCvt(),
      ];
      return Promise.all(
        edits.map(async (edit) => {
          try {
            await edit();
            return 'nothing';
          } catch ({ message }) {
            return message;
          }
        }),
      );
    });
    assert.deepEqual(
      [...new Set(refusals)],
      ['There is no model to edit: wait for the event "load".'],
    );
  });

  test('properties take what attributes do, as React and Vue set them', async () => {
    const viewer = await emptyPage(browser);
    const made = await viewer.page.evaluate(async () => {
      const element = document.createElement('geodesic-voronoi');
      element.src = '/samples/torus.glb';
      element.sites = 12;
      element.layers = 'regions sites';
      element.exploded = '0.5';
      const drawn = new Promise((resolve) => element.addEventListener('diagram', resolve));
      document.body.append(element);
      await drawn;
      const { sites, layers, exploded } = element;
      element.setAttribute('layers', ['regions', 'dual']); // as Svelte does on a server
      return { count: sites.face.length, layers, exploded, inAttribute: element.layers };
    });
    const expected = { layers: ['regions', 'sites'], inAttribute: ['regions', 'dual'] };
    assert.deepEqual(made, { count: 12, exploded: 0.5, ...expected });
  });

  test('properties that are set to nothing, as React does when they go, remove their attributes', async () => {
    const viewer = await emptyPage(browser);
    const left = await viewer.page.evaluate(() => {
      const element = document.createElement('geodesic-voronoi');
      const given = {
        src: 'a.glb',
        sites: 12,
        layers: ['sites'],
        exploded: 1,
        cameraOrbit: '0deg 0deg 1%',
      };
      Object.assign(element, given);
      const names = element.getAttributeNames();
      const left = [undefined, null].map((nothing) => {
        for (const name of Object.keys(given)) element[name] = nothing;
        const still = element.getAttributeNames();
        Object.assign(element, given);
        return still;
      });
      return { names, left };
    });
    assert.deepEqual(left, {
      names: ['src', 'sites', 'layers', 'exploded', 'camera-orbit'],
      left: [[], []],
    });
  });

  test('sites that are asked for while a model is opened are sampled on it', async () => {
    const viewer = await emptyPage(browser);
    const count = await viewer.page.evaluate(async () => {
      const element = document.createElement('geodesic-voronoi');
      element.src = '/samples/torus.glb';
      document.body.append(element);
      const drawn = new Promise((resolve) => element.addEventListener('diagram', resolve));
      element.sites = 12;
      await Promise.race([drawn, new Promise((resolve) => setTimeout(resolve, 20_000))]);
      return element.sites.face.length;
    });
    assert.equal(count, 12);
  });

  test('sites that are asked for while the first ones are sampled replace them', async () => {
    const viewer = await emptyPage(browser);
    const { count, steps } = await viewer.page.evaluate(async () => {
      const element = document.createElement('geodesic-voronoi');
      const steps = [];
      const others = ({ detail: { totalProgress } }) => {
        if (totalProgress <= 0.8 || element.loaded) return; // not being sampled yet, or no more
        steps.push('sampled');
        element.sites = 12;
      };
      element.addEventListener('progress', others);
      element.addEventListener('load', () => steps.push('opened'));
      element.addEventListener('sites-change', ({ detail }) => {
        if (detail.canUndo) steps.push('can be undone');
      });
      const drawn = new Promise((resolve) => element.addEventListener('diagram', resolve));
      element.sites = 7;
      element.src = '/samples/torus.glb';
      document.body.append(element);
      await drawn;
      return { count: element.sites.face.length, steps: [...new Set(steps)] };
    });
    assert.equal(count, 12);
    assert.deepEqual(steps, ['sampled', 'opened']);
  });

  test('a refused number of sites changes nothing that is under way', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const placed = await viewer.evaluate(async (viewer) => {
      viewer.sites = { face: [0, 5, 9], bary: [1, 0, 0, 1, 0, 0, 1, 0, 0] };
      viewer.setAttribute('sites', 'many');
      await new Promise((resolve) => viewer.addEventListener('error', resolve, { once: true }));
      await new Promise((resolve) => viewer.addEventListener('diagram', resolve, { once: true }));
      return viewer.sites.face.length;
    });
    assert.equal(placed, 3);
    assert.equal(await viewer.evaluate((viewer) => viewer.getAttribute('sites')), '12');
    const iterations = await viewer.evaluate(async (viewer) => {
      const iterations = [];
      await new Promise((resolve) => {
        viewer.addEventListener('cvt-iteration', ({ detail: { iteration } }) => {
          if (iterations.push(iteration) === 3) viewer.setAttribute('sites', 'many');
          if (iterations.length === 8) resolve();
        });
        viewer.playCvt();
      });
      return iterations;
    });
    assert.deepEqual(iterations, [...iterations.keys()]);
  });

  test('a number of sites that is taken back at once leaves an added site', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => {
        viewer.addSite({ face: 0, bary: [1, 0, 0] });
        viewer.setAttribute('sites', 20);
        viewer.setAttribute('sites', 12);
      }),
    );
    assert.equal(await viewer.siteCount(), 13);
  });

  test('a cancel between two edits leaves the sites of the diagram that is shown', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const place = (face) => ({ face, bary: [1, 0, 0] });
    const edit = (face) => viewer.evaluate((viewer, place) => viewer.addSite(place), place(face));
    await viewer.after('diagram', () => edit(7)); // whole, and then changed by what differs
    await viewer.evaluate(
      (viewer, [first, second]) => {
        viewer.moveSite(0, first);
        viewer.addSite(second);
        viewer.cancel();
      },
      [place(900), place(9000)],
    );
    await viewer.settled();
    const shown = await viewer.evaluate(({ diagram }) => [...diagram.sites.face]);
    assert.deepEqual((await viewer.sites()).face, shown);
    assert.equal(shown.length, 13);
  });

  test('sites that replace those of a tessellation can be replaced by as many as before', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.evaluate(async (viewer) => {
      const iteration = () =>
        new Promise((done) => viewer.addEventListener('cvt-iteration', done, { once: true }));
      viewer.setAttribute('cvt-iterations', 1000);
      viewer.playCvt();
      await iteration();
      viewer.sites = 20;
      while (viewer.sites.face.length !== 20) await iteration();
      viewer.pauseCvt();
    });
    await viewer.settled();
    await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('sites', 'many')),
    );
    assert.equal(await viewer.evaluate((viewer) => viewer.getAttribute('sites')), '20');
    await viewer.after('diagram', () => viewer.set({ sites: 12 }));
    assert.equal(await viewer.siteCount(), 12);
  });

  test('labels whose sites were removed from a diagram are no sites', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const sites = { face: [3, -1, 9], bary: [1, 0, 0, 0, 0, 0, 1, 0, 0] };
    await viewer.after('diagram', () => viewer.set({ sites }));
    assert.deepEqual(await viewer.sites(), { face: [3, 9], bary: [1, 0, 0, 1, 0, 0] });
  });

  test('properties may be set before the script has come', async () => {
    const viewer = await browser.visit({ path: 'early.html' });
    await viewer.page.waitForFunction(
      () => document.querySelector('geodesic-voronoi').status === 'ready',
    );
    assert.equal(await viewer.siteCount(), 7);
    assert.deepEqual(await viewer.evaluate(({ layers }) => layers), ['regions', 'dual']);
    assert.equal(await viewer.evaluate(({ cameraOrbit }) => cameraOrbit), '30deg 75deg 120%');
    await viewer.set({ layers: ['regions'] });
    assert.equal(await viewer.evaluate((viewer) => viewer.getAttribute('layers')), 'regions');
  });

  test('sites that are set before the script has come are refused as without a model', async () => {
    const viewer = await browser.visit({ path: 'early_sites.html' });
    await viewer.page.waitForFunction(() => document.querySelector('[status="empty"]'));
    const [complaint] = viewer.complaints.splice(0);
    assert.match(complaint, /There is no model to edit: wait for the event "load"/);
    assert.equal(await viewer.evaluate((viewer) => viewer.getAttribute('sites')), '3');
  });

  test('a tessellation plays on if the mesh cannot be made otherwise', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const status = await viewer.evaluate(async (viewer) => {
      const next = (type) =>
        new Promise((done) => viewer.addEventListener(type, done, { once: true }));
      viewer.setAttribute('cvt-iterations', 100000);
      viewer.playCvt();
      await next('cvt-iteration');
      viewer.setAttribute('weld', 'tight');
      await next('error');
      const { cvtStatus } = viewer;
      viewer.pauseCvt();
      return cvtStatus;
    });
    assert.equal(status, 'running');
  });

  test('a number that is refused is named by its attribute', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const refusal = async (name, value) => {
      const { message } = await viewer.after('error', () =>
        viewer.evaluate((viewer, [name, value]) => viewer.setAttribute(name, value), [name, value]),
      );
      assert.equal(await viewer.siteCount(), 12, 'all is as before');
      return message;
    };
    assert.match(await refusal('sites', 'abc'), /^The sites cannot be placed: sites is "abc", not/);
    assert.match(await refusal('sites', '-5'), /^The sites cannot be placed: sites is -5, not/);
    assert.match(await refusal('per-component', '0.5'), /: per-component is 0.5, not an integer/);
    assert.match(await refusal('max-edge', '2'), /: max-edge is 2, not a number/);
    assert.match(await refusal('min-component', '-1'), /: min-component is -1, not an integer/);
    assert.match(await refusal('seed', 'x'), /seed is "x", not an integer/);
    assert.match(await refusal('weld', 'tight'), /weld is "tight", not a number/);
    assert.match(await refusal('detail', 'fine'), /detail is "fine", not an integer/);
  });

  test('what a listener changes when something is refused stays', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const instead = (name, refused, other) =>
      viewer.after('diagram', () =>
        viewer.evaluate(
          (viewer, [name, refused, other]) => {
            viewer.addEventListener('error', () => viewer.setAttribute(name, other), {
              once: true,
            });
            viewer.setAttribute(name, refused);
          },
          [name, refused, other],
        ),
      );
    assert.equal((await instead('metric', 'round', 'dgpc')).metric, 'dgpc');
    assert.equal((await instead('sites', 'many', '7')).regions, 7);
  });

  test('a site that is nowhere is refused, and the diagram is there as before', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const message = await viewer.evaluate(async (viewer) => {
      const error = new Promise((resolve) => viewer.addEventListener('error', resolve));
      viewer.addSite({ face: 1e9, bary: [1, 0, 0] });
      return (await error).detail.message;
    });
    assert.match(
      message,
      /^The diagram cannot be made: site 12: there is no triangle 1000000000\.$/,
    );
    await viewer.settled();
    assert.equal(await viewer.siteCount(), 12);
    assert.equal(await viewer.regionCount(), 12);
  });

  test('what is no place, no site, no command and no address is refused, in a sentence', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const refusals = await viewer.evaluate((viewer) => {
      const edits = [
        () => viewer.addSite(),
        () => viewer.addSite({ face: 1 }),
        () => viewer.moveSite(0),
        () => viewer.moveSite(0, { face: 1, bary: [1, 0] }),
        () => viewer.addSite({ face: 1.5, bary: [1, 0, 0] }),
        () => (viewer.sites = { face: [Number.NaN], bary: [1, 0, 0] }),
        () => viewer.removeSite(12),
        () => viewer.moveSite(-1, { face: 0, bary: [1, 0, 0] }),
        () => viewer.perform('turn'),
        () => viewer.perform('constructor'),
        () => viewer.loadFiles('own.obj'),
        () => viewer.regionColour(0.5) ?? 'no colour',
      ];
      return edits.map((edit) => {
        try {
          return edit();
        } catch ({ message }) {
          return message;
        }
      });
    });
    assert.deepEqual(refusals, [
      ...Array(6).fill(
        'A place is { face, bary }, with the index of a triangle and three coordinates.',
      ),
      'There is no site 12: the number of sites is 12.',
      'There is no site -1: the number of sites is 12.',
      'There is no command “turn”.',
      'There is no command “constructor”.',
      'Files are a File, a list of these, or an object of files by their paths.',
      'no colour',
    ]);
    const { message } = await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.load('http://[')),
    );
    assert.equal(message, '“http://[” is not an address.');
    const unaddressed = await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.load('/unaddressed.gltf')),
    );
    assert.equal(unaddressed.message, '“http://[” is not an address beside a model at “http:…”.');
    const refusal = await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.sampleSites(-5)),
    );
    assert.match(refusal.message, /^The sites cannot be placed: .*-5/);
    assert.equal(await viewer.siteCount(), 12);
  });
});
