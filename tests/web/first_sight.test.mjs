// SPDX-License-Identifier: MIT
//
// What somebody sees who opens the page, with a link or without one.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { suite, test } from 'node:test';
import { bumpySphere, glb } from '../wasm/meshes.mjs';
import { assertWorkersAreNotImported, browserForTests, changedScript } from './browser.mjs';

const browser = await browserForTests({
  '/framed.html': {
    html: '<iframe sandbox="allow-scripts" src="/"></iframe>',
    policy: "default-src 'self' 'unsafe-inline'",
  },
});

const ownFile = { 'mine.glb': glb(bumpySphere(12, 16)) };
const hasDocuments = existsSync(new URL('../../build/page/docs/index.html', import.meta.url));

suite('first sight', () => {
  const isDisabled = (viewer, selector) => viewer.page.locator(selector).isDisabled();
  const state = (viewer, text) =>
    viewer.page.locator('#cvt-state', { hasText: text }).waitFor({ state: 'attached' });

  test('random regions become even ones, once, and undoing brings them back', async () => {
    const viewer = await browser.visit({
      hash: '',
      reducedMotion: 'no-preference',
      viewport: { width: 700, height: 320 },
    });
    await state(viewer, 'Finished 30 iterations');
    await viewer.settled();
    const areas = () =>
      viewer.evaluate(({ regionAreas }) => [...regionAreas].sort((a, b) => a - b));
    const even = await areas();
    assert.ok(even.at(-1) / even[0] < 3, `areas from ${even[0]} to ${even.at(-1)}`);
    assert.match(await viewer.page.locator('#caption').textContent(), /Each colour is .+\sClick/s);

    await viewer.after('diagram', () => viewer.page.click('#undo'));
    const random = await areas();
    assert.ok(random.at(-1) / random[0] > 4, `areas from ${random[0]} to ${random.at(-1)}`);
    assert.equal(await isDisabled(viewer, '#undo'), true, 'all of it is one step');
    assert.equal(
      await viewer.evaluate(({ cvtStatus }) => cvtStatus),
      'idle',
      'it does not begin again',
    );
  });

  test('nothing can be pressed before it works; who wants no motion sees none', async () => {
    let release;
    const released = new Promise((resolve) => (release = resolve));
    const viewer = await browser.visit({
      hash: '',
      prepare: (page) =>
        page.route('**/bunny.ply', async (route) => {
          await released;
          await route.continue();
        }),
    });
    for (const selector of [
      '#cvt-play',
      '#sampling-form [type=submit]',
      '#fit',
      '#download-button',
    ]) {
      assert.equal(await isDisabled(viewer, selector), true, `${selector} waits for the model`);
    }
    assert.equal(await viewer.page.locator('#poster').isVisible(), true);
    assert.equal(await viewer.page.locator('#progress').isVisible(), true);
    await viewer.evaluate((viewer) => {
      viewer.iterations = 0;
      viewer.addEventListener('cvt-iteration', () => ++viewer.iterations);
    });
    release();
    await viewer.page.locator('#undo:enabled').waitFor();
    await viewer.settled();
    assert.equal(await viewer.evaluate(({ iterations }) => iterations), 0);
    const areas = await viewer.evaluate(({ regionAreas }) =>
      [...regionAreas].sort((a, b) => a - b),
    );
    assert.ok(areas.at(-1) / areas[0] < 3, 'they are even all the same');
    await state(viewer, 'Finished 30 iterations');
    const curve = viewer.page.locator('#cvt-curve polyline');
    assert.equal((await curve.getAttribute('points')).split(' ').length, 31);
    assert.match(
      await viewer.page.locator('#cvt-energy').textContent(),
      /^[01]\.\d{4} × hexagons$/,
    );
    assert.equal(await isDisabled(viewer, '#cvt-play'), false);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    await state(viewer, 'Not begun');
  });

  test('who wants no motion and opens another model ends the work on the first', async () => {
    const viewer = await browser.visit({ hash: '' });
    await viewer.evaluate((viewer) => {
      viewer.states = 0;
      const next = (type) =>
        new Promise((done) => viewer.addEventListener(type, done, { once: true }));
      next('load').then(() => {
        const { mesh } = viewer;
        const { cvt } = mesh;
        const opened = next('load');
        mesh.cvt = async function* (...options) {
          for await (const state of cvt.apply(mesh, options)) {
            if (++viewer.states === 3) await opened;
            yield state;
          }
        };
      });
    });
    await state(viewer, 'Playing');
    await viewer.after('load', () => viewer.choose(ownFile));
    await state(viewer, 'Not begun');
    assert.equal(await viewer.evaluate(({ states }) => states), 3);
  });

  test('the poster shows the model where it is drawn', async () => {
    const viewer = await browser.open({ viewport: { width: 1024, height: 768 } });
    const [expected, drawn] = await viewer.evaluate(async (viewer) => {
      /** The edges of what is not transparent in a picture that has a place on the page. */
      const edges = (picture, { left, top, width, height }) => {
        const context = new OffscreenCanvas(width, height).getContext('2d');
        context.drawImage(picture, 0, 0, width, height);
        const { data } = context.getImageData(0, 0, width, height);
        const filled = [...Array(width * height).keys()].filter((i) => data[4 * i + 3] > 128);
        const columns = filled.map((i) => i % width).sort((a, b) => a - b);
        const right = left + columns.at(-1);
        const bottom = top + Math.floor(filled.at(-1) / width);
        return [left + columns[0], top + Math.floor(filled[0] / width), right, bottom];
      };
      const picture = await createImageBitmap(await viewer.toBlob());
      const poster = document.querySelector('#poster');
      viewer.reveal = 'manual'; // shows the poster again
      viewer.showPoster();
      const box = poster.getBoundingClientRect();
      const side = Math.min(box.width, box.height);
      const left = Math.round(box.left + (box.width - side) / 2);
      const top = Math.round(box.top + (box.height - side) / 2);
      await poster.decode();
      return [
        edges(poster, { left, top, width: Math.round(side), height: Math.round(side) }),
        edges(picture, viewer.getBoundingClientRect().toJSON()),
      ];
    });
    for (const [i, edge] of expected.entries()) {
      assert.ok(Math.abs(edge - drawn[i]) < 12, `edges at ${expected}, drawn at ${drawn}`);
    }
  });

  test('what is edited before the regions are even is kept', async () => {
    const viewer = await browser.visit({
      hash: '',
      prepare: (page) =>
        page.addInitScript(() => {
          const add = ({ target }) =>
            setTimeout(() => target.addSite({ face: 0, bary: [1, 0, 0] }));
          addEventListener('diagram', add, { capture: true, once: true });
        }),
    });
    await viewer.page.locator('#undo:enabled').waitFor();
    // More iterations than those of the page, and begun after them.
    await viewer.evaluate(async ({ mesh, sites }) => {
      for await (const _ of mesh.cvt(sites, { iterations: 40 }));
    });
    await viewer.settled();
    const { face } = await viewer.sites();
    assert.deepEqual([face.length, face[60]], [61, 0]);
    await viewer.after('diagram', () => viewer.page.click('#undo'));
    assert.equal(await isDisabled(viewer, '#undo'), true);
  });

  test('another model ends what makes regions even without a motion, and what the panel says of it', async () => {
    const viewer = await browser.visit({
      hash: '',
      prepare: (page) =>
        page.addInitScript(() => {
          const extend = ({ target }) => target.setAttribute('cvt-iterations', '10000');
          addEventListener('diagram', extend, { capture: true, once: true });
        }),
    });
    await state(viewer, 'Playing');
    await viewer.after('diagram', () => viewer.page.selectOption('#samples', 'torus.glb'));
    await state(viewer, 'Not begun');
  });

  test('what it needs is asked for once', async () => {
    const asked = [];
    await browser.open({
      prepare: (page) => page.on('request', (request) => asked.push(request)),
    });
    const nameOf = (address) => new URL(address).pathname.split('/').at(-1);
    const names = asked.map((request) => nameOf(request.url()));
    assert.deepEqual(
      names.filter((name) => name.endsWith('.wasm')).map((name) => name.split('-')[0]),
      ['core'],
      'a glTF is what the other module is for',
    );
    // The page and its workers may share a script, which browsers then have in their cache.
    const askers = asked.map((request) => nameOf(request.headers().referer ?? request.url()));
    const pairs = names.map(
      (name, i) => `${name}${/worker/.test(askers[i]) ? ' for a worker' : ''}`,
    );
    // The icon is that of the window too.
    const others = pairs.filter((pair) => !pair.startsWith('icon'));
    assert.equal(new Set(others).size, others.length, others.join(', '));
  });

  test('the panel ends with the documents', {
    skip: hasDocuments ? false : 'not built',
  }, async () => {
    const viewer = await browser.visit();
    await viewer.page.click('#documents a');
    await viewer.page.waitForURL('**/docs/index.html');
    assert.ok((await viewer.page.locator('h1').count()) > 0);
  });

  test('without WebGL 2 the page says so', async () => {
    const viewer = await browser.open({
      complaint: /Error creating WebGL context/,
      prepare: (page) =>
        page.addInitScript(() => {
          HTMLCanvasElement.prototype.getContext = () => null;
        }),
    });
    const message = viewer.page.locator('geodesic-voronoi [role=alert]');
    assert.match(await message.textContent(), /needs WebGL 2/);
    assert.equal(await message.isVisible(), true);
    await viewer.page.locator('#status', { hasText: /^No model is open\.$/ }).waitFor();
    assert.equal(await viewer.page.locator('#progress').isVisible(), false);
    for (const id of ['#samples', '#open', '#open-folder']) {
      assert.equal(await viewer.page.locator(id).isDisabled(), true, id);
    }
    assert.equal(await viewer.page.locator('#samples').textContent(), 'None');
    // Above the message, where nothing may listen.
    await viewer.page.mouse.move(100, 100);
    await viewer.page.mouse.wheel(0, 100);
    await viewer.page.mouse.click(110, 100);
  });

  test('a view that cannot be made for another reason than WebGL says which', async () => {
    const viewer = await browser.open({
      prepare: (page) =>
        page.addInitScript(() => {
          window.ResizeObserver = undefined;
        }),
    });
    const message = viewer.page.locator('geodesic-voronoi [role=alert]');
    assert.equal(
      await message.textContent(),
      'The view cannot be made: ResizeObserver is not a constructor.',
    );
    await viewer.page.locator('#status', { hasText: /^No model is open\.$/ }).waitFor();
  });

  test('a context that is lost while the first model is loaded ends nothing', async () => {
    let send;
    const sent = new Promise((resolve) => {
      send = resolve;
    });
    const viewer = await browser.visit({
      prepare: (page) =>
        page.route('**/bunny.ply', async (route) => {
          await sent;
          await route.continue();
        }),
    });
    await viewer.page.waitForFunction(() => window.contexts.length > 0);
    await viewer.after('diagram', async () => {
      await viewer.evaluate(async (viewer) => {
        const lost = new Promise((resolve) => viewer.addEventListener('error', resolve));
        window.contexts[0].getExtension('WEBGL_lose_context').loseContext();
        await lost;
      });
      assert.match(await viewer.page.textContent('#status'), /^(Loading|Opening)/);
      assert.equal(await viewer.page.locator('#progress').isVisible(), true);
      send();
    });
  });

  test('what cannot be loaded is told in a sentence, and nothing goes on', async () => {
    const cases = [
      [/\/worker-/, 'geodesic-voronoi [role=alert]', /^Nothing can be computed: the worker .+\.$/],
      [/worker_s/, 'geodesic-voronoi [role=alert]', /^Nothing can be computed: the worker .+\.$/],
      [/\/core-/, 'geodesic-voronoi [role=alert]', /^Nothing can be computed: .+core.+\.$/],
      [/\/main-/, '#error-text', /^The page cannot be loaded: .+ Reload it to try again\.$/],
    ];
    for (const [missing, place, sentence] of cases) {
      const viewer = await browser.visit({
        complaint: /ERR_FAILED/,
        prepare: (page) => page.route(missing, (route) => route.abort()),
      });
      const told = viewer.page.locator(place);
      await told.waitFor();
      assert.match(await told.textContent(), sentence);
      for (const hidden of ['#progress', '#caption']) {
        assert.equal(await viewer.page.locator(hidden).isVisible(), false, hidden);
      }
      assert.match(await viewer.page.textContent('#status'), /^No model is open\./);
      await viewer.close();
    }
  });

  test('no module imports the script of a worker', () =>
    assertWorkersAreNotImported(new URL('../../build/page/', import.meta.url).pathname));

  test('the sentence on the view says what can be done there', async () => {
    const viewer = await browser.open();
    const seen = () => viewer.page.locator('#caption').innerText();
    const press = (selector) =>
      viewer.page.evaluate((selector) => document.querySelector(selector).click(), selector);
    assert.match(await seen(), /^Click the model to add a site, or drag one\.$/m);
    await viewer.after('diagram', () => press('#clear'));
    assert.equal(await seen(), 'Click the model to add a site.');
    await press('#density-paint');
    assert.equal(await seen(), 'Drag on the model to paint, beside it to turn it.');
    await press('#density-paint');
    assert.equal(await seen(), 'Click the model to add a site.');
  });

  test('a library that could not be loaded is there for the next model', async () => {
    const viewer = await browser.visit({
      complaint: /ERR_FAILED/,
      prepare: (page) => page.route(/\/worker-/, (route) => route.abort()),
    });
    await viewer.page.locator('geodesic-voronoi [role=alert]').waitFor();
    await viewer.page.unroute(/\/worker-/);
    await viewer.after('diagram', () => viewer.page.selectOption('#samples', 'torus.glb'));
    assert.equal(await viewer.regionCount(), 60);
    assert.equal(await viewer.page.locator('#caption').isVisible(), true);
  });

  test('where the worker that draws cannot be had, the page makes what it draws', async () => {
    const isMissing = (page) => page.route(/drawing_worker/, (route) => route.abort());
    const receivesNone = (page) =>
      page.route(/drawing_worker/, (route) =>
        changedScript(route, () => {
          const { onmessage } = globalThis;
          globalThis.onmessage = (event) => {
            onmessage(event);
            const port = event.data;
            port.onmessage = () => port.dispatchEvent(new MessageEvent('messageerror'));
          };
        }),
      );
    const isSentNone = (page) =>
      page.addInitScript(() => {
        const { postMessage } = MessagePort.prototype;
        MessagePort.prototype.postMessage = function (message, ...transfer) {
          if (message?.args) throw new DOMException('out of memory', 'DataCloneError');
          postMessage.call(this, message, ...transfer);
        };
      });
    for (const prepare of [isMissing, receivesNone, isSentNone]) {
      const viewer = await browser.open({
        complaint: /ERR_FAILED|a message cannot be received/,
        prepare,
      });
      assert.equal(await viewer.regionCount(), 60);
      assert.ok((await viewer.coverage(await viewer.picture())) > 0.15);
      const place = await viewer.freePlace();
      await viewer.after('diagram', () => viewer.page.mouse.click(place.x, place.y));
      assert.equal(await viewer.siteCount(), 61);
    }
  });

  test('a link brings model, sites and view back; a damaged one is told of', async () => {
    const first = await browser.open({ hash: '#v=1&model=torus.glb&sites=12&seed=3' });
    assert.equal(await first.siteCount(), 12);
    const place = await first.freePlace();
    await first.after('diagram', () => first.page.mouse.click(place.x, place.y));
    // Two coordinates of ½ are both rounded up.
    await first.after('diagram', () =>
      first.evaluate((viewer) => viewer.addSite({ face: 7, bary: [0.5, 0.5, 0] })),
    );
    await first.page.locator('geodesic-voronoi canvas').focus();
    await first.page.keyboard.press('ArrowRight');
    await first.page.click('#share-button');
    const link = await first.page.locator('#share-link').inputValue();
    const { x, y } = await first.sitePosition(12);
    const code = first.page.locator('#code');
    await code.filter({ hasText: "fetch('torus-sites.json')" }).waitFor();
    assert.match(
      await code.textContent(),
      /^\/\/ Needs in its folder: torus-sites\.json \(Download, Sites\)\n/,
    );
    await first.page.getByText('Command', { exact: true }).click();
    await code.filter({ hasText: 'geodesic-voronoi diagram torus.glb' }).waitFor();
    const [, address] = (await code.textContent()).match(/^curl -LO '(.*)'$/m);
    assert.equal((await first.page.request.get(address)).status(), 200);

    const second = await browser.visit({ hash: new URL(link).hash });
    await second.haveSites(14);
    await second.settled();
    assert.equal(await second.regionCount(), 14);
    const same = await second.sitePosition(12);
    assert.ok(Math.hypot(same.x - x, same.y - y) < 1, `${same.x} ${same.y}, not ${x} ${y}`);
    assert.equal(await second.page.locator('#samples').inputValue(), 'torus.glb');
    assert.ok(
      await second.page.locator('#undo').isDisabled(),
      'the sites of the link are the first',
    );

    const ofFaceBeyond2To31 = '_____wAAAAA';
    for (const sites of ['AAAA////', ofFaceBeyond2To31]) {
      const damaged = await browser.visit({
        hash: `${new URL(link).hash.split('&at=')[0]}&at=${sites}`,
      });
      await damaged.page.locator('#error-text', { hasText: 'The link is damaged' }).waitFor();
      await damaged.settled();
      assert.equal(await damaged.siteCount(), 12);
    }

    const tooFine = await browser.visit({ hash: '#v=1&model=torus.glb&max-edge=0.0001' });
    await tooFine.page.getByText('torus.glb cannot be opened').waitFor();
    assert.equal(
      await tooFine.page.locator('#poster').isVisible(),
      false,
      'it is of another model',
    );
  });

  test('the download of the first model ends when it is given up', async () => {
    const viewer = await browser.visit({
      prepare: (page) => page.route('**/bunny.ply', () => {}), // which never answers
    });
    const ended = viewer.page.waitForEvent('requestfailed', {
      predicate: (request) => request.url().endsWith('bunny.ply'),
      timeout: 20_000,
    });
    await viewer.page.waitForFunction(
      () => document.querySelector('geodesic-voronoi').status === 'loading',
    );
    await viewer.page.keyboard.press('Escape');
    await ended;
    await viewer.page.locator('#status', { hasText: 'No model is open.' }).waitFor();
  });

  test('settings of a link that cannot be are told of, and the model opens without them', async () => {
    const impossible = [
      ...['sites=1e9', 'seed=1.5', 'sampling=foo', 'per-component=-1'],
      ...[
        'max-edge=2',
        'weld=bar',
        'orientation=up',
        'min-component=0.5',
        'metric=baz',
        'detail=99',
      ],
    ];
    const viewer = await browser.visit({ hash: `#v=1&model=torus.glb&${impossible.join('&')}` });
    await viewer.page.locator('#error-text', { hasText: 'The link is damaged' }).waitFor();
    await viewer.settled();
    assert.equal(
      await viewer.page.locator('#error-text').textContent(),
      `The link is damaged. These parts cannot be used: ${impossible.join(', ')}.`,
    );
    assert.equal(await viewer.regionCount(), 60);
  });

  test('a link of another version of the page is told of, and the page opens as without it', async () => {
    const viewer = await browser.visit({ hash: '#v=2&model=bunny.ply&sites=12' });
    await viewer.page
      .locator('#error-text', {
        hasText: 'The link was made by another version of this page, and is not used.',
      })
      .waitFor();
    await viewer.settled();
    assert.notEqual(await viewer.siteCount(), 12);
  });

  test('the address keeps what is chosen without pointer and keys, as by voice', async () => {
    const viewer = await browser.open({ hash: '#v=1&model=torus.glb&sites=12&seed=3' });
    await viewer.after('diagram', () => viewer.page.selectOption('#samples', 'bunny.ply'));
    await viewer.page.waitForURL(/model=bunny\.ply/, { timeout: 20_000 });
  });

  test('the address keeps what was done for reloading and coming back', async () => {
    const viewer = await browser.open({ hash: '#v=1&model=torus.glb&sites=12&seed=3' });
    const { page } = viewer;
    const steps = await page.evaluate(() => history.length);
    const kept = (pattern) => page.waitForURL(pattern);
    const same = async () => {
      const [before, { x, y }] = [await viewer.sites(), await viewer.sitePosition(12)];
      await page.reload();
      await viewer.haveSites(before.face.length);
      await viewer.settled();
      assert.deepEqual((await viewer.sites()).face, before.face);
      const now = await viewer.sitePosition(12);
      assert.ok(Math.hypot(now.x - x, now.y - y) < 1, `${now.x} ${now.y}, not ${x} ${y}`);
    };
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => page.mouse.click(place.x, place.y));
    await page.locator('geodesic-voronoi canvas').focus();
    await page.keyboard.press('ArrowRight');
    await page.evaluate(() => document.querySelector('input[value=dgpc]').click());
    await page.evaluate(() => document.querySelector('#layers [value=bisectors]').click());
    await kept(/metric=dgpc&.*layers=regions\+sites&.*at=/);
    await same();
    assert.equal(await page.isChecked('input[value=dgpc]'), true);
    assert.equal(await page.isChecked('#layers [value=bisectors]'), false);

    // Of a reloaded page, too.
    await page.locator('geodesic-voronoi canvas').focus();
    await page.keyboard.press('ArrowUp');
    await viewer.after('diagram', () =>
      page.evaluate(() => document.querySelector('#clear').click()),
    );
    await kept(/at=$/);
    assert.equal(await page.evaluate(() => history.length), steps, 'it is no step back');
    await page.goto('about:blank');
    await page.goBack();
    await viewer.settled();
    assert.equal(await viewer.siteCount(), 0);

    await viewer.after('diagram', async () => {
      await page.mouse.wheel(0, 1);
      await page.selectOption('#samples', 'bunny.ply');
    });
    await kept(/model=bunny\.ply/);
    // Another model is a step: the one before comes back with its sites, none here.
    await page.goBack();
    await page.locator('#status', { hasText: 'No sites' }).waitFor();
    assert.equal(await page.inputValue('#samples'), 'torus.glb');
    await page.goForward();
    await kept(/model=bunny\.ply/);
    await viewer.settled();
    await page.mouse.wheel(0, 1);
    await viewer.after('diagram', () => viewer.choose(ownFile));
    await kept(/model=mine\.glb/);
    // Nothing is asked as long as nothing was done.
    await page.reload();
    await page.locator('#note-text', { hasText: 'This link is of mine.glb' }).waitFor();
    await viewer.settled();
    await viewer.after('diagram', () => viewer.choose(ownFile));
    await page.waitForFunction(() => !document.querySelector('#panel').disabled);
    const free = await viewer.freePlace();
    await viewer.after('diagram', () => page.mouse.click(free.x, free.y));
    // Nor is it forgotten that something was, when the mesh is built otherwise.
    await viewer.after('diagram', () =>
      page.evaluate(() => document.querySelector('geodesic-voronoi').setAttribute('weld', '1e-6')),
    );
    await kept(/model=mine\.glb&.*weld=1e-6/);
    await viewer.after('diagram', () =>
      page.evaluate(() =>
        document.querySelector('geodesic-voronoi').setAttribute('max-edge', '0.1'),
      ),
    );
    await kept(/model=mine\.glb&.*max-edge=0\.1/);
    const own = await viewer.sites();
    /** Does what the page asks about, with this answer. */
    const asked = async (act, answer) => {
      const question = new Promise((resolve) => (viewer.answer = resolve));
      const acted = act();
      const dialog = await question;
      await dialog[answer]();
      await acted;
      return dialog;
    };
    const leaving = await asked(() => page.evaluate(() => history.back()), 'dismiss');
    assert.match(leaving.message(), /^Leave mine\.glb\?/);
    await kept(/model=mine\.glb&.*weld=1e-6/); // Stay: the address tells of what is shown.
    assert.deepEqual((await viewer.sites()).face, own.face);
    // Neither is it left for another model without a question.
    const chosen = await asked(() => page.selectOption('#samples', 'torus.glb'), 'dismiss');
    assert.match(chosen.message(), /^Leave mine\.glb\?/);
    assert.match(await page.locator('#samples option:checked').textContent(), /mine\.glb/);
    assert.deepEqual((await viewer.sites()).face, own.face);
    // The file is lost, and asked for again; its sites are not.
    const reloaded = await asked(() => page.reload(), 'accept');
    assert.equal(reloaded.type(), 'beforeunload');
    await page.locator('#note-text', { hasText: 'This link is of mine.glb' }).waitFor();
    await viewer.settled();
    await viewer.after('diagram', () => viewer.choose(ownFile));
    await viewer.haveSites(own.face.length);
    await viewer.settled();
    assert.deepEqual((await viewer.sites()).face, own.face);
  });

  test('what a link says of my own file applies to no other model, nor do settings to the next one', async () => {
    const hash =
      '#v=1&model=mine.glb&sites=12&min-component=60000&camera-orbit=9deg+9deg+9%25+1+1+1';
    const viewer = await browser.visit({ hash });
    const { page } = viewer;
    const attributes = (names) =>
      viewer.evaluate((element, names) => names.map((name) => element.getAttribute(name)), names);
    await viewer.settled();
    const note = page.locator('#note-text', { hasText: 'This link is of mine.glb' });
    await note.waitFor();
    assert.deepEqual(await attributes(['min-component', 'camera-orbit']), [null, null]);
    await viewer.after('diagram', () => page.selectOption('#samples', 'torus.glb'));
    assert.equal(await note.isVisible(), false);
    await viewer.evaluate((element) => element.setAttribute('up', 'z'));
    await viewer.after('diagram', () =>
      viewer.evaluate((element) => element.setAttribute('max-edge', '0.01')),
    );
    const finer = await viewer.evaluate(({ info }) => info.faces);
    await viewer.choose({ 'broken.glb': 'glTF' });
    await page.locator('#error-text', { hasText: 'broken.glb' }).waitFor();
    await page.click('#error-close');
    await viewer.settled();
    assert.deepEqual(await attributes(['up', 'max-edge']), ['z', '0.01']);
    assert.equal(await viewer.evaluate(({ info }) => info.faces), finer);
    await viewer.after('diagram', () => page.selectOption('#samples', 'hand.glb'));
    assert.deepEqual(await attributes(['up', 'max-edge']), [null, null]);
    await viewer.after('diagram', () => page.selectOption('#samples', 'torus.glb'));
    assert.ok((await viewer.evaluate(({ info }) => info.faces)) < finer);
    // The file itself is built as the link says, where that is possible.
    await viewer.choose(ownFile);
    await page.locator('#error-text', { hasText: 'no component has' }).waitFor();
    assert.match(await page.inputValue('#samples'), /^mine\.glb/);
  });

  test('a link of my own file brings its settings and its view back when that is opened', async () => {
    const hash =
      '#v=1&model=mine.glb&sites=12&detail=1&up=z&exploded=0.4&camera-orbit=9deg+80deg+90%25';
    const viewer = await browser.open({ hash });
    const settings = () =>
      viewer.evaluate((element) =>
        ['detail', 'up', 'exploded'].map((n) => element.getAttribute(n)),
      );
    assert.deepEqual(await settings(), [null, null, null]);
    await viewer.after('diagram', () => viewer.choose(ownFile));
    assert.deepEqual(await settings(), ['1', 'z', '0.4']);
    const [theta, phi, radius] = await viewer.evaluate((e) =>
      e.cameraOrbit.split(' ').map(parseFloat),
    );
    assert.ok(Math.abs(theta - 9) + Math.abs(phi - 80) + Math.abs(radius - 90) < 0.1);
  });

  test('an address stays as it was opened until something is done, and one of a file of my own', async () => {
    for (const hash of ['#v=1&model=torus.glb&sites=12&seed=3', '#v=1&model=mine.glb&at=AAAA']) {
      const viewer = await browser.open({ hash });
      if (hash.includes('mine')) {
        await viewer.page.mouse.click(200, 250);
        // The sample in place of that file is still none, made otherwise.
        await viewer.after('diagram', () =>
          viewer.evaluate((viewer) => viewer.setAttribute('weld', '1e-6')),
        );
      }
      await viewer.page.waitForTimeout(600);
      assert.equal(new URL(viewer.page.url()).hash, hash);
      await viewer.close();
    }
  });

  test('what a link does not hold is told; the exploded view is in it', async () => {
    const viewer = await browser.open({
      hash: '#v=1&model=torus.glb&sites=12&seed=3&exploded=0.4',
    });
    const { page } = viewer;
    assert.equal(await page.locator('#exploded').inputValue(), '40');
    const note = async () => {
      await page.click('#share-button');
      const text = await page.textContent('#share-note');
      const link = await page.inputValue('#share-link');
      await page.keyboard.press('Escape');
      return { text, link };
    };
    const whole = await note();
    assert.match(whole.text, /sees this model, these sites and this view/);
    assert.match(whole.link, /exploded=0\.4/);
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.sampleSites(2001)));
    const { text, link } = await note();
    assert.doesNotMatch(link, /&at=/);
    assert.match(
      text,
      /The link does not hold more than 2,000 sites: .* menu Download, has them all\./,
    );
    assert.doesNotMatch(text, /these sites/);
  });

  test('a link of a file of my own asks for it, and brings its sites back', async () => {
    const openFile = (viewer) => viewer.after('diagram', () => viewer.choose(ownFile));
    const first = await browser.open();
    await openFile(first);
    const place = await first.freePlace();
    await first.after('diagram', () => first.page.mouse.click(place.x, place.y));
    const { face } = await first.sites();
    await first.page.click('#share-button');
    const link = await first.page.locator('#share-link').inputValue();

    const second = await browser.visit({ hash: new URL(link).hash });
    await second.page.locator('#note-text', { hasText: 'This link is of mine.glb' }).waitFor();
    await second.settled();
    await openFile(second);
    await second.haveSites(face.length);
    await second.settled();
    assert.deepEqual((await second.sites()).face, face);
    const asking = second.page.locator('#note', { hasText: 'This link is of mine.glb' });
    assert.equal(await asking.isVisible(), false);
  });

  test('a frame that keeps scripts from the page says so, and so does a page without them', async () => {
    const framed = await browser.visit({
      path: 'framed.html',
      complaint: /CORS policy|ERR_FAILED/,
    });
    const sentence = framed.page.frameLocator('iframe').locator('#unstyled');
    await sentence.waitFor();
    assert.match(await sentence.textContent(), /it needs “allow-scripts allow-same-origin”\.$/);
    const { page } = await browser.visit({ javaScriptEnabled: false });
    assert.match(await page.locator('#status').textContent(), /which needs JavaScript$/);
    assert.equal(await page.locator('#unstyled').isVisible(), false);
  });

  test('a link that is pasted before the page is there opens its own model', async () => {
    let answer;
    const asked = new Promise((resolve) => (answer = resolve));
    const visiting = browser.visit({
      hash: '#v=1&model=torus.glb&sites=12&seed=3',
      prepare: (page) => page.route('**/main-*.js', (route) => answer({ page, route })),
    });
    const { page, route } = await asked;
    await page.evaluate(() => (location.hash = '#v=1&model=hand.glb&sites=12&seed=3'));
    await route.continue();
    const viewer = await visiting;
    await viewer.settled();
    const facesOf = ({ info }) => [info.origin.file, info.faces];
    const [name, faces] = await viewer.evaluate(facesOf);
    assert.equal(name, 'hand.glb');
    const other = await browser.open({ hash: '#v=1&model=hand.glb&sites=12&seed=3' });
    assert.equal(faces, (await other.evaluate(facesOf))[1]);
  });

  test('a link that is pasted where the page is open is followed', async () => {
    const viewer = await browser.open();
    await viewer.page.evaluate(() => {
      window.isOld = true;
      location.hash = '#v=1&model=torus.glb&sites=12&seed=3';
    });
    await viewer.page.waitForFunction(() => !window.isOld);
    await viewer.settled();
    assert.equal(await viewer.siteCount(), 12);
    assert.equal(await viewer.page.locator('#samples').inputValue(), 'torus.glb');
  });
});
