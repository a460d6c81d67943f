// SPDX-License-Identifier: MIT
//
// Models that the element opens, and what becomes of those that it cannot.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { torus } from '../../web/page/samples/shapes.mjs';
import { meshObj } from '../wasm/model_files.mjs';
import { browserForTests } from './browser.mjs';
import { elementPages, emptyPage, model, tetrahedron } from './element_pages.mjs';

const browser = await browserForTests(elementPages);

/** How often a page has fetched a script. */
const timesFetched = (page, script) =>
  page.evaluate(async (script) => {
    await fetch('/icon.svg'); // what was asked for before is there, too
    const names = performance.getEntriesByType('resource').map(({ name }) => name);
    return names.filter((name) => name.endsWith(`/${script}`)).length;
  }, script);

/** In the page, gives a function after which the library's worker stops when it is called next. */
function prepareToStop() {
  let library;
  window.Worker = class extends Worker {
    constructor(url, options) {
      super(url, options);
      if (String(url).endsWith('/package/worker.js')) library = this;
    }
  };
  window.stopLibraryAtNextCall = () => {
    library.postMessage = function () {
      this.terminate();
      setTimeout(() => this.dispatchEvent(new ErrorEvent('error', { message: 'out of order' })));
    };
  };
}

suite('models of the element', () => {
  test('a diagram that cannot be made is told of on the view until there is one', async () => {
    const viewer = await emptyPage(browser);
    await viewer.evaluate(() => {
      const element = document.createElement('geodesic-voronoi');
      Object.assign(element, { src: '/samples/torus.glb', sites: 7 });
      element.setAttribute('metric', 'foo');
      document.body.append(element);
    });
    const message = viewer.page.locator('geodesic-voronoi [part="message"]');
    await message.filter({ hasText: 'metric is "foo", not one of exact, dgpc' }).waitFor();
    const setting = (name, value) =>
      viewer.evaluate((viewer, [name, value]) => viewer.setAttribute(name, value), [name, value]);
    await viewer.after('error', () => setting('detail', '99'));
    await viewer.after('error', () => setting('metric', 'exact'));
    await message.filter({ hasText: 'The diagram cannot be made: detail is 99' }).waitFor();
    await viewer.after('diagram', () => setting('detail', '1'));
    assert.ok(await message.isHidden());
    // What is shown then stays in view.
    await viewer.after('error', () => setting('metric', 'foo'));
    assert.ok(await message.isHidden());
  });

  test('a model that cannot be made as its attributes ask is made once they ask for something else', async () => {
    const viewer = await emptyPage(browser);
    await viewer.evaluate(() => {
      const element = document.createElement('geodesic-voronoi');
      Object.assign(element, { src: '/samples/torus.glb', sites: 7 });
      element.setAttribute('orientation', 'foo');
      document.body.append(element);
    });
    await viewer.page.waitForFunction(() => document.querySelector('[status="failed"]'));
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('orientation', 'keep')),
    );
    assert.equal(await viewer.regionCount(), 7);
  });

  test('what cannot be computed is told apart from what cannot be opened', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const refused = await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('metric', 'manhattan')),
    );
    assert.equal(refused.type, 'computefailure');
    assert.match(refused.message, /^The diagram cannot be made: .*[^.]\.$/);
    const sampled = await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('sampling', 'dense')),
    );
    assert.equal(sampled.type, 'computefailure');
    assert.match(sampled.message, /^The sites cannot be placed: .*[^.]\.$/);
  });

  test('a model that is too large is refused without advice that attributes cannot follow', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const { message } = await viewer.after('error', () => viewer.set({ src: '/vast.gltf' }));
    assert.match(message, /^vast\.gltf cannot be opened: .*16777216 vertices\.$/);
  });

  test('if a file that a model refers to cannot be had, the others are given up', async () => {
    const viewer = await browser.open({
      path: 'one.html',
      complaint: /404/,
      prepare: (page) => page.route('**/endless.bin', () => {}), // never answered
    });
    const endless = viewer.page.waitForEvent('requestfailed');
    const { message } = await viewer.after('error', () => viewer.set({ src: '/half.gltf' }));
    assert.match(message, /^nowhere\.bin cannot be fetched: the server answers 404\.$/);
    assert.match((await endless).url(), /endless\.bin$/);
  });

  test('limits on what a model may ask for are raised and lowered by an attribute', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const open = (limits) =>
      viewer.evaluate((viewer, limits) => {
        viewer.setAttribute('limits', limits);
        void viewer.load('/pentagon.obj');
      }, limits);
    for (const [limits, why] of [
      ['maxVertices=4', /has more than 4 vertices\.$/],
      ['vertices=9', /the name of a limit is "vertices", not/],
      ['maxVertices=3=4', /limits\.maxVertices is "3=4", not/],
      ['maxVertices', /limits\.maxVertices is "undefined", not/],
    ])
      assert.match((await viewer.after('error', () => open(limits))).message, why);
    await viewer.after('load', () => open('maxVertices=5, maxTriangles=3'));
    assert.equal(await viewer.evaluate(({ info }) => info.faces), 3);
  });

  test('a model that is given up is not made ready on the page in place of the worker', async () => {
    const { page } = await browser.visit({ path: 'unplaced.html' });
    await page.waitForFunction(() => document.querySelector('[status="failed"]'));
    assert.equal(
      await timesFetched(page, 'scene_arrays.js'),
      1,
      'only the worker needs that script',
    );
  });

  test('colours of a PLY file that are being read end with its model', async () => {
    const viewer = await browser.open({
      path: 'coloured.html',
      prepare: (page) =>
        page.addInitScript(() => {
          // The worker never gets to read them.
          window.asked = new Promise((asked) => {
            const { postMessage } = MessagePort.prototype;
            MessagePort.prototype.postMessage = function (message, ...options) {
              if (message.name === 'ply') asked();
              else postMessage.call(this, message, ...options);
            };
          });
        }),
    });
    await viewer.evaluate(async (viewer) => {
      viewer.layers = ['original'];
      await window.asked;
      await viewer.load('/samples/torus.glb');
    });
    assert.equal(
      await timesFetched(viewer.page, 'ply_surface.js'),
      0,
      'nothing reads them on the page',
    );
  });

  test('without the worker that prepares drawings, a sentence says why some do not come', async () => {
    const viewer = await browser.open({
      path: 'one.html',
      prepare: (page) =>
        page.addInitScript(() => {
          window.Worker = class extends Worker {
            constructor(url, options) {
              super(url, options);
              if (options.name === 'geodesic-voronoi-drawing') window.drawingWorker = this;
            }
          };
        }),
    });
    await viewer.page.evaluate(() => window.drawingWorker.dispatchEvent(new ErrorEvent('error')));
    const { type, message } = await viewer.after('error', () => viewer.set({ exploded: 0.5 }));
    assert.equal(type, 'computefailure');
    assert.match(message, /^The exploded view cannot be drawn: the worker .* has stopped/);
    const further = await viewer.after('error', () => viewer.set({ layers: ['distances'] }));
    assert.match(further.message, /^The distances cannot be drawn: the worker .* has stopped/);
  });

  test('a library that stops is followed by another: model, sites and density are there', async () => {
    const viewer = await browser.open({
      path: 'import-map.html',
      prepare: (page) => page.addInitScript(prepareToStop),
    });
    const state = () =>
      viewer.evaluate(({ sites, density }) => [...sites.face, ...sites.bary, ...(density ?? [])]);
    const moveSite = () =>
      viewer.evaluate((viewer) => viewer.moveSite(3, { face: 100, bary: [0.2, 0.3, 0.5] }));
    await viewer.after('density-change', () =>
      viewer.evaluate((viewer) => {
        viewer.density = new Float64Array(viewer.mesh.info.vertices).fill(1).with(0, 4);
      }),
    );
    const before = await state();
    await viewer.evaluate((viewer) => {
      window.stopLibraryAtNextCall();
      viewer.reopened = new Promise((resolve) => viewer.addEventListener('load', resolve));
    });
    const { type, message } = await viewer.after('error', moveSite);
    assert.equal(type, 'computefailure');
    assert.match(message, /^The diagram cannot be made: .* has stopped: out of order/);
    await viewer.evaluate(({ reopened }) => reopened.then(() => {}));
    await viewer.settled();
    assert.deepEqual(await state(), before);
    assert.equal(await viewer.regionCount(), 12);
    await viewer.after('diagram', moveSite);
    assert.notDeepEqual(await state(), before);

    // If the sites are those of the diagram that is shown, another one starts when they change.
    await viewer.evaluate(() => window.stopLibraryAtNextCall());
    await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('metric', 'dgpc')),
    );
    await viewer.after('diagram', () => viewer.set({ sites: 7 }));
    assert.equal(await viewer.regionCount(), 7);

    // Or when the mesh is to be made otherwise: its sites and density come from one like before.
    await viewer.evaluate(() => window.stopLibraryAtNextCall());
    await viewer.after('error', () =>
      viewer.evaluate((viewer) => viewer.setAttribute('metric', 'dgpc')),
    );
    const most = await viewer.evaluate(
      (viewer) =>
        new Promise((resolve, reject) => {
          const { vertices } = viewer.mesh.info;
          viewer.addEventListener('error', ({ detail }) => reject(detail));
          viewer.addEventListener('diagram', () => {
            if (viewer.mesh.info.vertices < vertices) resolve(Math.max(...viewer.density));
          });
          viewer.setAttribute('weld', '0.03');
        }),
    );
    assert.ok(most > 1, `the density is at most ${most}`);
    assert.equal(await viewer.regionCount(), 7);
  });

  test('a model that is given up when it has just been opened does not come', async () => {
    const viewer = await browser.open({ path: 'import-map.html' });
    const isThere = await viewer.evaluate(async (viewer) => {
      const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
      // Just before the session hears that all is there: the last that is waited for is the scene.
      const { all } = Promise;
      Promise.all = (list) => {
        const made = all.call(Promise, list);
        if (!/openMesh/.test(new Error().stack)) return made;
        const thenGiveUp = (done) => (value) => {
          done(value);
          queueMicrotask(() => viewer.cancel());
        };
        return { then: (done, fail) => made.then(thenGiveUp(done), fail) };
      };
      const isOpen = await viewer.loadFiles({ 'a.obj': new TextEncoder().encode(text) });
      Promise.all = all;
      return isOpen;
    });
    assert.equal(isThere, false);
    assert.equal(await viewer.regionCount(), 12);
  });

  test('a library that has stopped takes no other with it, however many requests it has left', async () => {
    const viewer = await browser.open({
      path: 'import-map.html',
      prepare: (page) => page.addInitScript(prepareToStop),
    });
    await viewer.evaluate(async (viewer) => {
      const { mesh } = viewer;
      const sampleSites = mesh.sampleSites.bind(mesh);
      mesh.sampleSites = async (...args) => {
        try {
          return await sampleSites(...args);
        } catch (error) {
          await new Promise((resolve) => setTimeout(resolve, 1)); // the model is being reopened
          throw error;
        }
      };
      const reopened = new Promise((resolve, reject) => {
        viewer.addEventListener('load', () => resolve());
        viewer.addEventListener('error', ({ detail: { type, message } }) => {
          if (type === 'loadfailure') reject(new Error(message));
        });
      });
      window.stopLibraryAtNextCall();
      void viewer.sampleSites(5);
      viewer.moveSite(3, { face: 100, bary: [0.2, 0.3, 0.5] });
      await reopened;
    });
    await viewer.settled();
    assert.equal(await viewer.regionCount(), 12);
  });

  test('where a script cannot be loaded that reads a model, the present one stays', async () => {
    const viewer = await browser.open({
      path: 'import-map.html',
      complaint: /ERR_FAILED/,
      prepare: (page) => page.context().route('**/obj_reader.js', (route) => route.abort()),
    });
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => viewer.addSite({ face: 100, bary: [0.2, 0.3, 0.5] })),
    );
    const { type, message } = await viewer.after('error', () =>
      viewer.evaluate((viewer) => (viewer.src = '/pentagon.obj')),
    );
    assert.equal(type, 'loadfailure');
    assert.match(message, /^pentagon\.obj cannot be opened: a script cannot be loaded: /);
    await viewer.evaluate(({ mesh }) => mesh.curvatureDensity());
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.undo()));
    assert.equal(await viewer.regionCount(), 12);
  });

  test('the files that a model refers to are fetched at the same time', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const { buffer, json } = tetrahedron;
    const waiting = [];
    await viewer.page.route('**/*.bin', (route) => {
      waiting.push(route);
      if (waiting.length < json.bufferViews.length) return;
      for (const each of waiting) {
        const [, i] = /(\d)\.bin$/.exec(each.request().url());
        const { byteOffset, byteLength } = json.bufferViews[i];
        void each.fulfill({ body: buffer.subarray(byteOffset, byteOffset + byteLength) });
      }
    });
    const { info } = await viewer.after('load', () =>
      viewer.evaluate((viewer) => void viewer.load('/split.gltf')),
    );
    assert.equal(info.faces, 4);
  });

  test('a file alone is opened as a list of one', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const text = new TextDecoder().decode(meshObj(torus(8, 8)));
    const { name } = await viewer.after('load', () =>
      viewer.evaluate((viewer, text) => void viewer.loadFiles(new File([text], 'own.obj')), text),
    );
    assert.equal(name, 'own.obj');
  });

  test('a model without any area is not opened as an empty view', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const line = 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 2 4 3\n';
    const { type, message } = await viewer.after('error', () =>
      viewer.evaluate((viewer, text) => void viewer.loadFiles(new File([text], 'line.obj')), line),
    );
    assert.equal(type, 'loadfailure');
    assert.equal(message, 'line.obj has no area to be seen: all of its triangles are flat.');
  });

  test('points that are not finite are seen nowhere', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const seen = await viewer.evaluate((viewer) =>
      viewer.project([0, 0.42, 1, Number.NaN, 0, 0, 0, Infinity, 0]).map((place) => !!place),
    );
    assert.deepEqual(seen, [true, false, false]);
  });

  test('opening a file tells how far it is, and ends in the worker when it is cancelled', async () => {
    const viewer = await browser.open({
      path: 'one.html',
      prepare: (page) =>
        page.addInitScript(() => {
          window.aborted = 0;
          const { postMessage } = Worker.prototype;
          Worker.prototype.postMessage = function (message, ...options) {
            if ('abort' in message) ++window.aborted;
            return postMessage.call(this, message, ...options);
          };
        }),
    });
    const { shares, isOpen, aborted } = await viewer.evaluate(
      async (viewer, text) => {
        const shares = [];
        const listener = ({ detail }) => {
          shares.push(detail.totalProgress);
          if (detail.totalProgress > 0.4) viewer.cancel();
        };
        viewer.addEventListener('progress', listener);
        const isOpen = await viewer.loadFiles([new File([text], 'large.obj')]);
        viewer.removeEventListener('progress', listener);
        return { shares, isOpen, aborted: window.aborted };
      },
      new TextDecoder().decode(meshObj(torus(120, 120))),
    );
    assert.ok(
      shares.some((share) => share > 0.4 && share < 1),
      shares.join(),
    );
    assert.equal(isOpen, false);
    assert.equal(aborted, 1);
    assert.equal(await viewer.siteCount(), 12, 'the model before stays');
  });

  test('loading is told of in order, and the poster goes', async () => {
    const viewer = await emptyPage(browser);
    const told = await viewer.page.evaluate(async (model) => {
      document.body.innerHTML = `<div></div>`;
      const element = document.createElement('geodesic-voronoi');
      element.poster = '/icon.svg';
      element.innerHTML = '<i slot="progress-bar">on its way</i>';
      const told = [];
      for (const type of ['progress', 'poster-dismissed', 'load', 'diagram', 'error']) {
        element.addEventListener(type, ({ detail }) => told.push([type, detail?.totalProgress]));
      }
      element.src = /src="([^"]*)"/.exec(model)[1];
      element.setAttribute('sites', '12');
      document.body.append(element);
      const poster = element.shadowRoot.querySelector('.poster');
      const image = element.shadowRoot.querySelector('img');
      told.push(['poster', poster.hidden, image.getAttribute('src')]);
      await new Promise((resolve) => element.addEventListener('diagram', resolve));
      told.push(['poster', poster.hidden, element.loaded]);
      return told;
    }, model);
    const types = told.map(([type]) => type).filter((type, i, all) => type !== all[i - 1]);
    assert.deepEqual(told[0], ['poster', false, '/icon.svg']);
    assert.deepEqual(told.at(-1), ['poster', true, true]);
    assert.deepEqual(
      types.filter((type) => !['progress', 'poster'].includes(type)),
      ['poster-dismissed', 'load', 'diagram'],
    );
    const loading = told.slice(
      0,
      told.findIndex(([type]) => type === 'load'),
    );
    const shares = loading.filter(([type]) => type === 'progress').map(([, share]) => share);
    assert.ok(shares.length > 0 && shares.every((share, i) => share >= (shares[i - 1] ?? 0)));
    assert.equal(shares.at(-1), 1);
  });

  test('a poster that is revealed by hand stays until then', async () => {
    const viewer = await browser.visit({ path: 'one.html' });
    await viewer.set({ reveal: 'manual' });
    await viewer.settled();
    const poster = viewer.page.locator('geodesic-voronoi .poster');
    assert.equal(await poster.evaluate(({ hidden }) => hidden), false);
    await viewer.evaluate((viewer) => viewer.dismissPoster());
    assert.equal(await poster.evaluate(({ hidden }) => hidden), true);
  });

  test('a poster that cannot be had is asked for once, however often sites change', async () => {
    const requests = [];
    const viewer = await browser.open({
      path: 'one.html',
      complaint: /404/,
      prepare: (page) => page.on('request', (request) => requests.push(request.url())),
    });
    const fetched = viewer.page.waitForResponse(/poster/);
    await viewer.set({ poster: '/nowhere/poster' });
    await fetched;
    for (const face of [10, 20])
      await viewer.after('diagram', () =>
        viewer.evaluate((viewer, face) => viewer.moveSite(0, { face, bary: [1, 0, 0] }), face),
      );
    assert.equal(requests.filter((address) => address.endsWith('poster')).length, 1);
    await viewer.set({ poster: '' });
    await viewer.drawn();
    const image = viewer.page.locator('geodesic-voronoi .poster img');
    assert.equal(await image.getAttribute('src'), null);
  });

  test('a model that cannot be had says so in its place, until there is one', async () => {
    const viewer = await emptyPage(browser, { complaint: /404/ });
    const error = await viewer.page.evaluate(() => {
      const element = document.createElement('geodesic-voronoi');
      element.src = '/nowhere.glb';
      document.body.append(element);
      return new Promise((resolve) => {
        element.addEventListener('error', ({ detail }) => resolve({ ...detail, cause: undefined }));
      });
    });
    const sentence = 'nowhere.glb cannot be fetched: the server answers 404.';
    assert.deepEqual([error.type, error.message], ['loadfailure', sentence]);
    await viewer.settled();
    assert.equal(await viewer.evaluate(({ status }) => status), 'failed');
    const message = viewer.page.locator('geodesic-voronoi [role=alert]');
    assert.equal(await message.textContent(), sentence);
    assert.equal(await message.isVisible(), true);
    await viewer.after('error', () =>
      viewer.evaluate((viewer) => {
        viewer.loss = window.contexts[0].getExtension('WEBGL_lose_context');
        viewer.loss.loseContext();
      }),
    );
    assert.match(await message.textContent(), /^The graphics card has dropped this view/);
    await viewer.evaluate((viewer) => viewer.loss.restoreContext());
    await message.filter({ hasText: sentence }).waitFor();
    await viewer.after('diagram', () => viewer.set({ src: '/samples/torus.glb' }));
    assert.equal(await message.isVisible(), false);
  });

  test('an address without a last part is named as a whole', async () => {
    const viewer = await emptyPage(browser, { complaint: /404/ });
    const [message, address] = await viewer.page.evaluate(async () => {
      const element = document.createElement('geodesic-voronoi');
      document.body.append(element);
      const failed = new Promise((resolve) =>
        element.addEventListener('error', ({ detail }) => resolve(detail.message)),
      );
      await element.load('/nowhere/');
      return [await failed, new URL('/nowhere/', location.href).href];
    });
    assert.equal(message, `${address} cannot be fetched: the server answers 404.`);
  });
});
