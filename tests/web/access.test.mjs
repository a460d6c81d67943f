// SPDX-License-Identifier: MIT
//
// The page by axe-core, at the sizes and in the colours that people use.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { suite, test } from 'node:test';
import { torus } from '../../web/page/samples/shapes.mjs';
import { glb } from '../wasm/meshes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

suite('access', () => {
  const violations = (page) =>
    page.evaluate(async () => {
      const { violations } = await window.axe.run();
      return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target}`));
    });
  const openEverything = (page) =>
    page.evaluate(() => {
      for (const group of document.querySelectorAll('details')) group.open = true;
      document.querySelector('#panel').hidden = false;
    });

  test('axe finds nothing at any size, in light, dark and the system’s colours', async () => {
    const viewer = await browser.open({ viewport: { width: 1280, height: 720 } });
    const { page } = viewer;
    await page.evaluate(axe);
    await openEverything(page);
    const colours = [
      { colorScheme: 'light', forcedColors: 'none' },
      { colorScheme: 'dark', forcedColors: 'none' },
      { colorScheme: 'light', forcedColors: 'active' },
    ];
    for (const width of [1280, 768, 390]) {
      await page.setViewportSize({ width, height: 720 });
      await openEverything(page);
      for (const media of colours) {
        await page.emulateMedia(media);
        assert.deepEqual(await violations(page), [], `${width} ${JSON.stringify(media)}`);
      }
    }
    await page.emulateMedia({ colorScheme: 'light', forcedColors: 'none' });
    await page.setViewportSize({ width: 1280, height: 720 });
    for (const menu of ['download', 'share']) {
      await page.click(`#${menu}-button`);
      assert.deepEqual(await violations(page), [], menu);
      await page.keyboard.press('Escape');
      assert.equal(await page.locator(`#${menu}`).isVisible(), false, 'Escape closes it');
    }
    await page.click('#help-button');
    assert.deepEqual(await violations(page), [], 'help');
  });

  test('in a low window no button on the view is covered or cut off', async () => {
    for (const [width, height, isMobile] of [
      [640, 360, true],
      [844, 390, true],
      [720, 450, false],
      [1000, 300, false],
    ]) {
      const viewer = await browser.open({
        viewport: { width, height },
        hasTouch: isMobile,
        isMobile,
      });
      const covered = await viewer.page.evaluate(() =>
        [...document.querySelectorAll('#toolbar button')]
          .filter((button) => button.checkVisibility())
          .filter((button) => {
            const { left, right, top, bottom } = button.getBoundingClientRect();
            const places = [top + 2, bottom - 2].map((y) => [(left + right) / 2, y]);
            return !places.every(([x, y]) => document.elementFromPoint(x, y)?.closest('#toolbar'));
          })
          .map(({ id }) => id),
      );
      assert.deepEqual(covered, [], `${width} × ${height}`);
      await viewer.close();
    }
  });

  test('on a phone everything to press is 44 pixels high, and a tap reads a region', async () => {
    const viewer = await browser.open({ viewport: { width: 390, height: 640 }, hasTouch: true });
    const { page } = viewer;
    await openEverything(page);
    const small = await page.evaluate(() =>
      [...document.querySelectorAll('button, select, input, summary, .chips span, .segments span')]
        .filter((element) => !element.matches('.chips input, .segments input'))
        .map((element) => ({
          name: element.id || element.textContent,
          box: element.getBoundingClientRect(),
        }))
        .filter(({ box }) => box.height > 0 && Math.round(box.height) < 44)
        .map(({ name, box }) => `${name}: ${box.height}`),
    );
    assert.deepEqual(small, []);
    await page.evaluate(() => {
      document.querySelector('#panel').hidden = true;
    });
    await viewer.drawn(); // The view grows with the next frame.
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => page.touchscreen.tap(place.x, place.y));
    await page.locator('#readout-text', { hasText: /Region 60 .* · 0 from its site/ }).waitFor();
  });

  test('nothing is cut off, however wide the window', async () => {
    const viewer = await browser.open();
    await openEverything(viewer.page);
    await viewer.page.evaluate(() => {
      for (const id of ['density-settings', 'per-component-label', 'repair'])
        document.getElementById(id).hidden = false;
    });
    for (const width of [320, 460, 640, 760, 761, 900, 1200, 1201, 1440]) {
      await viewer.page.setViewportSize({ width, height: width === 640 ? 400 : 560 });
      const reached = await viewer.page.evaluate(() =>
        Math.max(
          ...[...document.querySelectorAll('header *, main, aside')].map(
            (element) => element.getBoundingClientRect().right,
          ),
        ),
      );
      assert.ok(reached <= width, `${reached} of ${width} pixels`);
      const wide = await viewer.page.evaluate(() => {
        const panel = document.getElementById('panel');
        const right = panel.querySelector('.group').getBoundingClientRect().right;
        return [...panel.querySelectorAll('button, select, input')]
          .filter((element) => element.getBoundingClientRect().right > right + 0.5)
          .map(({ id }) => id);
      });
      assert.deepEqual(wide, [], `at ${width}`);
      const samples = await viewer.page.locator('#samples').boundingBox();
      assert.ok(samples.width >= 80, `${samples.width} pixels for the model's name at ${width}`);
    }
  });

  test('text of twice the size is not cut off in the curve and the menus', async () => {
    const viewer = await browser.open({ viewport: { width: 390, height: 844 } });
    const { page } = viewer;
    await page.evaluate(() => {
      document.documentElement.style.fontSize = '32px';
      document.querySelector('#panel').hidden = false;
    });
    const cutOff = (parts, whole) =>
      page.evaluate(
        ([parts, whole]) => {
          const { left, right } = document.querySelector(whole).getBoundingClientRect();
          return [...document.querySelectorAll(`${whole} ${parts}`)]
            .filter((part) => {
              const box = part.getBoundingClientRect();
              return box.left < left || box.right > right;
            })
            .map((part) => part.id || part.textContent);
        },
        [parts, whole],
      );
    assert.deepEqual(await cutOff('text', '#cvt-curve'), []);
    await page.evaluate(() => document.querySelector('#download').showPopover());
    assert.deepEqual(await cutOff('button', '#download'), []);
  });

  test('in a low window the controls are beside the view, unless it is narrow, too', async () => {
    const viewer = await browser.open({ viewport: { width: 740, height: 360 } });
    const panel = viewer.page.locator('#panel');
    const view = viewer.page.locator('geodesic-voronoi');
    for (const [width, height, isBeside] of [
      [667, 375, true],
      [375, 667, false],
      [640, 400, true],
      [320, 256, false],
    ]) {
      await viewer.page.setViewportSize({ width, height });
      await panel.waitFor({ state: isBeside ? 'visible' : 'hidden' });
      const { width: across, height: down } = await view.boundingBox();
      if (isBeside) assert.ok(across >= 380 && down > 0.8 * height, `${across} × ${down}`);
      else assert.equal(across, width);
    }
    // The last one is of a page that is zoomed by four: it scrolls, so that all of it can be seen.
    for (const isOpen of [false, true]) {
      if (isOpen) await viewer.page.click('#sheet');
      const heights = await viewer.page.evaluate(() => {
        const box = (selector) => document.querySelector(selector).getBoundingClientRect();
        return { view: box('aside').top - box('header').bottom, panel: box('#panel').height };
      });
      assert.ok(heights.view > (isOpen ? 70 : 180), `${heights.view} of the view are seen`);
      assert.ok(!isOpen || heights.panel > 120, `${heights.panel} of the panel are seen`);
    }
  });

  test('long work can be given up on a phone, also beside the open sheet', async () => {
    for (const viewport of [
      { width: 360, height: 740 },
      { width: 320, height: 568 },
    ]) {
      const viewer = await browser.open({ viewport });
      await viewer.page.evaluate(() => {
        document.getElementById('progress-label').textContent = 'Computing the diagram';
        document.getElementById('progress').hidden = false;
      });
      const { page } = viewer;
      for (const isOpen of [false, true]) {
        if (isOpen) await page.locator('#sheet').press('Enter');
        for (const id of ['progress', 'cancel']) {
          const { x, width } = await page.locator(`#${id}`).boundingBox();
          assert.ok(x >= 0 && x + width <= viewport.width, `${id} from ${x} to ${x + width}`);
        }
        await page.locator('#cancel').click({ trial: true, timeout: 5000 });
      }
      await viewer.close();
    }
  });

  test('density that is painted by a key is announced, and that it is gone', async () => {
    const viewer = await browser.open();
    await viewer.evaluate((viewer) => viewer.setAttribute('tool', 'density'));
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    for (const [key, told] of [
      ['Enter', 'Density painted'],
      ['Control+z', 'No density is painted'],
    ]) {
      await viewer.page.keyboard.press(key);
      await viewer.page
        .locator('geodesic-voronoi .unseen[role=status]', { hasText: told })
        .waitFor({ state: 'attached', timeout: 20_000 });
    }
  });

  test('keys that press buttons are announced', async () => {
    const viewer = await browser.open();
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    for (const [key, told] of [
      ['u', 'Upward axis: Z'],
      ['h', 'Hide the controls, pressed'],
      ['h', 'Hide the controls, not pressed'],
    ]) {
      await viewer.page.keyboard.press(key);
      await viewer.page
        .locator('[role=status]', { hasText: new RegExp(`^${told}$`) })
        .waitFor({ state: 'attached', timeout: 5000 });
    }
  });

  test('on a phone an error and a note do not cover the model together', async () => {
    const viewer = await browser.open({ viewport: { width: 390, height: 844 }, hasTouch: true });
    const { page } = viewer;
    await viewer.after('exploded', () => viewer.set({ exploded: 0.5 }));
    const { x, y, width, height } = await page.locator('#viewer').boundingBox();
    await page.touchscreen.tap(x + width / 2, y + height / 2);
    const note = page.locator('#note');
    await note.waitFor();
    await viewer.after('error', () => viewer.choose({ 'a.txt': 'a' }));
    await page.locator('#error').waitFor();
    assert.equal(await note.isVisible(), false);
    await page.click('#error-close');
    assert.equal(await note.isVisible(), true);
  });

  test('readout, scale of distances and toolbar lie side by side', async () => {
    for (const [width, height] of [
      [844, 390],
      [390, 844],
      [1280, 720],
    ]) {
      const viewer = await browser.open({ viewport: { width, height } });
      await viewer.set({ layers: ['distances', 'sites'] });
      const shown = ['#readout', 'geodesic-voronoi [part=distances]', '#toolbar'].map((selector) =>
        viewer.page.locator(selector),
      );
      const { x, y } = await viewer.freePlace();
      await viewer.page.mouse.move(x, y);
      for (const each of shown) await each.waitFor();
      const boxes = await Promise.all(shown.map((each) => each.boundingBox()));
      boxes.forEach((a, i) =>
        boxes.slice(0, i).forEach((b) => {
          const isBeside = a.x >= b.x + b.width || b.x >= a.x + a.width;
          const isAbove = a.y >= b.y + b.height || b.y >= a.y + a.height;
          assert.ok(isBeside || isAbove, `${width} × ${height}: ${JSON.stringify([a, b])}`);
        }),
      );
      await viewer.close();
    }
  });

  test('the element takes the focus as a whole', async () => {
    const viewer = await browser.open();
    await viewer.evaluate((viewer) => viewer.focus());
    await viewer.after('diagram', () => viewer.page.keyboard.press('Enter'));
    assert.equal(await viewer.siteCount(), 61);
  });

  test('the focus goes on to a neighbour of a button that is disabled or hidden', async () => {
    const viewer = await browser.open({ viewport: { width: 1280, height: 720 } });
    const { page } = viewer;
    const focused = () =>
      page.evaluate(() => document.activeElement.id || document.activeElement.textContent);
    const then = async (act) => {
      await act();
      // The browser takes the focus away when it draws.
      await page.evaluate(
        () => new Promise((done) => requestAnimationFrame(() => setTimeout(done))),
      );
      return focused();
    };
    const press = async (selector) => {
      await page.focus(selector);
      return then(() => page.keyboard.press('Enter'));
    };
    await page.focus('geodesic-voronoi canvas');
    await viewer.after('diagram', () => page.keyboard.press('Enter'));
    assert.equal(await press('#remove'), 'undo');
    await viewer.settled();
    await viewer.after('diagram', () => page.click('#undo'));
    assert.equal(await press('#undo'), 'redo');
    await viewer.settled();
    assert.equal(await press('#clear'), 'Place new sites');
    await viewer.settled();
    // Clicked as in Safari, where a click leaves the focus where it is.
    await page.focus('#layers input');
    const hide = () => page.evaluate(() => document.querySelector('#hide-panel').click());
    assert.equal(await then(hide), 'hide-panel');
    assert.equal(await press('#hide-panel'), 'hide-panel');
    await viewer.after('error', () => viewer.choose({ 'a.txt': 'a' }));
    assert.equal(await press('#error-close'), 'viewer', 'its canvas');
  });

  test('in a small window the model is beside the toolbar, and the legend is small', async () => {
    const viewer = await browser.open({ viewport: { width: 800, height: 600 } });
    const { positions, indices } = torus();
    const long = { positions: positions.map((x, i) => (i % 3 === 0 ? 3 * x : x)), indices };
    await viewer.after('diagram', () => viewer.choose({ 'long.glb': glb(long) }));
    for (const width of [1280, 1150, 1024, 800]) {
      await viewer.page.setViewportSize({ width, height: 600 });
      await viewer.still();
      const toolbar = await viewer.page.locator('#toolbar').boundingBox();
      assert.equal(await viewer.surfaceIn(toolbar), undefined, `in a window ${width} pixels wide`);
    }
    await viewer.set({ layers: ['distances', 'sites'] });
    const legend = viewer.page.locator('geodesic-voronoi [part=distances]');
    await legend.waitFor();
    const view = await viewer.page.locator('geodesic-voronoi').boundingBox();
    const box = await legend.boundingBox();
    const share = (box.width * box.height) / (view.width * view.height);
    assert.ok(share < 0.05, `${share} of the view is the legend's`);
  });

  test('a note has room for its words beside its buttons, or above them', async () => {
    const phone = { hasTouch: true, isMobile: true };
    const viewer = await browser.open({ viewport: { width: 844, height: 390 }, ...phone });
    await viewer.after('exploded', () => viewer.set({ exploded: 0.5 }));
    const { x, y, width, height } = await viewer.page.locator('#viewer').boundingBox();
    await viewer.page.touchscreen.tap(x + width / 2, y + height / 2);
    const text = viewer.page.locator('#note-text', { hasText: 'in the exploded view' });
    await text.waitFor();
    for (const width of [844, 667, 390, 320]) {
      await viewer.page.setViewportSize({ width, height: 390 });
      const box = await text.boundingBox();
      assert.ok(box.width > 100, `${box.width} pixels in a window ${width} pixels wide`);
    }
  });

  test('why there is no model is told beside the toolbar', async () => {
    const viewer = await browser.visit({
      complaint: /ERR_FAILED/,
      prepare: (page) => page.route('**/*.ply', (route) => route.abort()),
    });
    const message = viewer.page.locator('geodesic-voronoi [part=message]');
    await message.waitFor();
    await message.evaluate((p) =>
      p.append(' The sentence is as long as there is room for.'.repeat(3)),
    );
    for (const width of [1280, 800, 390]) {
      await viewer.page.setViewportSize({ width, height: 600 });
      const { x } = await message.boundingBox();
      const toolbar = await viewer.page.locator('#toolbar').boundingBox();
      assert.ok(x >= toolbar.x + toolbar.width, `in a window ${width} pixels wide`);
    }
  });

  test('the legend of distances does not lie on the first model', async () => {
    const viewer = await browser.open();
    await viewer.set({ layers: ['distances', 'sites'] });
    const legend = viewer.page.locator('geodesic-voronoi [part=distances]');
    await legend.waitFor();
    for (const [width, height] of [
      [1440, 900],
      [1280, 720],
      [1100, 768],
      [1024, 768],
      [390, 844],
    ]) {
      await viewer.page.setViewportSize({ width, height });
      await viewer.still();
      const hit = await viewer.surfaceIn(await legend.boundingBox());
      assert.equal(hit, undefined, `in a window ${width} pixels wide`);
    }
  });

  test('what is chosen is seen in the system’s colours', async () => {
    const viewer = await browser.open({ forcedColors: 'active' });
    const [on, off] = await viewer.page.evaluate(() =>
      [':checked', ':not(:checked)'].map((state) => {
        const chip = document.querySelector(`#layers input${state} + span`);
        return getComputedStyle(chip).backgroundColor;
      }),
    );
    assert.notEqual(on, off);
    await viewer.set({ layers: ['distances'] });
    const scale = viewer.page.locator('geodesic-voronoi .distances .scale');
    await scale.waitFor();
    assert.match(
      await scale.evaluate((scale) => getComputedStyle(scale).backgroundImage),
      /^linear-gradient/,
      'a scale of distances has its colours',
    );
  });
});
