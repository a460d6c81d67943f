// SPDX-License-Identifier: MIT
//
// The element in other people's pages.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { suite, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { torus } from '../../web/page/samples/shapes.mjs';
import { gltf } from '../wasm/meshes.mjs';
import { meshObj } from '../wasm/model_files.mjs';
import { browserForTests } from './browser.mjs';

const standalone = '<script type="module" src="/package/standalone.js"></script>';
const importMap = JSON.stringify({
  imports: {
    'geodesic-voronoi': '/package/index.js',
    three: '/modules/three/build/three.module.js',
    'three/addons/': '/modules/three/examples/jsm/',
    'three-mesh-bvh': '/modules/three-mesh-bvh/build/index.module.js',
  },
});
const model = 'src="/samples/torus.glb" sites="12"';

const tetrahedron = gltf({
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
  indices: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
});

function page(body, head = standalone) {
  return {
    html: `<!doctype html><html lang="en"><head><meta charset="utf-8" /><title>Test</title>
      <link rel="icon" href="/icon.svg" />${head}</head><body>${body}</body></html>`,
  };
}

/** How often a page has fetched a script. */
const timesFetched = (page, script) =>
  page.evaluate(async (script) => {
    await fetch('/icon.svg'); // what was asked for before is there, too
    const names = performance.getEntriesByType('resource').map(({ name }) => name);
    return names.filter((name) => name.endsWith(`/${script}`)).length;
  }, script);

/** A page that has every script of the package by itself. */
function byImportMap(body) {
  const hash = createHash('sha256').update(importMap).digest('base64');
  return {
    ...page(
      body,
      `<script type="importmap">${importMap}</script>
       <script type="module" src="/package/viewer/element.js"></script>`,
    ),
    policy:
      `default-src 'self'; script-src 'self' 'wasm-unsafe-eval' 'sha256-${hash}'; ` +
      "worker-src 'self'",
  };
}

const longText = '<p>A paragraph</p>'.repeat(100);
const twenty = Array.from(
  { length: 20 },
  (_, i) => `<p>Paragraph ${i}</p>
    <geodesic-voronoi loading="lazy" ${model} seed="${i + 1}"></geodesic-voronoi>`,
).join('\n');

const browser = await browserForTests({
  '/icon.svg': { html: '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" />' },
  '/one.html': page(`<geodesic-voronoi ${model}></geodesic-voronoi>`),
  '/right-to-left.html': page(
    `<div dir="rtl" lang="ar"><geodesic-voronoi ${model}></geodesic-voronoi></div>`,
  ),
  '/elsewhere.html': {
    ...page(
      `<geodesic-voronoi ${model}></geodesic-voronoi>`,
      '<script type="module" src="http://cdn.example/standalone.js"></script>',
    ),
    policy:
      "default-src 'self'; script-src http://cdn.example 'wasm-unsafe-eval'; " +
      "worker-src blob: http://cdn.example; connect-src 'self' http://cdn.example",
  },
  '/twenty.html': page(twenty),
  '/early.html': page(`<geodesic-voronoi></geodesic-voronoi><script src="early.js"></script>`),
  '/early.js': {
    html: `Object.assign(document.querySelector('geodesic-voronoi'), {
      src: '/samples/torus.glb', sites: 7, layers: ['regions', 'dual'], cameraOrbit: '30deg 75deg 120%',
    });`,
  },
  '/early_sites.html': page(
    '<geodesic-voronoi sites="3"></geodesic-voronoi><script src="early_sites.js"></script>',
  ),
  '/early_sites.js': {
    html: `document.querySelector('geodesic-voronoi').sites = { face: [0], bary: [1, 0, 0] };`,
  },
  '/exploded.html': page(
    `<geodesic-voronoi ${model} exploded="0.8" layers="regions"></geodesic-voronoi>
     <script type="module" src="count.js"></script>`,
  ),
  '/count.js': {
    html: `const viewer = document.querySelector('geodesic-voronoi');
      viewer.addEventListener('exploded', ({ detail }) => { viewer.parts = detail?.regions; });`,
  },
  '/scheme.html': page(
    `<geodesic-voronoi ${model} layers="regions"></geodesic-voronoi>`,
    `<meta name="color-scheme" content="light dark" />${standalone}`,
  ),
  '/empty.html': page(''),
  '/unaddressed.gltf': {
    html: JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ uri: 'http://[', byteLength: 1 }],
    }),
  },
  '/vast.gltf': {
    html: JSON.stringify({
      asset: { version: '2.0' },
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ componentType: 5126, count: 20_000_001, type: 'VEC3' }],
    }),
  },
  '/split.gltf': {
    html: JSON.stringify({
      ...tetrahedron.json,
      bufferViews: tetrahedron.json.bufferViews.map(({ byteLength }, buffer) => ({
        buffer,
        byteLength,
      })),
      buffers: tetrahedron.json.bufferViews.map(({ byteLength }, i) => ({
        byteLength,
        uri: `${i}.bin`,
      })),
    }),
  },
  '/pentagon.obj': { html: 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n' },
  '/inside-out.obj': {
    html: `v -1 -1 -1\nv 1 -1 1\nv -1 1 1\nv 1 1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n`,
  },
  '/article.html': page(`<geodesic-voronoi ${model}></geodesic-voronoi>${longText}`),
  '/import-map.html': byImportMap(`<geodesic-voronoi ${model}></geodesic-voronoi>`),
  '/coloured.html': byImportMap('<geodesic-voronoi src="/coloured.ply"></geodesic-voronoi>'),
  '/coloured.ply': {
    html: [
      ...['ply', 'format ascii 1.0', 'element vertex 3'],
      ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
      ...['red', 'green', 'blue'].map((channel) => `property uchar ${channel}`),
      ...['element face 1', 'property list uchar int vertex_indices', 'end_header'],
      ...['0 0 0 255 0 0', '1 0 0 255 0 0', '0 1 0 255 0 0', '3 0 1 2', ''],
    ].join('\n'),
  },
  '/unplaced.html': byImportMap(`<geodesic-voronoi ${model} sampling="none"></geodesic-voronoi>`),
});

/** A page without an element, to which the script has come. */
async function emptyPage(options) {
  const viewer = await browser.visit({ path: 'empty.html', ...options });
  await viewer.page.waitForFunction(() => customElements.get('geodesic-voronoi'));
  return viewer;
}

/** The share of an element's view that is not transparent, in what is seen of it now. */
async function drawnShare(viewer, index) {
  await viewer.drawn();
  return viewer.page.evaluate(async (index) => {
    const element = document.querySelectorAll('geodesic-voronoi')[index];
    return window.opaqueShare(await window.pixelsOf(element.shadowRoot.querySelector('canvas')));
  }, index);
}

/** The WebGL contexts that are alive. */
function contextCount(viewer) {
  return viewer.page.evaluate(
    () => window.contexts.filter((context) => !context.isContextLost()).length,
  );
}

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

suite('plain pages', () => {
  test('one script is enough, under a strict content security policy', async () => {
    const scripts = [];
    const viewer = await browser.open({
      path: 'one.html',
      prepare: (page) =>
        page.on('request', (request) => {
          const { pathname } = new URL(request.url());
          if (pathname.endsWith('.js')) scripts.push(pathname);
        }),
    });
    assert.equal(await viewer.regionCount(), 12);
    assert.ok((await drawnShare(viewer, 0)) > 0.1);
    assert.deepEqual([...new Set(scripts)], ['/package/standalone.js']);
    assert.equal(viewer.page.workers().length, 2);
  });

  test('the script may come from another server', async () => {
    const dist = fileURLToPath(new URL('../../dist', import.meta.url));
    const viewer = await browser.open({
      path: 'elsewhere.html',
      prepare: (page) =>
        page.route('http://cdn.example/**', (route) =>
          route.fulfill({
            path: dist + new URL(route.request().url()).pathname,
            headers: { 'Access-Control-Allow-Origin': '*' },
          }),
        ),
    });
    assert.equal(await viewer.regionCount(), 12);
    assert.equal(viewer.page.workers().length, 2);
  });

  test('an import map finds three and all else', async () => {
    const viewer = await browser.open({ path: 'import-map.html' });
    assert.equal(await viewer.regionCount(), 12);
    // What readers import is found in the worker as well, where import maps do not count.
    await viewer.page.evaluate(() => {
      const element = document.querySelector('geodesic-voronoi');
      return new Promise((resolve, reject) => {
        element.addEventListener('diagram', resolve, { once: true });
        element.addEventListener('error', ({ detail }) => reject(detail), { once: true });
        element.src = '/pentagon.obj';
      });
    });
  });
});

suite('many elements', () => {
  test('twenty share workers, module and context, drawn when scrolled to', async () => {
    const requests = [];
    const viewer = await browser.visit({
      path: 'twenty.html',
      prepare: (page) =>
        page.on('request', (request) => requests.push(new URL(request.url()).pathname)),
    });
    const { page } = viewer;
    const statuses = () =>
      page.locator('geodesic-voronoi').evaluateAll((all) => all.map(({ status }) => status));
    await page.waitForFunction(() => document.querySelector('geodesic-voronoi').status === 'ready');
    const first = await statuses();
    assert.ok(first.filter((status) => status === 'empty').length >= 17, first.join());
    const models = requests.filter((path) => path.endsWith('.glb'));
    assert.ok(models.length <= 3, 'the rest is not fetched');

    for (let i = 0; i < 20; ++i) {
      await page.locator('geodesic-voronoi').nth(i).scrollIntoViewIfNeeded();
      await page.waitForFunction(
        (i) => document.querySelectorAll('geodesic-voronoi')[i].status === 'ready',
        i,
      );
      assert.ok((await drawnShare(viewer, i)) > 0.1, `element ${i} is drawn`);
    }
    await page.locator('geodesic-voronoi').first().scrollIntoViewIfNeeded();
    assert.ok((await viewer.coverage(await viewer.picture())) > 0.1, 'it is drawn again');
    assert.equal(await contextCount(viewer), 1);
    assert.ok(page.workers().length <= 5, `${page.workers().length} workers`);
    for (const name of ['core', 'gltf']) {
      const count = requests.filter((path) => path.endsWith(`/${name}.wasm`)).length;
      assert.equal(count, 1, `${name}.wasm is fetched and compiled once`);
    }
  });

  test('what is far from the view makes and fetches nothing', async () => {
    const viewer = await emptyPage();
    const requests = [];
    viewer.page.on('request', (request) => requests.push(request.url()));
    await viewer.page.evaluate((html) => {
      document.body.innerHTML = html;
      return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 200)));
    }, `${longText}<geodesic-voronoi loading="lazy" ${model}></geodesic-voronoi>`);
    assert.deepEqual(requests, []);
    assert.equal(await contextCount(viewer), 0);
    assert.equal(viewer.page.workers().length, 0);
    await viewer.set({ loading: 'eager' });
    await viewer.settled();
    assert.equal(await viewer.regionCount(), 12, 'until it is asked for');
  });

  test('what is far from the view is not drawn, whatever becomes of it', async () => {
    const viewer = await emptyPage({
      prepare: (page) =>
        page.addInitScript(() => {
          window.drawCalls = 0;
          const { prototype } = WebGL2RenderingContext;
          for (const name of Object.keys(prototype).filter((name) => /^draw(El|Ar)/.test(name))) {
            const draw = prototype[name];
            prototype[name] = function (...values) {
              ++window.drawCalls;
              draw.apply(this, values);
            };
          }
        }),
    });
    await viewer.page.evaluate((html) => {
      document.body.innerHTML = html;
      return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 200)));
    }, `${longText}<geodesic-voronoi loading="lazy" sites="12"></geodesic-voronoi>`);
    await viewer.evaluate((viewer) => viewer.load('/samples/torus.glb'));
    await viewer.settled();
    await viewer.evaluate((viewer) => void (viewer.style.width = '350px'));
    await viewer.drawn();
    assert.equal(await viewer.page.evaluate(() => window.drawCalls), 0);
    await viewer.page.locator('geodesic-voronoi').scrollIntoViewIfNeeded();
    await viewer.drawn();
    assert.ok((await drawnShare(viewer, 0)) > 0.1);
    assert.ok((await viewer.page.evaluate(() => window.drawCalls)) > 0);
  });

  test('a hundred that come and go leave no worker, context or listener', async () => {
    const viewer = await emptyPage({
      prepare: (page) => page.addInitScript(countListeners),
    });
    const { page } = viewer;
    const round = (isAwaited) =>
      page.evaluate(
        async ({ model, isAwaited }) => {
          const box = document.createElement('div');
          box.innerHTML = `<geodesic-voronoi ${model}></geodesic-voronoi>`;
          const [element] = box.children;
          const drawn = new Promise((resolve) => element.addEventListener('diagram', resolve));
          document.body.append(element);
          if (isAwaited) await drawn;
          else await new Promise((resolve) => setTimeout(resolve, 5));
          element.remove();
          await null;
        },
        { model, isAwaited },
      );
    await round(true);
    const listeners = await page.evaluate(() => window.listenerCount);
    for (let i = 1; i < 100; ++i) await round(i % 10 === 0);
    assert.equal(await contextCount(viewer), 0);
    assert.equal(await page.evaluate(() => window.listenerCount), listeners);
    await Promise.all(page.workers().map((worker) => worker.waitForEvent('close')));
  });

  test('one whose view cannot be made leaves no context', async () => {
    const viewer = await emptyPage();
    const told = await viewer.page.evaluate(async () => {
      window.ResizeObserver = undefined;
      const element = document.createElement('geodesic-voronoi');
      const message = new Promise((resolve) =>
        element.addEventListener('error', ({ detail }) => resolve(detail.message)),
      );
      document.body.append(element);
      return [await message, element.status, window.contexts.length];
    });
    assert.match(told[0], /^The view cannot be made: ResizeObserver is not/);
    assert.deepEqual(told.slice(1), ['failed', 1]);
    assert.equal(await contextCount(viewer), 0);
  });

  /** Counts, in the page, the listeners on what outlives an element. */
  function countListeners() {
    const listeners = new Set();
    Object.defineProperty(window, 'listenerCount', { get: () => listeners.size });
    const ids = new Map();
    const idOf = (object) => ids.get(object) ?? ids.set(object, ids.size).get(object);
    const keyOf = (target, type, listener, options) => {
      const capture = typeof options === 'object' ? options?.capture : options;
      return [idOf(target ?? window), type, idOf(listener), Boolean(capture)].join();
    };
    const outlives = (target) =>
      target instanceof MediaQueryList ||
      [undefined, null, window, document, document.body].includes(target);
    const { addEventListener, removeEventListener } = EventTarget.prototype;
    EventTarget.prototype.addEventListener = function (type, listener, options) {
      if (outlives(this)) {
        const key = keyOf(this, type, listener, options);
        listeners.add(key);
        options?.signal?.addEventListener('abort', () => listeners.delete(key));
      }
      addEventListener.call(this, type, listener, options);
    };
    EventTarget.prototype.removeEventListener = function (type, listener, options) {
      listeners.delete(keyOf(this, type, listener, options));
      removeEventListener.call(this, type, listener, options);
    };
  }
});

suite('the page around it', () => {
  const scrolled = (viewer) => viewer.page.evaluate(() => scrollY);
  const orbit = (viewer) => viewer.evaluate(({ cameraOrbit }) => cameraOrbit);
  const centre = (viewer) =>
    viewer.evaluate((viewer) => {
      const box = viewer.getBoundingClientRect();
      return { x: box.left + box.width / 2, y: box.top + box.height / 2 };
    });

  test('the wheel scrolls the page until the model has been clicked', async () => {
    const viewer = await browser.open({ path: 'article.html' });
    const { x, y } = await centre(viewer);
    const before = await orbit(viewer);
    await viewer.page.mouse.move(x, y);
    await viewer.page.mouse.wheel(0, 60);
    await viewer.page.waitForFunction(() => scrollY === 60);
    assert.equal(await orbit(viewer), before);
    assert.match(
      await viewer.page.locator('geodesic-voronoi .hint.shown').textContent(),
      /^Click the model/,
    );

    await viewer.page.mouse.click(x, y - 60);
    await viewer.after('camera-change', () => viewer.page.mouse.wheel(0, 60));
    assert.notEqual(await orbit(viewer), before);
    assert.equal(await scrolled(viewer), 60);
  });

  test('touch-action "none" takes it at once, "pan-y" never', async () => {
    const viewer = await browser.open({ path: 'article.html' });
    const { x, y } = await centre(viewer);
    await viewer.evaluate((viewer) => viewer.setAttribute('touch-action', 'none'));
    await viewer.page.mouse.move(x, y);
    await viewer.after('camera-change', () => viewer.page.mouse.wheel(0, 60));
    assert.equal(await scrolled(viewer), 0);
    await viewer.evaluate((viewer) => viewer.setAttribute('touch-action', 'pan-y'));
    await viewer.page.mouse.click(x, y);
    await viewer.page.mouse.wheel(0, 60);
    await viewer.page.waitForFunction(() => scrollY === 60);
    const hint = await viewer.page.locator('geodesic-voronoi .hint.shown').textContent();
    assert.equal(hint, 'Hold Ctrl and scroll to zoom', 'a click does not help');
  });

  test('a finger scrolls the page until the model has been tapped', async () => {
    const viewer = await browser.open({ path: 'article.html', hasTouch: true });
    const { x, y } = await centre(viewer);
    const session = await viewer.page.context().newCDPSession(viewer.page);
    const touch = (type, ...touchPoints) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints });
    // Beside the site that the tap adds: that would be dragged.
    const swipe = async () => {
      const at = (y) => ({ x: x - 100, y });
      await touch('touchStart', at(y));
      for (let way = 10; way <= 80; way += 10) await touch('touchMove', at(y - way));
      await touch('touchEnd');
    };
    // It glides on after the swipe.
    await viewer.page.evaluate(() => {
      window.scrolledTo = new Promise((resolve) => {
        addEventListener('scrollend', () => resolve(scrollY), { once: true });
      });
    });
    await swipe();
    assert.ok((await viewer.page.evaluate(() => window.scrolledTo)) > 20);
    const hint = viewer.page.locator('geodesic-voronoi .hint');
    assert.match(await hint.textContent(), /^Tap the model/);
    await viewer.page.evaluate(() => scrollTo(0, 0));
    await viewer.page.touchscreen.tap(x, y);
    await viewer.after('camera-change', swipe);
    assert.equal(await scrolled(viewer), 0);
  });

  test('one to look at only does nothing with pointer and wheel', async () => {
    const viewer = await browser.open({ path: 'article.html' });
    await viewer.set({ interactive: 'none' });
    const { x, y } = await centre(viewer);
    await viewer.page.mouse.click(x, y);
    await viewer.page.mouse.wheel(0, 60);
    await viewer.page.waitForFunction(() => scrollY === 60);
    assert.equal(await viewer.siteCount(), 12);
    assert.equal(await viewer.page.locator('geodesic-voronoi canvas').getAttribute('role'), 'img');
  });

  test('with "camera", sites stay as they are', async () => {
    const viewer = await browser.open({ path: 'article.html' });
    await viewer.set({ interactive: 'camera' });
    const place = await viewer.freePlace();
    await viewer.page.mouse.click(place.x, place.y);
    await viewer.page.keyboard.press('Enter');
    await viewer.after('camera-change', () => viewer.page.keyboard.press('ArrowLeft'));
    assert.equal(await viewer.siteCount(), 12);
  });
});

suite('assistive technology', () => {
  test('hears what the keys do, and nothing else', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const heard = async (attributes) => {
      await viewer.evaluate(async (viewer, attributes) => {
        for (const [name, value] of Object.entries(attributes)) viewer.setAttribute(name, value);
        await null; // Attributes take effect together, after the code that sets them.
      }, attributes);
      const canvas = viewer.page.locator('geodesic-voronoi canvas');
      const id = await canvas.getAttribute('aria-describedby');
      return viewer.page.locator(`geodesic-voronoi #${id}`).textContent();
    };
    const all = await heard({ interactive: 'edit' });
    for (const key of ['Arrow keys', 'F ', 'Enter adds a site', 'Shift', 'Delete', 'Escape'])
      assert.ok(all.includes(key), `${key} in: ${all}`);
    assert.match(await heard({ tool: 'density' }), /Enter paints density/);
    const ofCamera = await heard({ interactive: 'camera' });
    assert.match(ofCamera, /Arrow keys turn the model/);
    assert.doesNotMatch(ofCamera, /Enter|Delete|Space/);
    assert.equal(await heard({ interactive: 'none' }), '');
  });

  test('is told which site is selected, in English also in a page from right to left', async () => {
    const viewer = await browser.open({ path: 'right-to-left.html' });
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    await viewer.page.keyboard.press('n');
    const told = viewer.page.locator('geodesic-voronoi [role=status]', {
      hasText: /^Site 0 selected, of 12, region of area [\d.]+$/,
    });
    await told.waitFor({ state: 'attached' });
    assert.deepEqual(
      await told.evaluate((element) => [element.lang, getComputedStyle(element).direction]),
      ['en', 'ltr'],
    );
    await viewer.page.keyboard.press('Delete');
    await viewer.page
      .locator('geodesic-voronoi [role=status]', { hasText: 'No site selected, of 11' })
      .waitFor({ state: 'attached' });
  });

  test('hears of a site that is moved what has changed, and why it stays', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    const heard = async (key, action = () => viewer.page.keyboard.press(key)) => {
      await viewer.evaluate((viewer) => {
        viewer.heard = [];
        viewer.observers ??= [...viewer.shadowRoot.querySelectorAll('[role=status]')].map(
          (status) => {
            const tell = () => viewer.heard.push(status.textContent);
            new MutationObserver(tell).observe(status, { childList: true });
          },
        );
      });
      await action();
      return viewer.evaluate(({ heard }) => heard);
    };
    await heard('n');
    const moved = await heard('', async () => {
      for (let i = 0; i < 3; ++i)
        await viewer.after('diagram', () => viewer.page.keyboard.press('Shift+ArrowLeft'));
    });
    assert.ok(moved.length > 0 && new Set(moved).size === moved.length, `${moved}`);
    for (const sentence of moved) assert.match(sentence, /^Region of area [\d.]+$/);
    await viewer.set({ selected: 3 });
    const { face, bary } = await viewer.sites();
    const inPlace = () =>
      viewer.after('diagram', () =>
        viewer.evaluate((viewer, place) => viewer.moveSite(3, place), {
          face: face[3],
          bary: bary.slice(9, 12),
        }),
      );
    assert.deepEqual(await heard('', inPlace), [], 'nothing has changed');
    await viewer.after('diagram', () => viewer.page.keyboard.press('Delete'));
    const brought = await heard('', () =>
      viewer.after('diagram', () => viewer.page.keyboard.press('Control+z')),
    );
    assert.equal(brought[0], 'Site 3 selected, of 12', 'its area is not that of another one');
    assert.match(brought[1], /^Site 3 selected, of 12, region of area /);
    await viewer.evaluate((viewer) => viewer.setAttribute('camera-orbit', '0deg 90deg 9000%'));
    await viewer.drawn();
    assert.deepEqual(await heard('Shift+ArrowUp'), ['The model is not seen there']);
    await viewer.set({ selected: -1 });
    assert.deepEqual(await heard('Shift+ArrowUp'), ['No site is selected']);
  });
});

suite('attributes and events', () => {
  test('a hidden site that is selected is turned to the front, also of a solid turned inside out', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.after('diagram', () => viewer.set({ src: '/inside-out.obj' }));
    const seen = await viewer.evaluate((viewer) =>
      [...viewer.sites.face.keys()].map((index) => {
        viewer.selected = index;
        return viewer.sitePosition(index) !== undefined;
      }),
    );
    assert.deepEqual(seen, Array(12).fill(true));
  });

  test('a selected site that the surface hides is seen through it', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.set({ selected: 0 });
    await viewer.drawn();
    await viewer.evaluate((viewer) => {
      const [, ...rest] = viewer.cameraOrbit.split(' ');
      viewer.cameraOrbit = `${Number.parseFloat(viewer.cameraOrbit) + 180}deg ${rest.join(' ')}`;
    });
    await viewer.still();
    assert.equal(await viewer.sitePosition(0), undefined);
    const pixels = () =>
      viewer.evaluate(async ({ shadowRoot }) => [
        ...(await window.pixelsOf(shadowRoot.querySelector('canvas'))).data,
      ]);
    const selected = await pixels();
    await viewer.set({ selected: -1 });
    await viewer.drawn();
    const unselected = await pixels();
    const changed = selected.filter((value, i) => Math.abs(value - unselected[i]) > 10);
    assert.ok(changed.length > 50, `${changed.length} values of its pixels`);
  });

  test('a selected site that the surface hides is not moved by keys, which say why', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.evaluate((viewer) => {
      viewer.selected = 0;
      const [, ...rest] = viewer.cameraOrbit.split(' ');
      viewer.cameraOrbit = `${Number.parseFloat(viewer.cameraOrbit) + 180}deg ${rest.join(' ')}`;
    });
    await viewer.still();
    await viewer.evaluate((viewer) => viewer.perform('move-left'));
    const hint = viewer.page.locator('geodesic-voronoi [part=hint]');
    assert.equal(await hint.textContent(), 'The surface hides the selected site');
  });

  test('an edit without a model is refused, in a sentence', async () => {
    const viewer = await emptyPage();
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
    const viewer = await emptyPage();
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
      return { count: sites.face.length, layers, exploded };
    });
    assert.deepEqual(made, { count: 12, layers: ['regions', 'sites'], exploded: 0.5 });
  });

  test('properties that are set to nothing, as React does when they go, remove their attributes', async () => {
    const viewer = await emptyPage();
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
    const viewer = await emptyPage();
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
    const viewer = await emptyPage();
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

  test('a diagram that cannot be made is told of on the view until there is one', async () => {
    const viewer = await emptyPage();
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
    const viewer = await emptyPage();
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

  test('an exploded view fills the view from the start, and no more', async () => {
    const viewer = await browser.visit({ path: 'exploded.html' });
    await viewer.page.waitForFunction(() => document.querySelector('geodesic-voronoi').diagram);
    await viewer.settled();
    const edges = await viewer.evaluate(async (viewer) => {
      while (viewer.parts !== 12) await new Promise((next) => setTimeout(next, 50));
      const { data, width, height } = await window.pixelsOf(await viewer.toBlob());
      const isDrawn = (x, y) => data[4 * (y * width + x) + 3] > 0;
      const [columns, rows] = [width, height].map((n) => [...Array(n).keys()]);
      return (
        columns.filter((x) => isDrawn(x, 0) || isDrawn(x, height - 1)).length +
        rows.filter((y) => isDrawn(0, y) || isDrawn(width - 1, y)).length
      );
    });
    assert.equal(edges, 0, 'no part is cut off');
  });

  test('its colours follow the colour scheme of the page, however that is set', async () => {
    const viewer = await browser.open({ path: 'scheme.html' });
    await viewer.page.emulateMedia({ colorScheme: 'dark' });
    await viewer.drawn(); // Pages are told with the next frame.
    const lightness = () =>
      viewer.evaluate(async (viewer) => {
        const { data } = await window.pixelsOf(await viewer.toBlob());
        return data.reduce((sum, x, i) => (i % 4 < 3 ? sum + x : sum), 0);
      });
    const dark = await lightness();
    await viewer.page.evaluate(async () => {
      document.documentElement.style.colorScheme = 'light';
      await null; // Observers are told after the code that changes something.
    });
    const light = await lightness();
    assert.ok(dark < 0.9 * light, `${dark} after ${light}`);
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

  test('a model that is too large is refused without advice that attributes cannot follow', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const { message } = await viewer.after('error', () => viewer.set({ src: '/vast.gltf' }));
    assert.match(message, /^vast\.gltf cannot be opened: .*16777216 vertices\.$/);
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

  test('its picture is as fine as the screen, also when the page is zoomed', async () => {
    const viewer = await browser.open({
      path: 'one.html',
      prepare: (page) =>
        page.addInitScript(() => {
          window.queries = [];
          const { matchMedia } = window;
          window.matchMedia = (text) => {
            const query = matchMedia.call(window, text);
            if (text.includes('resolution')) window.queries.push(query);
            return query;
          };
        }),
    });
    const cdp = await viewer.page.context().newCDPSession(viewer.page);
    for (const deviceScaleFactor of [2, 1.5]) {
      const metrics = { width: 800, height: 420, deviceScaleFactor, mobile: false };
      await cdp.send('Emulation.setDeviceMetricsOverride', metrics);
      // Browsers tell of it, but not where it is emulated.
      await viewer.page.evaluate(() => window.queries.at(-1).dispatchEvent(new Event('change')));
      await viewer.drawn();
      const width = await viewer.evaluate(
        ({ shadowRoot }) => shadowRoot.querySelector('canvas').width,
      );
      assert.equal(width, 300 * deviceScaleFactor);
    }
  });

  test('the model keeps clear of a padding that the element gets later', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const place = () => viewer.evaluate((viewer) => viewer.project([0, 0.42, 1])[0].x);
    const before = await place();
    await viewer.evaluate((viewer) => void (viewer.style.paddingRight = '100px'));
    await viewer.drawn();
    const after = await place();
    assert.ok(after < before - 20, `${after} after ${before}`);
  });

  test('points that are not finite are seen nowhere', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const seen = await viewer.evaluate((viewer) =>
      viewer.project([0, 0.42, 1, Number.NaN, 0, 0, 0, Infinity, 0]).map((place) => !!place),
    );
    assert.deepEqual(seen, [true, false, false]);
  });

  test('a picture of no size is refused, and so is a density of other vertices', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const refusals = await viewer.evaluate(async (viewer) => {
      const messageOf = ({ message }) => message;
      const scales = [0, -1, Number.NaN].map((scale) =>
        viewer.toBlob('image/png', undefined, scale).catch(messageOf),
      );
      const densities = [[1, 2], Array(9000).fill(Number.NaN)].map((density) => {
        try {
          viewer.density = density;
        } catch (error) {
          return error.message;
        }
      });
      return [...(await Promise.all(scales)), ...densities];
    });
    assert.deepEqual(refusals, [
      'scale is 0, not a number above 0.',
      'scale is -1, not a number above 0.',
      'scale is NaN, not a number above 0.',
      'density has the length 2, and the model 9000 vertices.',
      'density is NaN at vertex 0, not 0 or above.',
    ]);
  });

  test('a picture that ends with its element says so, and no graphics card is blamed', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const refusal = await viewer.evaluate((viewer) => {
      const picture = viewer.toBlob().catch(({ message }) => message);
      viewer.remove();
      return picture;
    });
    assert.equal(refusal, 'The element has left its document.');
  });

  test('a picture that outlives its element leaves nothing on the graphics card', async () => {
    const viewer = await browser.open({
      path: 'one.html',
      prepare: (page) =>
        page.addInitScript(() => {
          window.buffers = new Set();
          const { createBuffer, deleteBuffer } = WebGL2RenderingContext.prototype;
          WebGL2RenderingContext.prototype.createBuffer = function () {
            const buffer = createBuffer.call(this);
            window.buffers.add(buffer);
            return buffer;
          };
          WebGL2RenderingContext.prototype.deleteBuffer = function (buffer) {
            window.buffers.delete(buffer);
            deleteBuffer.call(this, buffer);
          };
        }),
    });
    const size = await viewer.evaluate(async (viewer) => {
      document.body.append(document.createElement('geodesic-voronoi')); // keeps the context
      const picture = viewer.toBlob();
      viewer.remove();
      return (await picture).size;
    });
    assert.ok(size > 0);
    await viewer.drawn();
    assert.equal(await viewer.page.evaluate(() => window.buffers.size), 0);
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
    const viewer = await emptyPage();
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
    const viewer = await emptyPage({ complaint: /404/ });
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
    const viewer = await emptyPage({ complaint: /404/ });
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

  test('the camera goes where it is told, and tells where it is', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const moved = await viewer.after('camera-change', () =>
      viewer.set({ cameraOrbit: '30deg 75deg 120%' }),
    );
    assert.equal(moved.orbit, '30deg 75deg 120%');
  });

  test('where sites are seen is known as soon as the camera has moved', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const [before, after] = await viewer.evaluate(async (viewer) => {
      const seen = () => [...viewer.sites.face.keys()].filter((i) => viewer.sitePosition(i)).length;
      const before = seen();
      viewer.cameraOrbit = viewer.cameraOrbit.replace('100%', '400%');
      await null; // Attributes take effect together, after the code that sets them.
      return [before, seen()];
    });
    assert.ok(before > 0 && after > 0, `${before} and ${after}`);
  });

  test('a model that is not seen from the first direction fits a view of another shape, too', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.after('camera-change', () => viewer.set({ cameraOrbit: '30deg 75deg 120%' }));
    const orbits = [];
    for (const style of [
      { width: '200px', height: '400px' },
      { display: 'none' },
      { display: 'block', width: '90px', height: '360px' },
    ]) {
      await viewer.evaluate((viewer, style) => void Object.assign(viewer.style, style), style);
      await viewer.drawn();
      orbits.push(await viewer.evaluate((viewer) => viewer.cameraOrbit));
    }
    assert.deepEqual(orbits, Array(3).fill('30deg 75deg 120%'));
    const seen = await viewer.evaluate((viewer) => {
      const { left, right, top, height } = viewer.getBoundingClientRect();
      const isSeen = (x) =>
        Array.from({ length: height }, (_, y) => viewer.surfaceFromPoint(x, top + y)).some(Boolean);
      return [left + 1, (left + right) / 2 - 30, right - 1].map(isSeen);
    });
    assert.deepEqual(seen, [false, true, false]);
  });

  test('the camera is told to be nowhere but where a model is seen from', async () => {
    const viewer = await emptyPage();
    const orbits = await viewer.evaluate(async () => {
      const viewer = document.createElement('geodesic-voronoi');
      const orbits = [];
      viewer.addEventListener('camera-change', ({ detail }) => orbits.push(detail.orbit));
      document.body.append(viewer);
      await viewer.load('/samples/torus.glb');
      return orbits;
    });
    for (const orbit of orbits) assert.match(orbit, /^24\.\d+deg 6\d\.\d+deg 100%/);
    assert.ok(orbits.length > 0);
  });

  // WebKit shows nothing of a canvas that was moved until it is drawn on.
  test('one that is moved in its document is drawn anew', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.evaluate(async (viewer) => {
      const { prototype } = CanvasRenderingContext2D;
      const { drawImage } = prototype;
      await new Promise((resolve, reject) => {
        setTimeout(() => reject(new Error('It is not drawn.')), 20_000);
        prototype.drawImage = function (...picture) {
          drawImage.apply(this, picture);
          resolve();
        };
        document.body.append(viewer);
      });
    });
  });

  // A style sheet that a script has made serves one document only.
  test('one that is moved to another document keeps its content and its style', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const seen = await viewer.evaluate(async (viewer) => {
      const inFrame = () => {
        const legend = viewer.shadowRoot.querySelector('.legend');
        return [viewer, legend].map((element) => getComputedStyle(element).position);
      };
      const frame = document.createElement('iframe');
      document.body.append(frame);
      frame.contentDocument.body.append(viewer);
      const moved = { regions: viewer.regionAreas.length, positions: inFrame() };
      viewer.remove();
      await null; // It frees what it has.
      const opened = new Promise((resolve, reject) => {
        viewer.addEventListener('diagram', ({ detail }) => resolve(detail.regions));
        viewer.addEventListener('error', ({ detail }) => reject(detail.cause));
      });
      frame.contentDocument.body.append(viewer);
      return { moved, opened: { regions: await opened, positions: inFrame() } };
    });
    const whole = { regions: 12, positions: ['relative', 'absolute'] };
    assert.deepEqual(seen, { moved: whole, opened: whole });
  });

  test('a picture of it can be had, larger too', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const pictures = await viewer.evaluate(async (viewer) => {
      const size = async (blob) => {
        const { width, height } = await createImageBitmap(blob);
        return { type: blob.type, width, height };
      };
      const large = await viewer.toBlob('image/webp', 0.9, 3);
      return [await size(await viewer.toBlob()), await size(large)];
    });
    assert.deepEqual(pictures, [
      { type: 'image/png', width: 300, height: 200 },
      { type: 'image/webp', width: 900, height: 600 },
    ]);
  });

  test('a picture that is being written is not lost with its model', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const size = await viewer.evaluate(async (viewer) => {
      const { postMessage } = MessagePort.prototype;
      MessagePort.prototype.postMessage = function (message, ...options) {
        postMessage.call(this, message, ...options);
        if (message.name === 'picture') viewer.remove();
      };
      const { width, height } = await createImageBitmap(await viewer.toBlob());
      return { width, height, isGone: !viewer.loaded };
    });
    assert.deepEqual(size, { width: 300, height: 200, isGone: true });
  });
});
