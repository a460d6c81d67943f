// SPDX-License-Identifier: MIT
//
// A phone in the hand: everything by fingers.

import assert from 'node:assert/strict';
import { beforeEach, suite, test } from 'node:test';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

suite('by fingers', () => {
  let viewer;
  let touch;
  beforeEach(async () => {
    viewer = await browser.open({
      viewport: { width: 390, height: 640 },
      hasTouch: true,
      isMobile: true,
    });
    const session = await viewer.page.context().newCDPSession(viewer.page);
    touch = (type, ...touchPoints) =>
      session.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: touchPoints.map(({ x, y }, id) => ({ x, y, id })),
      });
  });

  const orbit = () => viewer.evaluate(({ cameraOrbit }) => cameraOrbit);
  const distanceOf = (orbit) => Number(/([\d.]+)%/.exec(orbit)[1]);
  const targetOf = (orbit) => orbit.split(' ').slice(3).map(Number);
  const shifted = ({ x, y }, right, down) => ({ x: x + right, y: y + down });

  /** Two fingers, so far apart at the beginning and at the end, whose middle goes so far down. */
  async function useTwoFingers({ from, to, down }) {
    const box = await viewer.page.locator('geodesic-voronoi').boundingBox();
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    const at = (share) => {
      const reach = (from + share * (to - from)) / 2;
      return [shifted(middle, -reach, share * down), shifted(middle, reach, share * down)];
    };
    await touch('touchStart', ...at(0));
    for (const share of [0.2, 0.4, 0.6, 0.8, 1]) await touch('touchMove', ...at(share));
    await touch('touchEnd');
  }

  test('a tap adds a site, a drag moves it, a long press removes it', async () => {
    const before = await viewer.siteCount();
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => viewer.page.touchscreen.tap(place.x, place.y));
    assert.equal(await viewer.siteCount(), before + 1);
    assert.equal(await viewer.evaluate(({ selected }) => selected), before);

    const there = shifted(place, 12, 0);
    // At once, or a slow machine takes the first of it for a long press.
    await viewer.after('diagram', () =>
      Promise.all([
        touch('touchStart', place),
        ...[3, 6, 9, 12].map((way) => touch('touchMove', shifted(place, way, 0))),
        touch('touchEnd'),
      ]),
    );
    assert.equal(await viewer.siteCount(), before + 1);
    const moved = await viewer.sitePosition(before);
    assert.ok(Math.hypot(moved.x - there.x, moved.y - there.y) < 3, 'it is under the finger');

    const removed = viewer.after('diagram', async () => {
      await touch('touchStart', moved);
      await viewer.haveSites(before);
      await touch('touchEnd');
    });
    await removed;
    assert.equal(await viewer.siteCount(), before);
  });

  /** A site that is seen, near enough to another one for a finger to cover both. */
  async function crowdedSite() {
    await viewer.still();
    const found = await viewer.evaluate((viewer) => {
      const seen = [...viewer.sites.face.keys()]
        .map((i) => viewer.sitePosition(i))
        .filter((at) => at && document.elementFromPoint(at.x, at.y) === viewer);
      for (const site of seen) {
        const distance = ({ x, y }) => Math.hypot(x - site.x, y - site.y);
        const [, next] = seen.toSorted((a, b) => distance(a) - distance(b));
        if (distance(next) < 18 || distance(next) > 40) continue;
        const beside = { x: (site.x + next.x) / 2, y: (site.y + next.y) / 2 };
        if (viewer.surfaceFromPoint(beside.x, beside.y)) return { site, beside };
      }
    });
    assert.ok(found, 'some sites are crowded');
    return found;
  }

  test('between crowded sites a tap adds one, and a swipe turns the model', async () => {
    const before = await viewer.sites();
    const { beside } = await crowdedSite();
    await viewer.after('camera-change', async () => {
      await touch('touchStart', beside);
      for (const way of [8, 16, 24]) await touch('touchMove', shifted(beside, way, 0));
      await touch('touchEnd');
    });
    assert.deepEqual(await viewer.sites(), before);

    const { beside: there } = await crowdedSite();
    await viewer.after('diagram', async () => {
      await touch('touchStart', there);
      await touch('touchEnd');
    });
    assert.equal(await viewer.siteCount(), 61);
  });

  test('a tap chooses a site and marks nothing else; a pinch that begins on one does not', async () => {
    const selected = () => viewer.evaluate(({ selected }) => selected);
    const { site } = await crowdedSite();
    const other = shifted(site, 40, 50);
    await viewer.after('camera-change', async () => {
      await touch('touchStart', site);
      await touch('touchStart', site, other);
      for (const way of [10, 20]) await touch('touchMove', site, shifted(other, way, way));
      await touch('touchEnd');
    });
    assert.equal(await selected(), -1);

    // With a key before, as browsers show the focus then.
    await viewer.page.keyboard.press('Shift');
    const { site: tapped } = await crowdedSite();
    await viewer.after('sites-change', async () => {
      await touch('touchStart', tapped);
      await touch('touchEnd');
    });
    assert.notEqual(await selected(), -1);
    const isMarked = await viewer.evaluate((viewer) =>
      viewer.shadowRoot.querySelector('canvas').matches(':focus-visible'),
    );
    assert.equal(isMarked, false, 'the focus is not shown as by keys');
  });

  test('a pinch with the brush paints nothing, and a stroke that is cancelled goes', async () => {
    const isPainted = () => viewer.evaluate(({ density }) => density !== undefined);
    await viewer.evaluate((viewer) => viewer.setAttribute('tool', 'density'));
    const at = await viewer.freePlace();
    await viewer.after('camera-change', async () => {
      await touch('touchStart', at);
      await touch('touchStart', at, shifted(at, 40, 50));
      for (const way of [10, 20]) await touch('touchMove', at, shifted(at, 40 + way, 50 + way));
      await touch('touchEnd');
    });
    assert.equal(await isPainted(), false);
    const there = await viewer.freePlace();
    await touch('touchStart', there);
    await touch('touchMove', shifted(there, 10, 0));
    await viewer.evaluate((viewer) => viewer.cancel());
    await touch('touchEnd');
    assert.equal(await isPainted(), false);
    await viewer.after('density-change', async () => {
      await touch('touchStart', there);
      await touch('touchEnd');
    });
    assert.equal(await isPainted(), true);
    await viewer.after('density-change', () => viewer.evaluate((viewer) => viewer.undo()));
    assert.equal(await isPainted(), false, 'one stroke was recorded');
    await viewer.evaluate((viewer) => viewer.removeAttribute('tool'));
  });

  test('two fingers zoom and shift the view, and add nothing', async () => {
    const before = await viewer.sites();
    const first = await orbit();
    await viewer.after('camera-change', () => useTwoFingers({ from: 60, to: 180, down: 0 }));
    const near = await orbit();
    assert.ok(distanceOf(near) < 0.8 * distanceOf(first), `${first} became ${near}`);
    await viewer.after('camera-change', () => useTwoFingers({ from: 100, to: 100, down: 60 }));
    const aside = await orbit();
    assert.ok(Math.hypot(...targetOf(aside)) > 0.05, `${near} became ${aside}`);
    assert.deepEqual(await viewer.sites(), before);
  });

  test('a tap beside a finger that stays adds nothing', async () => {
    const before = await viewer.sites();
    const place = await viewer.freePlace();
    const other = shifted(place, 40, 40);
    await touch('touchStart', place);
    await touch('touchStart', place, other);
    await touch('touchEnd', place); // the second stays
    await touch('touchStart', place, other);
    await touch('touchEnd', place);
    await touch('touchEnd');
    await viewer.drawn();
    await viewer.settled();
    assert.deepEqual(await viewer.sites(), before);
  });

  test('the selected site is removed by a button', async () => {
    const remove = viewer.page.locator('#remove');
    assert.equal(await remove.isEnabled(), false, 'there is none');
    const place = await viewer.freePlace();
    await viewer.after('diagram', () => viewer.page.touchscreen.tap(place.x, place.y));
    await viewer.after('diagram', () => remove.tap());
    assert.equal(await viewer.siteCount(), 60);
    assert.equal(await remove.isEnabled(), false);
    await viewer.after('diagram', () => viewer.page.tap('#undo'));
    assert.equal(await viewer.siteCount(), 61);
  });

  test('all controls in the sheet are reached by a finger', async () => {
    await viewer.page.tap('#sheet');
    const { x, y, width } = await viewer.page.locator('#panel').boundingBox();
    const at = { x: x + width / 2, y: y + 150 };
    const isSeen = () =>
      viewer.page.evaluate(() => {
        const { bottom } = document.getElementById('documents').getBoundingClientRect();
        return bottom <= innerHeight;
      });
    for (let swipes = 0; swipes < 40 && !(await isSeen()); ++swipes) {
      await touch('touchStart', at);
      for (let way = 25; way <= 125; way += 25) await touch('touchMove', shifted(at, 0, -way));
      await touch('touchEnd');
    }
    assert.ok(await isSeen(), 'the end of the panel');
    assert.equal(await viewer.page.evaluate(() => document.documentElement.scrollTop), 0);
  });

  test('help tells what fingers do, and nothing of a mouse or of keys', async () => {
    await viewer.page.tap('#help-button');
    const help = viewer.page.locator('#help');
    const seen = await help.innerText();
    assert.match(seen, /Tap\s+Add a site/);
    assert.match(seen, /Pinch\s+Zoom/);
    assert.doesNotMatch(seen, /click|wheel|Ctrl/i);
  });

  test('buttons and sentences do not lie on the model, the sheet open or not', async () => {
    assert.match(
      await viewer.page.locator('#caption').innerText(),
      /^Tap the model to add a site/m,
    );
    for (const isOpen of [false, true]) {
      await viewer.still();
      const view = await viewer.page.locator('geodesic-voronoi').boundingBox();
      const { y: top } = await viewer.surfaceIn(view);
      for (const selector of isOpen ? ['#toolbar'] : ['#caption']) {
        const { y, height } = await viewer.page.locator(selector).boundingBox();
        assert.ok(
          top > y + height,
          `${selector} ends at ${y + height}, the model begins at ${top}`,
        );
      }
      await viewer.page.tap('#sheet');
      await viewer.settled();
    }
  });
});
