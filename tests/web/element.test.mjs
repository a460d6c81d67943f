// SPDX-License-Identifier: MIT
//
// The element in other people's pages.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { browserForTests } from './browser.mjs';
import { elementPages, emptyPage, longText, model } from './element_pages.mjs';

const browser = await browserForTests(elementPages);

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
    const viewer = await emptyPage(browser);
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
    const viewer = await emptyPage(browser, {
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
    const viewer = await emptyPage(browser, {
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
    const viewer = await emptyPage(browser);
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
