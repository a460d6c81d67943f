// SPDX-License-Identifier: MIT
//
// Editing and looking, as a person does it: by the toolbar, by keys, while a tessellation plays.

import assert from 'node:assert/strict';
import { beforeEach, suite, test } from 'node:test';
import { glb } from '../wasm/meshes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

suite('hands', () => {
  let viewer;
  beforeEach(async () => {
    viewer = await browser.open();
  });

  const press = (key) => viewer.page.keyboard.press(key);
  const focus = () => viewer.page.locator('geodesic-voronoi canvas').focus();
  const changedSince = async (picture) =>
    (await viewer.difference(picture, await viewer.picture())).count;

  test('the toolbar fits the model, turns another axis up, and makes room for the view', async () => {
    const upright = await viewer.picture();
    await viewer.page.click('#up');
    assert.equal(await viewer.page.getAttribute('#up', 'aria-label'), 'Upward axis: Z');
    assert.ok((await changedSince(upright)) > 500, 'it lies on its side');
    await press('u');
    await press('u');
    assert.equal(await viewer.page.getAttribute('#up', 'aria-label'), 'Upward axis: Y');
    assert.equal(await changedSince(upright), 0);

    // Characters outside the view are no commands: dictation types them.
    await viewer.page.focus('#cvt-play');
    for (const key of ['u', 'h', '?']) await press(key);
    assert.equal(await viewer.page.getAttribute('#up', 'aria-label'), 'Upward axis: Y');
    assert.equal(await viewer.page.getAttribute('#hide-panel', 'aria-pressed'), 'false');
    assert.equal(await viewer.page.locator('#help').isVisible(), false);

    await focus();
    await press('ArrowRight');
    await press('+');
    assert.ok((await changedSince(upright)) > 500);
    await viewer.page.click('#fit');
    assert.equal(await changedSince(upright), 0);

    const covered = await viewer.coverage(upright);
    const wide = await viewer.page.locator('geodesic-voronoi').boundingBox();
    await viewer.page.setViewportSize({ width: 800, height: 760 });
    await viewer.page.waitForFunction(
      (height) => document.querySelector('geodesic-voronoi').clientHeight > height,
      wide.height,
    );
    const grown = await viewer.coverage(await viewer.picture());
    assert.ok(grown > 0.7 * covered, `it fills the view again: ${grown}, ${covered} before`);
  });

  test('zooming comes ever nearer to the surface, and not through it', async () => {
    const { x, y, width, height } = await viewer.page.locator('geodesic-voronoi').boundingBox();
    const corner = (place) =>
      viewer.evaluate((element, { x, y }) => {
        const { face } = element.surfaceFromPoint(x, y);
        const vertex = element.mesh.indices[3 * face];
        return [...element.mesh.positions.subarray(3 * vertex, 3 * vertex + 3)];
      }, place);
    const diagonal = await viewer.evaluate(({ info }) => info.boundingDiagonal);
    const [left, right, top, bottom] = await viewer.evaluate((viewer) => {
      const style = getComputedStyle(viewer);
      const sides = ['left', 'right', 'top', 'bottom'];
      return sides.map((side) => parseFloat(style.getPropertyValue(`padding-${side}`)));
    });
    const middle = { x: x + (left + width - right) / 2, y: y + (top + height - bottom) / 2 };
    const aside = { x: middle.x - 40, y: middle.y + 30 };
    for (const [place, zoom] of [
      [aside, () => viewer.page.mouse.wheel(0, -400)],
      [middle, () => press('+')],
    ]) {
      await viewer.page.click('#fit');
      const before = await corner(place);
      await focus();
      await viewer.page.mouse.move(place.x, place.y);
      for (let i = 0; i < 20; ++i) await viewer.after('camera-change', zoom);
      const after = await corner(place);
      const distance = Math.hypot(...after.map((c, k) => c - before[k]));
      assert.ok(distance < 0.03 * diagonal, `${before} became ${after}`);
    }
  });

  test('an edit while a tessellation plays is a step of its own, and it goes on', async () => {
    const before = await viewer.sites();
    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', 500));
    const reached = (iteration) =>
      viewer.after('cvt-iteration', () =>
        viewer.page.waitForFunction(
          (iteration) => Number(document.querySelector('#cvt-iteration').textContent) >= iteration,
          iteration,
        ),
      );
    viewer.settled = async () => {};
    await viewer.page.evaluate(() => document.querySelector('#cvt-play').click());
    await reached(2);
    await viewer.evaluate((viewer) => viewer.addSite({ face: 5, bary: [0.2, 0.3, 0.5] }));
    assert.equal(await viewer.evaluate(({ cvtStatus }) => cvtStatus), 'running');
    await reached(2);
    assert.equal(await viewer.siteCount(), 61);
    await viewer.evaluate((viewer) => viewer.removeSite(3));
    await reached(2);
    assert.equal(await viewer.siteCount(), 60);
    await viewer.page.evaluate(() => document.querySelector('#cvt-play').click());
    await viewer.page.locator('#cvt-state', { hasText: 'Paused' }).waitFor();
    // Played, removed, played, added, played.
    for (const count of [60, 61, 61, 60, 60]) {
      await viewer.evaluate((viewer) => viewer.undo());
      assert.equal(await viewer.siteCount(), count);
    }
    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await viewer.page.locator('#undo').isDisabled(), true);
  });

  test('sites on the far side of a thin plate are neither seen nor hit', async () => {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7];
    const plate = {
      positions: corners.flatMap((i) => [(i & 1) * 10, ((i >> 1) & 1) * 6, (i >> 2) * 0.05]),
      indices: [
        ...[0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4],
        ...[2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5],
      ],
    };
    await viewer.after('diagram', () => viewer.choose({ 'plate.glb': glb(plate) }));
    const seen = await viewer.evaluate(async (viewer) => {
      const places = await viewer.mesh.positionsOf(viewer.sites);
      const sites = [...viewer.sites.face.keys()];
      const on = (z) => sites.filter((i) => Math.abs(places[3 * i + 2] - z) < 1e-9);
      return [0, 0.05].map((z) => on(z).map((i) => Boolean(viewer.sitePosition(i))));
    });
    const [back, front] = seen[0].includes(true) ? seen.reverse() : seen;
    assert.ok(back.length > 10 && front.length > 10);
    assert.ok(back.every((isSeen) => !isSeen));
    assert.ok(front.every(Boolean));
  });

  test('a site that is selected turns into view, is told of, and moves by keys', async () => {
    const hidden = await viewer.evaluate((viewer) =>
      [...viewer.sites.face.keys()].find((i) => !viewer.sitePosition(i)),
    );
    await viewer.set({ selected: hidden });
    assert.ok(await viewer.sitePosition(hidden), 'it is seen now');
    const told = new RegExp(`Site ${hidden} selected, of 60, region of area`);
    await viewer.page
      .locator('geodesic-voronoi .unseen[role=status]', { hasText: told })
      .waitFor({ state: 'attached' });
    const label = await viewer.page.locator('geodesic-voronoi canvas').getAttribute('aria-label');
    assert.match(label, new RegExp(`site ${hidden} is selected, of 60`));

    await focus();
    const from = await viewer.sitePosition(hidden);
    await viewer.after('diagram', () => press('Shift+ArrowRight'));
    const to = await viewer.sitePosition(hidden);
    assert.ok(Math.abs(to.x - from.x - 8) < 1 && Math.abs(to.y - from.y) < 1, `${to.x - from.x}`);

    // Steps of one site by keys are one to undo, until there is another act.
    const first = await viewer.sites();
    await viewer.after('diagram', () => press('Shift+ArrowLeft'));
    await viewer.after('diagram', () => press('Shift+ArrowUp'));
    const { x, y } = await viewer.freePlace();
    await viewer.after('diagram', () => viewer.page.mouse.click(x, y));
    await focus();
    await viewer.set({ selected: hidden });
    await viewer.after('diagram', () => press('Shift+ArrowDown'));
    for (const count of [61, 60]) {
      await viewer.after('diagram', () => press('Control+z'));
      assert.equal(await viewer.siteCount(), count);
    }
    assert.notDeepEqual(await viewer.sites(), first);
    await viewer.after('diagram', () => press('Control+z'));
    assert.equal(await viewer.page.locator('#undo').isDisabled(), true);
  });

  test('what is under the pointer is told again when the model turns or a site is dragged', async () => {
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => viewer.page.mouse.click(place.x, place.y));
    await viewer.after('hover', () => viewer.page.mouse.move(place.x + 1, place.y));
    await viewer.page.mouse.down();
    const dragged = await viewer.after('hover', () =>
      viewer.page.mouse.move(place.x + 10, place.y + 6),
    );
    assert.equal(dragged.region, 60, 'the region that is dragged');
    await viewer.page.mouse.up();
    await viewer.settled();
    await viewer.after('hover', () => viewer.page.mouse.wheel(0, -200));
  });

  test('Enter beside the model says why it adds nothing', async () => {
    await viewer.set({ cameraOrbit: '0deg 75deg 105% 2 0 0' });
    await viewer.page.locator('geodesic-voronoi canvas').focus();
    await viewer.page.keyboard.press('Enter');
    await viewer.page.getByText('The model is not at the centre of the view').waitFor();
    assert.equal(await viewer.siteCount(), 60);
  });

  test('the exploded view of a turned model fills the view, is not edited, and ends to play', async () => {
    const turned = await viewer.evaluate((viewer) => {
      viewer.perform('turn-left');
      return viewer.cameraOrbit;
    });
    await viewer.after('exploded', () => viewer.page.locator('#exploded').fill('80'));
    const edge = await viewer.evaluate(async (viewer) => {
      const { data, width } = await window.pixelsOf(await viewer.toBlob());
      return data.subarray(0, 4 * 2 * width).filter((alpha, i) => i % 4 === 3 && alpha > 0).length;
    });
    assert.equal(edge, 0, 'nothing is cut off at the top');
    assert.equal(await viewer.evaluate(({ cameraOrbit }) => cameraOrbit), turned);
    const { x, y, width, height } = await viewer.page.locator('geodesic-voronoi').boundingBox();
    await viewer.page.mouse.click(x + width / 2, y + height / 2);
    await viewer.page.locator('#note-text', { hasText: 'in the exploded view' }).waitFor();
    assert.equal(await viewer.siteCount(), 60);
    await viewer.set({ selected: 7 });
    for (const key of ['Enter', 'Delete', 'Shift+ArrowLeft']) {
      const hint = viewer.page.locator('geodesic-voronoi [part=hint]');
      await hint.evaluate((hint) => hint.replaceChildren());
      await viewer.page.keyboard.press(key);
      await hint.getByText('No site can be edited in the exploded view').waitFor();
    }
    assert.equal(await viewer.siteCount(), 60);
    const layers = viewer.page.locator('#layers input');
    assert.ok(await layers.first().isDisabled(), 'it shows no other layer');
    await viewer.page.evaluate(() => document.querySelector('#cvt-step').click());
    await viewer.page.locator('#cvt-iteration', { hasText: '1' }).waitFor();
    assert.equal(await viewer.page.locator('#exploded').inputValue(), '0');
    assert.equal(await viewer.page.locator('#note').isVisible(), false, 'it is no longer true');
    assert.ok(await layers.first().isEnabled());
  });

  test('a click whose work fails is told of, unless its model is gone', async () => {
    await viewer.page.getByText('Smaller regions in places').click();
    const clickAfter = (properties) =>
      viewer.evaluate((viewer, properties) => {
        viewer.mesh.curvatureDensity = async () => {
          throw Object.assign(new Error('there is not enough memory'), properties);
        };
        document.getElementById('density-curvature').click();
      }, properties);
    const error = viewer.page.locator('#error-text');
    await clickAfter({ code: 'disposed' });
    await viewer.page.waitForTimeout(50);
    assert.equal(await error.isVisible(), false);
    await clickAfter({});
    await error.filter({ hasText: /^The curvature cannot be computed: .* memory\.$/ }).waitFor();
  });

  test('too few vertices for places far apart, and a model that will not fit, are told of', async () => {
    await viewer.after('diagram', () => viewer.page.selectOption('#samples', 'hand.glb'));
    await viewer.page.fill('#count', '3000');
    await viewer.page.selectOption('#sampling', 'farthest');
    await viewer.after('diagram', () => viewer.page.click('#sampling-form [type=submit]'));
    const note = viewer.page.locator('#note-text', { hasText: 'sites instead of 3,000' });
    await note.waitFor();
    // Not of a sampling that was given up.
    await viewer.page.click('#note-close');
    const seed = await viewer.page.inputValue('#seed');
    await viewer.page.fill('#seed', '9');
    await viewer.evaluate((viewer) => {
      const cancel = () => setTimeout(() => viewer.cancel());
      viewer.addEventListener('status-change', cancel, { once: true });
    });
    await viewer.page.click('#sampling-form [type=submit]');
    await viewer.page.waitForFunction((s) => document.getElementById('seed').value === s, seed);
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.removeSite(0)));
    assert.equal(await note.isVisible(), false);

    const info = await viewer.evaluate(({ info }) => info);
    const detail = { name: 'large.glb', info: { ...info, faces: 2_000_000 }, parts: [] };
    await viewer.evaluate(
      (viewer, detail) => viewer.dispatchEvent(new CustomEvent('load', { detail })),
      detail,
    );
    await viewer.page.locator('#note-text', { hasText: '1.4 GB' }).waitFor();
  });
});

test('on Apple’s keyboards, keys are called as they are there', async () => {
  const apple = await browser.open({
    prepare: (page) =>
      page.addInitScript(() => {
        Object.defineProperty(Navigator.prototype, 'platform', { get: () => 'MacIntel' });
      }),
  });
  assert.equal(await apple.page.getAttribute('#undo', 'title'), 'Undo (⌘ Z)');
  assert.match(await apple.page.textContent('#help'), /⌘ Z, ⇧ ⌘ Z.*Undo, redo/);
  assert.doesNotMatch(await apple.page.textContent('#help'), /Ctrl/);
  await apple.after('diagram', () => apple.evaluate((viewer) => viewer.removeSite(0)));
  await apple.after('diagram', () => apple.page.keyboard.press('Meta+z'));
  assert.equal(await apple.siteCount(), 60);
  await apple.after('diagram', () => apple.page.keyboard.press('Meta+Shift+z'));
  assert.equal(await apple.siteCount(), 59);
});
