// SPDX-License-Identifier: MIT
//
// What the panel and the menus tell, and the parts of them that no other test uses.

import assert from 'node:assert/strict';
import { beforeEach, suite, test } from 'node:test';
import { glb, grid } from '../wasm/meshes.mjs';
import { torus } from '../../web/page/samples/shapes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

suite('the panel', () => {
  let viewer;
  beforeEach(async () => {
    viewer = await browser.open({
      viewport: { width: 1280, height: 720 },
      permissions: ['clipboard-read', 'clipboard-write'],
    });
  });

  const text = (selector) => viewer.page.locator(selector).textContent();
  const click = (selector) => viewer.page.click(selector);
  const open = (name, triangles) =>
    viewer.after('diagram', () => viewer.choose({ [name]: glb(triangles) }));
  const showGroup = (title) =>
    viewer.page.getByRole('heading', { name: title, exact: true }).click();

  test('at first sight nothing lies on the model, and the main controls are seen', async () => {
    for (const width of [1024, 1280]) {
      await viewer.page.setViewportSize({ width, height: 720 });
      await viewer.still();
      const caption = await viewer.page.locator('#caption').boundingBox();
      const hit = await viewer.surfaceIn(caption);
      assert.equal(hit, undefined, `in a window ${width} pixels wide`);
    }
    for (const selector of ['#cvt-play', '#cvt-move', '#count', '#sampling-form [type=submit]']) {
      const { y, height } = await viewer.page.locator(selector).boundingBox();
      assert.ok(y + height <= 720, `${selector} ends at ${y + height} of 720 pixels`);
    }
  });

  test('sites are selected in a list, which tells their regions', async () => {
    await viewer.page.getByText('List of 60 sites').click();
    const list = viewer.page.locator('#site-list');
    await list.locator('option').nth(59).waitFor({ state: 'attached' });
    assert.equal(await list.locator('option').count(), 60);
    await list.selectOption({ index: 12 });
    assert.equal(await viewer.evaluate(({ selected }) => selected), 12);
    assert.match(
      await text('geodesic-voronoi .unseen[role=status]'),
      /^Site 12 selected, of 60, region of area /,
    );
    await list.focus();
    await viewer.after('diagram', () => viewer.page.keyboard.press('Delete'));
    assert.equal(await list.locator('option').count(), 59);
    assert.equal(await viewer.evaluate(({ selected }) => selected), 12, 'the next one is selected');
    await list.selectOption({ index: 58 });
    await viewer.after('diagram', () => viewer.page.keyboard.press('Delete'));
    assert.equal(await viewer.evaluate(({ selected }) => selected), 57, 'or the last one');
    assert.equal(await list.evaluate(({ selectedIndex }) => selectedIndex), 57);
  });

  // A browser walks through all options to count them, or to find one after another has changed.
  test('a long list of sites is not counted for each of them', async () => {
    await viewer.page.getByText('List of 60 sites').click();
    await viewer.page.locator('#site-list option').nth(59).waitFor({ state: 'attached' });
    await viewer.page.evaluate(() => {
      window.counts = 0;
      for (const name of ['length', 'options']) {
        const { get, set } = Object.getOwnPropertyDescriptor(HTMLSelectElement.prototype, name);
        const counted = {
          get() {
            ++window.counts;
            return get.call(this);
          },
          ...(set && { set }),
        };
        Object.defineProperty(document.querySelector('#site-list'), name, counted);
      }
    });
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.removeSite(5)));
    await viewer.page.getByText('List of 59 sites').waitFor();
    assert.equal(await viewer.page.locator('#site-list option').count(), 59);
    const counts = await viewer.page.evaluate(() => window.counts);
    assert.ok(counts < 10, `${counts} times`);
  });

  test('of a long list of sites only what is seen is laid out, and it becomes short at once', async () => {
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.sampleSites(300)));
    await viewer.page.getByText('List of 300 sites').click();
    const options = viewer.page.locator('#site-list option');
    await options.nth(299).waitFor({ state: 'attached' });
    const visibility = (option) => getComputedStyle(option).contentVisibility;
    assert.equal(await options.last().evaluate(visibility), 'auto');
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.sampleSites(20)));
    const texts = await options.allTextContents();
    assert.equal(texts.length, 20);
    const areas = await viewer.evaluate(({ regionAreas }) => [...regionAreas]);
    texts.forEach((text, i) => {
      const area = Number(/^Site \d+, region of area ([\d.]+)$/.exec(text)[1]);
      assert.ok(Math.abs(area - areas[i]) < 0.01 * areas[i], text);
    });
  });

  test('what the diagram is made of and what its stages took is told', async () => {
    const diagram = await open('torus.glb', torus());
    await showGroup('Diagram');
    assert.equal(await text('#arc-count'), String(diagram.arcs));
    assert.equal(await text('#voronoi-point-count'), String(diagram.voronoiPoints));
    const shares = await viewer.evaluate(({ regionAreas: areas }) => {
      const mean = areas.reduce((sum, area) => sum + area) / areas.length;
      return [Math.min(...areas), Math.max(...areas)].map((area) => (area / mean).toFixed(2));
    });
    assert.equal(await text('#region-areas'), `${shares.join(' to ')} × mean`);
    await viewer.page.waitForFunction(() =>
      ['open', 'diagram', 'draw'].every((stage) =>
        /^[\d.]+\u00a0m?s$/.test(document.getElementById(`time-${stage}`).textContent),
      ),
    );
  });

  test('the report counts what was mended', async () => {
    const { positions, indices } = grid(4);
    // Three triangles at one edge, and one vertex twice.
    const edge = [indices[0], indices[1]];
    const apex = positions.length / 3;
    const faulty = {
      positions: [...positions, 0.1, 0.1, 1, 0.1, 0.1, -1],
      indices: [...indices, ...edge, apex, ...edge, apex + 1],
    };
    await open('faulty.glb', faulty);
    await showGroup('Model');
    assert.match(
      await text('#repairs'),
      /edges? of three or more triangles, where components are cut apart: no path leads across\./,
    );
    assert.match(await text('#report'), /Triangles34/);
  });

  test('debris of a scan is told of with what drops it, and notes of the reader are sentences', async () => {
    const { positions, indices } = torus(40, 20);
    const lines = [];
    for (let i = 0; i < positions.length; i += 3)
      lines.push(`v ${[...positions.slice(i, i + 3)].join(' ')}`);
    for (let i = 0; i < indices.length; i += 3)
      lines.push(`f ${[...indices.slice(i, i + 3)].map((v) => v + 1).join(' ')}`);
    lines.push('v 9 9 9', 'v 9.1 9 9', 'v 9 9.1 9', 'v 9.1 9.1 9', 'f -4 -3 -1 -2');
    await viewer.after('diagram', () => viewer.choose({ 'scan.obj': lines.join('\n') }));
    const note = viewer.page.locator('#bare-note', { hasText: '“Smallest component kept”' });
    await note.waitFor();
    assert.match(
      await note.textContent(),
      /^1 of 2 components, 0\.\d+ % of the area, has no site\./,
    );
    assert.match(await text('#repairs'), /1 polygon was cut into triangles\.$/);
  });

  test('fields of numbers say what they are of', async () => {
    assert.equal(await viewer.page.getByLabel('Number of sites', { exact: true }).count(), 1);
  });

  test('a field about components is there for models of several', async () => {
    const field = viewer.page.locator('#per-component');
    assert.equal(await field.isVisible(), false);
    await open('two.glb', {
      positions: [...grid(2).positions, ...grid(2).positions.map((x) => x + 5)],
      indices: [
        ...grid(2).indices,
        ...grid(2).indices.map((v) => v + grid(2).positions.length / 3),
      ],
    });
    assert.equal(await field.isVisible(), true);
  });

  test('F fits the model again; wheel and right drag zoom and shift', async () => {
    const orbit = () => viewer.evaluate(({ cameraOrbit }) => cameraOrbit);
    const first = await orbit();
    const box = await viewer.page.locator('geodesic-voronoi').boundingBox();
    const at = { x: box.x + 60, y: box.y + box.height - 60 };
    await viewer.page.mouse.move(at.x, at.y);
    await viewer.after('camera-change', () => viewer.page.mouse.wheel(0, -300));
    assert.notEqual(await orbit(), first);
    await viewer.after('camera-change', async () => {
      await viewer.page.mouse.down({ button: 'right' });
      await viewer.page.mouse.move(at.x + 80, at.y - 40, { steps: 4 });
      await viewer.page.mouse.up({ button: 'right' });
    });
    assert.ok((await orbit()).split(' ').length > 3, 'it looks elsewhere');
    await viewer.after('camera-change', () => viewer.page.keyboard.press('f'));
    assert.equal(await orbit(), first);
    assert.equal(await viewer.siteCount(), 60, 'nothing was added');
  });

  test('long work is seen to go on, and is given up by the button', async () => {
    await open('torus.glb', torus(320, 160));
    const before = await viewer.sites();
    const bar = viewer.page.locator('#progress-bar');
    await viewer.page.fill('#count', '8000');
    await viewer.page.selectOption('#sampling', 'farthest');
    // As soon as it is seen: the work would be done before a pointer presses it.
    await viewer.page.evaluate(() => {
      const cancel = document.getElementById('cancel');
      new MutationObserver(() => {
        if (globalThis.wasSeen || !cancel.checkVisibility()) return;
        globalThis.wasSeen = true;
        globalThis.told = document.getElementById('status').textContent;
        cancel.click();
      }).observe(document.getElementById('progress'), { attributeFilter: ['hidden'] });
    });
    await click('#sampling-form [type=submit]');
    await viewer.page.waitForFunction(() => globalThis.wasSeen);
    await viewer.settled();
    assert.equal(await bar.isVisible(), false);
    assert.equal(await viewer.page.evaluate(() => globalThis.told), 'Computing the diagram…');
    await viewer.page.locator('#status', { hasText: '60 regions, computed' }).waitFor();
    assert.deepEqual(await viewer.sites(), before);
    // What was given up is not compared with the next diagram.
    await viewer.after('diagram', () => viewer.set({ sites: { face: [0], bary: [1, 0, 0] } }));
    assert.equal(await viewer.page.locator('#note-text', { hasText: 'instead of' }).count(), 0);
  });

  test('what takes long to be drawn is marked until it is', async () => {
    await open('torus.glb', torus(320, 160));
    const busy = (selector) =>
      viewer.page.evaluate((selector) => document.querySelector(selector).ariaBusy, selector);
    const press = (selector, value) =>
      viewer.evaluate(
        (_, { selector, value }) => {
          const field = document.querySelector(selector);
          if (value) field.value = value;
          if (value) field.dispatchEvent(new Event('input'));
          else field.click();
          globalThis.marked = field.ariaBusy;
        },
        { selector, value },
      );
    for (const [type, selector, value] of [
      ['dual', '#layers [value=dual]'],
      ['distances', '#layers [value=distances]'],
      ['original', '#layers [value=original]'],
      ['exploded', '#exploded', 40],
    ]) {
      const detail = await viewer.after(type, () => press(selector, value));
      assert.ok(detail, type);
      assert.equal(await viewer.page.evaluate(() => globalThis.marked), 'true', type);
      assert.equal(await busy(selector), 'false', type);
    }
    await press('#exploded', 50);
    assert.equal(await viewer.page.evaluate(() => globalThis.marked), 'false', 'it is drawn');
    await press('#layers [value=dual]');
    assert.equal(
      await viewer.page.evaluate(() => globalThis.marked),
      'false',
      'it is not asked for',
    );
  });

  test('progress tells of drawing once all is computed', async () => {
    const told = await viewer.evaluate((viewer) => {
      const bar = document.getElementById('progress-bar');
      const label = document.getElementById('progress-label');
      const before = viewer.status;
      viewer.setAttribute('status', 'loading');
      const shown = [0.7, 1, 0.2].map((totalProgress) => {
        viewer.dispatchEvent(new CustomEvent('progress', { detail: { totalProgress } }));
        return [label.textContent, bar.hasAttribute('value') ? bar.value : undefined];
      });
      viewer.setAttribute('status', before);
      return shown.map(String);
    });
    assert.deepEqual(told, [
      'Opening the model,0.7',
      'Getting ready to draw,',
      'Opening the model,0.2',
    ]);
  });

  test('a model whose first diagram is cancelled has none, which is told, and gets one', async () => {
    await viewer.evaluate((viewer) => {
      // Before its diagram, which begins with the event.
      viewer.addEventListener('load', () => queueMicrotask(() => viewer.cancel()), { once: true });
    });
    await viewer.choose({ 'torus.glb': glb(torus(320, 160)) });
    const status = viewer.page.locator('#status', { hasText: 'No diagram' });
    await status.waitFor();
    await viewer.settled();
    assert.equal(await viewer.page.textContent('#arc-count'), '–');
    assert.equal(await viewer.page.textContent('#region-areas'), '–');
    assert.equal(await viewer.regionCount(), 0);
    await viewer.after('diagram', () => viewer.page.click('#note-action'));
    assert.equal(await viewer.page.locator('#note').isVisible(), false);
    await viewer.page.locator('#status', { hasText: 'regions, computed' }).waitFor();
  });

  test('a view without a diagram is not exploded: a click adds a site, and then it is', async () => {
    await viewer.evaluate((viewer) => {
      viewer.addEventListener('load', () => queueMicrotask(() => viewer.cancel()), { once: true });
      viewer.setAttribute('weld', '1e-7');
      viewer.exploded = 0.5;
    });
    const note = viewer.page.locator('#note-text', { hasText: 'was not computed to its end' });
    await note.waitFor();
    assert.equal(await viewer.page.locator('#exploded').isDisabled(), true);
    const { x, y } = await viewer.freePlace();
    const parts = await viewer.after('exploded', () => viewer.page.mouse.click(x, y));
    assert.equal(parts.regions, 61);
    assert.equal(await viewer.page.locator('#note').isVisible(), false);
    await viewer.page.mouse.click(x, y);
    await viewer.page.locator('#note-text', { hasText: 'in the exploded view' }).waitFor();
    assert.equal(await viewer.siteCount(), 61);
  });

  test('link and code are copied', async () => {
    await click('#share-button');
    await viewer.page.getByRole('region', { name: 'The same by code' }).waitFor();
    await click('#copy-link');
    const clipboard = () => viewer.page.evaluate(() => navigator.clipboard.readText());
    await viewer.page.locator('#copy-link', { hasText: 'Copied' }).waitFor();
    const link = await clipboard();
    assert.equal(link, await viewer.page.inputValue('#share-link'));
    assert.match(link, /#v=1&model=bunny\.ply/);
    const said = await viewer.page.evaluate(async () => {
      const button = document.querySelector('#copy-link');
      button.click(); // once more while it says so
      await new Promise((resolve) => setTimeout(resolve, 2000));
      return button.textContent;
    });
    assert.equal(said, 'Copy');
    for (const [form, pattern] of [
      ['script', /^\/\/ For a page\. .*\nimport \{ load \}/],
      ['element', /^<geodesic-voronoi src="http:.*\/samples\/bunny\.ply"/],
      ['command', /^curl -LO 'http:.*\/samples\/bunny\.ply'\ngeodesic-voronoi diagram bunny\.ply/],
    ]) {
      await viewer.page.locator(`input[name=code][value=${form}]`).check({ force: true });
      await viewer.page.locator('#code').filter({ hasText: pattern }).waitFor();
      await click('#copy-code');
      await viewer.page.locator('#copy-code', { hasText: 'Copied' }).waitFor();
      assert.match(await clipboard(), pattern);
    }
  });

  test('how sites were made is found out once for all forms of code, and no longer than the menu is open', async () => {
    await viewer.evaluate(({ mesh }) => {
      window.asked = [];
      const { sampleSites } = mesh;
      mesh.sampleSites = (count, options) => {
        window.asked.push(options.signal);
        return sampleSites.call(mesh, count, options);
      };
    });
    await click('#share-button');
    for (const form of ['element', 'command', 'script'])
      await viewer.page.locator(`input[name=code][value=${form}]`).check({ force: true });
    await viewer.page.locator('#copy-code:enabled').waitFor();
    await viewer.page.keyboard.press('Escape');
    await viewer.page.waitForFunction(() => window.asked[0].aborted);
    assert.equal(await viewer.page.evaluate(() => window.asked.length), 1);
  });

  test('without sites, no code is given: it would need the file of them, which cannot be downloaded', async () => {
    await viewer.after('diagram', () => click('#clear'));
    await click('#share-button');
    await viewer.page.locator('#code', { hasText: /^Without a site/ }).waitFor();
    assert.equal(await viewer.page.locator('#copy-code').isDisabled(), true);
    await viewer.page.keyboard.press('Escape');
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.undo()));
  });

  test('an error or a note takes the place of the caption', async () => {
    const caption = viewer.page.locator('#caption');
    assert.equal(await caption.isVisible(), true);
    await viewer.after('error', () => viewer.choose({ 'a.txt': 'a' }));
    assert.equal(await caption.isVisible(), false);
    await click('#error-close');
    assert.equal(await caption.isVisible(), true);
  });

  test('the view fills the screen and comes back', async () => {
    await click('#fullscreen');
    await viewer.page.waitForFunction(() => document.fullscreenElement?.id === 'view');
    await click('#fullscreen');
    await viewer.page.waitForFunction(() => document.fullscreenElement === null);
  });
});

test('fields that a browser fills again say what the element does', async () => {
  // As Firefox does once the document of a reloaded page is there.
  const fill = () => {
    document.addEventListener('readystatechange', () => {
      if (document.readyState !== 'interactive') return;
      for (const field of document.querySelectorAll('#panel :is(select, [type=number])')) {
        if ([field, field.form].some((each) => each?.autocomplete === 'off')) continue;
        if (field.localName === 'select') field.selectedIndex = 1;
        else field.value = '7';
      }
    });
  };
  const filled = await browser.open({ prepare: (page) => page.addInitScript(fill) });
  const { told, done } = await filled.evaluate((viewer) => {
    const fields = [...document.querySelectorAll('#panel :is(select:not([size]), [type=number])')];
    const chosen = (options) => [...options].find((each) => each.defaultSelected) ?? options[0];
    const initial = ({ defaultValue, options }) => defaultValue ?? chosen(options).value;
    const attribute = ({ id }) => viewer.getAttribute(id === 'count' ? 'sites' : id);
    return {
      told: fields.map(({ id, value }) => [id, value]),
      done: fields.map((field) => [field.id, attribute(field) ?? initial(field)]),
    };
  });
  assert.ok(told.length > 10);
  assert.deepEqual(told, done);
});
