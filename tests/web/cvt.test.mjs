// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { beforeEach, suite, test } from 'node:test';
import { glb, octahedron } from '../wasm/meshes.mjs';
import { torus } from '../../web/page/samples/shapes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests();

suite('the centroidal tessellation', () => {
  let viewer;
  beforeEach(async () => {
    viewer = await browser.open();
    await viewer.evaluate((viewer) => {
      for (const group of document.querySelectorAll('#panel details')) group.open = true;
      viewer.iterations = [];
      viewer.addEventListener('cvt-iteration', ({ detail }) => {
        const areas = document.getElementById('region-areas').textContent;
        viewer.iterations.push({ ...detail, areas });
      });
    });
  });

  const text = (selector) => viewer.page.locator(selector).textContent();
  const iterations = () => viewer.evaluate(({ iterations }) => iterations);
  /** Not by the mouse: that waits for a page that stands still. */
  const press = (button) =>
    viewer.page.evaluate((button) => document.querySelector(button).click(), button);
  const reached = (iteration) =>
    viewer.page.waitForFunction(
      (iteration) =>
        document.querySelector('geodesic-voronoi').iterations.at(-1)?.iteration >= iteration,
      iteration,
    );
  const isDisabled = (button) => viewer.page.locator(button).isDisabled();

  test('plays so many iterations; the energy falls, and all is one step to undo', async () => {
    const before = await viewer.sites();
    const picture = await viewer.picture();
    await viewer.page.fill('#cvt-iterations', '6');
    await viewer.page.locator('#cvt-iterations').blur();
    const drawn = await viewer.after('diagram', () => press('#cvt-play'));
    assert.equal(drawn.regions, 60);
    assert.ok(drawn.milliseconds > 0);

    const all = await iterations();
    assert.deepEqual(
      all.map(({ iteration }) => iteration),
      [0, 1, 2, 3, 4, 5, 6],
    );
    for (let i = 1; i < all.length; ++i) {
      assert.ok(all[i].energy <= all[i - 1].energy, `the energy does not rise at ${i}`);
      assert.ok(all[i].largestMove > 0);
    }
    const [first, last] = [all[0], all.at(-1)];
    assert.ok(last.energy < 0.75 * first.energy, `from ${first.energy} to ${last.energy}`);
    assert.notEqual(last.areas, first.areas, 'told during the iterations');
    assert.ok(last.relativeEnergy > 0.8 && last.relativeEnergy < 1.4, `${last.relativeEnergy}`);
    assert.equal(await text('#cvt-state'), 'Finished 6 iterations');
    assert.equal(await text('#cvt-iteration'), '6');
    assert.equal(await text('#cvt-energy'), `${last.relativeEnergy.toFixed(4)} × hexagons`);
    const points = await viewer.page.locator('#cvt-curve polyline').getAttribute('points');
    assert.equal(points.split(' ').length, 7);

    const relaxed = await viewer.sites();
    assert.notDeepEqual(relaxed, before);
    const change = await viewer.difference(picture, await viewer.picture());
    assert.ok(change.count > 1000, `${change.count} pixels have another colour`);

    await viewer.after('diagram', () => press('#undo'));
    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await isDisabled('#undo'), true);
    assert.equal(await text('#cvt-state'), 'Not begun');
    await viewer.after('diagram', () => press('#redo'));
    assert.deepEqual(await viewer.sites(), relaxed);
  });

  test('pauses, steps, goes on and resets', async () => {
    const before = await viewer.sites();
    // So many that they are not over before the pause.
    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', '1000'));
    await press('#cvt-play');
    await reached(2);
    assert.equal(await text('#cvt-play'), 'Pause');
    await viewer.page.locator('#status', { hasText: 'Evening out regions…' }).waitFor();
    await viewer.after('diagram', () => press('#cvt-play'));
    const paused = (await iterations()).at(-1).iteration;
    assert.equal(await viewer.evaluate(({ cvtStatus }) => cvtStatus), 'paused');
    assert.equal(await viewer.regionCount(), 60);

    const atPause = await viewer.sites();
    await viewer.after('diagram', () => press('#cvt-step'));
    assert.equal(await text('#cvt-iteration'), String(paused + 1));
    assert.notDeepEqual(await viewer.sites(), atPause);
    await press('#cvt-play');
    await reached(paused + 2);
    const numbers = (await iterations()).map(({ iteration }) => iteration);
    assert.deepEqual(numbers, [...numbers.keys()], 'no iteration is lost or comes twice');

    await viewer.after('diagram', () => press('#cvt-reset'));
    assert.deepEqual(await viewer.sites(), before);
    assert.equal(await text('#cvt-iteration'), '–');
    assert.equal(await isDisabled('#cvt-reset'), true);
    const number = (await iterations()).length;
    await viewer.after('diagram', () => press('#redo'));
    assert.equal((await iterations()).length, number, 'nothing goes on behind one’s back');
  });

  test('going on after a pause is a step to undo of its own; a reset takes back all', async () => {
    const before = await viewer.sites();
    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', '2'));
    await viewer.after('diagram', () => press('#cvt-play'));
    const atPause = await viewer.sites();
    await viewer.after('diagram', () => press('#cvt-play'));
    await viewer.after('diagram', () => press('#undo'));
    assert.deepEqual(await viewer.sites(), atPause);
    await viewer.after('diagram', () => press('#cvt-step'));
    await viewer.after('diagram', () => press('#cvt-step'));
    await viewer.after('diagram', () => press('#cvt-reset'));
    assert.deepEqual(await viewer.sites(), atPause, 'of this tessellation');
    await viewer.after('diagram', () => press('#undo'));
    assert.deepEqual(await viewer.sites(), before);
  });

  test('a key that is held begins it once', async () => {
    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', '1000'));
    await viewer.page.locator('#viewer').focus();
    await viewer.page.keyboard.down(' ');
    await viewer.page.keyboard.down(' '); // as the keyboard repeats it
    assert.equal(await viewer.evaluate(({ cvtStatus }) => cvtStatus), 'running');
    await viewer.page.keyboard.up(' ');
    await reached(2);
    await viewer.after('diagram', () => viewer.page.keyboard.press(' '));
    assert.equal(await viewer.evaluate(({ cvtStatus }) => cvtStatus), 'paused');
    await viewer.after('diagram', () => press('#cvt-reset'));
  });

  test('a pause before the first iteration tells of no other diagram', async () => {
    const told = await viewer.evaluate(async (viewer) => {
      const diagrams = [];
      viewer.addEventListener('diagram', ({ detail }) => diagrams.push(detail.milliseconds));
      viewer.playCvt();
      viewer.pauseCvt();
      await new Promise((resolve) => setTimeout(resolve));
      return diagrams;
    });
    assert.deepEqual(told, []);
    assert.equal(await viewer.evaluate(({ cvtStatus }) => cvtStatus), 'paused');
  });

  test('a density that is undone before the first iteration leaves the sites as they are', async () => {
    const count = 5;
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer, count) => {
        viewer.sites = {
          face: [...Array(count).keys()],
          bary: Array(count).fill([0.3, 0.3, 0.4]).flat(),
        };
        viewer.density = new Float64Array(viewer.info.inputVertices).fill(10);
        viewer.playCvt();
        viewer.undo();
      }, count),
    );
    assert.equal(await viewer.siteCount(), count);
    assert.equal(await viewer.evaluate(({ diagram }) => diagram.sites.face.length), count);
  });

  test('ends where iterations gain no more than asked for', async () => {
    await viewer.page.selectOption('#cvt-tolerance', '0.01');
    await viewer.after('diagram', () => press('#cvt-play'));
    const all = await iterations();
    assert.ok(all.length < 30, `${all.length} iterations`);
    const gains = all.slice(1).map(({ energy }, i) => 1 - energy / all[i].energy);
    assert.ok(gains.slice(0, -1).every((gain) => gain > 0.01) && gains.at(-1) <= 0.01, `${gains}`);
    assert.equal(await text('#cvt-state'), 'Converged: gains below 1 %');
  });

  test('the curve of the energy is below its title', async () => {
    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', 2));
    await viewer.after('diagram', () => press('#cvt-play'));
    const [titleBottom, curveTop] = await viewer.page.evaluate(() => {
      const curve = document.getElementById('cvt-curve');
      const title = [...curve.querySelectorAll('text')].find((text) =>
        /log/.test(text.textContent),
      );
      const { y, height } = title.getBBox();
      return [y + height, curve.querySelector('polyline').getBBox().y];
    });
    assert.ok(titleBottom < curveTop, `${titleBottom}, ${curveTop}`);
  });

  test('the numbers beside the curve are apart, wherever it begins and ends', async () => {
    const overlapping = await viewer.evaluate((viewer) => {
      const tell = (iteration, relativeEnergy) =>
        viewer.dispatchEvent(
          new CustomEvent('cvt-iteration', {
            detail: { iteration, relativeEnergy, energy: 1, largestMove: 1 },
          }),
        );
      const cases = [];
      for (const first of [0.9, 1, 1.05, 1.3, 2, 3, 4, 5, 6, 7, 8, 9, 12, 70, 400, 12_345]) {
        for (const last of [0.8, 1, 1.03]) {
          tell(0, first);
          if (last < first) tell(1, last);
          const texts = [...document.querySelectorAll('#cvt-curve text[text-anchor=end]')];
          const rows = texts
            .filter((text) => !/iterations/.test(text.textContent))
            .map((text) => ({ content: text.textContent, y: Number(text.getAttribute('y')) }))
            .sort((a, b) => a.y - b.y);
          const size = parseFloat(getComputedStyle(texts[0]).fontSize);
          const areApart = rows.every(({ y }, i) => i === 0 || y - rows[i - 1].y > size);
          const isWithin = texts.every((text) => text.getBBox().x >= 0) && rows[0].y > 0;
          const numbers = rows.map(({ content }) => content);
          if (!areApart || !isWithin || !numbers.includes('1'))
            cases.push({ first, last, numbers });
        }
      }
      return cases;
    });
    assert.deepEqual(overlapping, []);
  });

  test('regions become small where density is painted', async () => {
    const place = await viewer.freePlace();
    const picture = await viewer.picture();
    const sites = await viewer.sites();
    await press('#density-paint');
    await viewer.page.selectOption('#brush-density', '1000');
    await viewer.after('density-change', async () => {
      await viewer.page.mouse.move(place.x, place.y);
      await viewer.page.mouse.down();
      for (const step of [8, -8, 8, -8, 8, 0])
        await viewer.page.mouse.move(place.x + step, place.y);
      await viewer.page.mouse.up();
    });
    assert.deepEqual(await viewer.sites(), sites, 'no site is added or moved');
    const change = await viewer.difference(picture, await viewer.picture(), place);
    assert.ok(change.there && change.count > 50, `${change.count} pixels show the paint`);

    await viewer.evaluate((viewer) => viewer.setAttribute('cvt-iterations', 10));
    await viewer.after('diagram', () => press('#cvt-play'));
    const { area, mean } = await viewer.evaluate(async (viewer, { x, y }) => {
      const { face, bary } = viewer.surfaceFromPoint(x, y);
      const { label } = await viewer.diagram.locate({ face: [face], bary });
      return {
        area: viewer.diagram.regions[label[0]].area,
        mean: viewer.info.area / viewer.diagram.regions.length,
      };
    }, place);
    assert.ok(area < 0.6 * mean, `an area of ${area} there, ${mean} on average`);

    await viewer.after('density-change', () => press('#density-clear'));
    assert.equal(await viewer.evaluate(({ density }) => density === undefined), true);
  });

  test('a density is plainly seen, and random sites follow it', async () => {
    await viewer.evaluate((viewer) => {
      const x = viewer.mesh.positions.filter((_, i) => i % 3 === 0);
      const middle = [...x].sort((a, b) => a - b)[x.length >> 1];
      viewer.isDense = (position) => position[0] > middle;
      viewer.density = x.map((each) => (each > middle ? 100 : 1));
    });
    const picture = await viewer.picture();
    const shares = await viewer.evaluate((viewer, picture) => {
      const { data, width } = viewer.pictures[picture];
      const { left, top, width: shown } = viewer.getBoundingClientRect();
      const light = { true: [], false: [] };
      for (let i = 0; i < data.length; i += 4 * 97) {
        const x = left + ((i / 4) % width) * (shown / width);
        const y = top + Math.floor(i / 4 / width) * (shown / width);
        const place = data[i + 3] === 255 && viewer.surfaceFromPoint(x, y);
        if (!place) continue;
        const v = viewer.mesh.indices[3 * place.face];
        light[viewer.isDense(viewer.mesh.positions.slice(3 * v, 3 * v + 3))].push(data[i + 1]);
      }
      const mean = (list) => list.reduce((sum, each) => sum + each, 0) / list.length;
      return { dense: mean(light.true), even: mean(light.false) };
    }, picture);
    assert.ok(shares.dense < 0.6 * shares.even, JSON.stringify(shares));

    await viewer.after('diagram', () => press('#sampling-form [type=submit]'));
    const dense = await viewer.evaluate(async (viewer) => {
      const positions = await viewer.mesh.positionsOf(viewer.sites);
      return [...viewer.sites.face.keys()].filter((i) =>
        viewer.isDense(positions.slice(3 * i, 3 * i + 3)),
      ).length;
    });
    const count = await viewer.siteCount();
    assert.ok(dense > 0.75 * count, `${dense} of ${count} sites where density is 100`);
  });

  test('a stroke is a step to undo, and the brush is seen where it would paint', async () => {
    const density = () => viewer.evaluate(({ density }) => density && [...density]);
    const place = await viewer.freePlace();
    const empty = await viewer.emptyPlace();
    await viewer.page.mouse.move(empty.x, empty.y);
    const bare = await viewer.picture();
    // The region under the pointer is outlined, too.
    const hovering = async (x) => {
      await viewer.after('hover', () => viewer.page.mouse.move(x, place.y));
      return viewer.picture();
    };
    const without = await hovering(place.x);
    await press('#density-paint');
    const outlined = await viewer.difference(without, await hovering(place.x + 1));
    assert.ok(outlined.count > 20, `${outlined.count} pixels are the brush's outline`);
    await press('#density-paint');
    assert.equal((await viewer.difference(without, await hovering(place.x))).count, 0);
    await press('#density-paint');

    const sites = await viewer.sites();
    const stroke = (dx) =>
      viewer.after('density-change', async () => {
        await viewer.page.mouse.move(place.x, place.y);
        await viewer.page.mouse.down();
        await viewer.page.mouse.move(place.x + dx, place.y);
        await viewer.page.mouse.up();
      });
    await stroke(8);
    const first = await density();
    await stroke(-8);
    const second = await density();
    assert.notDeepEqual(first, second);
    await viewer.after('density-change', () => press('#undo'));
    assert.deepEqual(await density(), first);
    await viewer.after('density-change', () => press('#undo'));
    assert.equal(await density(), undefined);
    assert.equal(await isDisabled('#undo'), true);
    await viewer.after('hover', () => viewer.page.mouse.move(empty.x, empty.y));
    assert.equal((await viewer.difference(bare, await viewer.picture())).count, 0);
    await viewer.after('density-change', () => press('#redo'));
    assert.deepEqual(await density(), first);
    await viewer.after('density-change', () => press('#density-clear'));
    await viewer.after('density-change', () => press('#undo'));
    assert.deepEqual(await density(), first);
    assert.deepEqual(await viewer.sites(), sites);
  });

  test('what is under the brush is told during a stroke', async () => {
    const { x, y } = await viewer.freePlace();
    await press('#density-paint');
    await viewer.after('hover', () => viewer.page.mouse.move(x, y));
    await viewer.page.mouse.down();
    const told = await viewer.after('hover', () => viewer.page.mouse.move(x + 12, y));
    assert.ok(told.region >= 0);
  });

  test('a brush that reaches no vertex says so', async () => {
    await viewer.after('diagram', () => viewer.choose({ 'octahedron.glb': glb(octahedron()) }));
    const { x, y } = await viewer.evaluate((viewer) => {
      viewer.setAttribute('tool', 'density');
      viewer.setAttribute('brush-size', '5');
      const { left, top, width, height } = viewer.getBoundingClientRect();
      return { x: left + 0.52 * width, y: top + 0.55 * height };
    });
    await viewer.page.mouse.click(x, y);
    await viewer.page
      .locator('geodesic-voronoi .hint.shown', { hasText: /reaches no corner/ })
      .waitFor();
    assert.equal(await viewer.evaluate(({ density }) => density), undefined);
  });

  test('a brush of negative density paints as little as there can be', async () => {
    const least = await viewer.evaluate((viewer) => {
      viewer.setAttribute('tool', 'density');
      viewer.setAttribute('brush-density', '-5');
      viewer.refit();
      for (let dab = 0; dab < 20; ++dab) viewer.perform('place');
      return Math.min(...viewer.density);
    });
    assert.ok(least >= 1e-3 && least < 0.1, `${least}`);
  });

  test('a stroke that another model ends is not one on that', async () => {
    const { x, y } = await viewer.freePlace();
    await viewer.evaluate((viewer) => viewer.setAttribute('tool', 'density'));
    await viewer.page.mouse.move(x, y);
    await viewer.page.mouse.down();
    await viewer.page.mouse.move(x + 8, y);
    await viewer.after('diagram', () =>
      viewer.evaluate((viewer) => viewer.load('./samples/torus.glb')),
    );
    await viewer.page.mouse.up();
    const density = () => viewer.evaluate(({ density }) => density && [...density].length);
    assert.equal(await density(), undefined);
    await viewer.evaluate((viewer) => {
      viewer.density = new Float64Array(viewer.info.inputVertices).fill(10);
      viewer.undo();
    });
    assert.equal(await density(), undefined);
  });

  test('does not go on after a cancel', async () => {
    const status = await viewer.evaluate(async (viewer) => {
      viewer.playCvt();
      const sampled = viewer.sampleSites(5000, 1, 'poisson');
      viewer.cancel();
      await sampled;
      return viewer.cvtStatus;
    });
    assert.equal(status, 'paused');
  });

  test('a density has a legend where it is seen', async () => {
    const legend = viewer.page.locator('geodesic-voronoi [part=density]');
    assert.equal(await legend.isVisible(), false);
    await viewer.after('density-change', () => press('#density-curvature'));
    assert.equal(await legend.isVisible(), true);
    assert.match(await legend.textContent(), /1\/1000.*1000.*Density: .* regions become smaller/);
    await viewer.set({ layers: ['distances'] });
    await viewer.page.locator('geodesic-voronoi [part=distances]').waitFor();
    assert.equal(await legend.isVisible(), false, 'the colours are others');
    await viewer.evaluate((viewer) => viewer.removeAttribute('layers'));
    await legend.waitFor();
    await viewer.after('density-change', () => press('#density-clear'));
    assert.equal(await legend.isVisible(), false);
  });

  test('painting ends where it is left', async () => {
    const paint = viewer.page.locator('#density-paint');
    const isEnded = async (leave, what) => {
      await viewer.evaluate(() => {
        for (const details of document.querySelectorAll('details')) details.open = true;
      });
      if (!(await paint.isChecked())) await press('#density-paint');
      assert.equal(await viewer.evaluate((viewer) => viewer.getAttribute('tool')), 'density');
      await leave();
      await viewer.page.waitForFunction(
        () => document.querySelector('geodesic-voronoi').getAttribute('tool') === 'sites',
      );
      assert.equal(await paint.isChecked(), false, what);
      await viewer.settled();
    };
    const { x, y } = await viewer.freePlace();
    await viewer.after('hover', () => viewer.page.mouse.move(x, y));
    const bare = await viewer.picture();
    await isEnded(async () => {
      for (const dx of [1, 0]) await viewer.page.mouse.move(x + dx, y);
      await viewer.page.keyboard.press('Escape');
    }, 'Escape');
    const left = await viewer.difference(bare, await viewer.picture());
    assert.equal(left.count, 0, 'the brush is seen no more');
    await isEnded(() => viewer.page.getByText('Smaller regions in places').click(), 'folded');
    await isEnded(() => press('#layers [value=distances]'), 'covered by distances');
    await press('#density-paint');
    const layers = await viewer.evaluate((viewer) => viewer.layers);
    assert.deepEqual(layers, ['regions', 'bisectors', 'sites'], 'nothing covers the paint');
    assert.equal(await viewer.page.locator('#layers [value=distances]').isChecked(), false);
    await isEnded(() => press('#sampling-form [type=submit]'), 'placed anew');
    await isEnded(() => viewer.page.selectOption('#site-list', { index: 3 }), 'a site selected');
    await isEnded(() => press('#clear'), 'removed');
    await isEnded(() => viewer.page.selectOption('#samples', 'torus.glb'), 'another model');
  });

  test('with 300 sites on 100,000 triangles the page answers throughout, and a pause is final', async () => {
    // Few pixels: drawing them without a graphics card is what takes the time here.
    await viewer.page.setViewportSize({ width: 360, height: 300 });
    await viewer.after('diagram', () => viewer.choose({ 'torus.glb': glb(torus(320, 160)) }));
    await viewer.after('diagram', () => viewer.evaluate((viewer) => viewer.sampleSites(300)));
    assert.equal(await viewer.evaluate(({ info }) => info.faces), 102_400);
    const before = await viewer.sites();

    // Of every iteration how long it took, and the longest time in which no timer ran.
    const answers = await viewer.evaluate(
      (viewer) =>
        new Promise((resolve) => {
          const answers = [];
          let start = performance.now();
          let last = start;
          let longest = 0;
          const timer = setInterval(() => {
            const now = performance.now();
            longest = Math.max(longest, now - last);
            last = now;
          }, 1);
          viewer.addEventListener('cvt-iteration', () => {
            const now = performance.now();
            answers.push({ whole: now - start, longest: Math.max(longest, now - last) });
            start = last = now;
            longest = 0;
            if (answers.length < 6) return;
            clearInterval(timer);
            resolve(answers);
          });
          viewer.playCvt();
        }),
    );
    // What a busy machine holds up, it holds up in one iteration or another.
    const shares = answers.slice(1).map(({ whole, longest }) => longest / whole);
    assert.ok(shares.sort((a, b) => a - b)[2] < 0.75, `silent for ${shares} of iterations`);

    // In the middle of the next iteration, the first time by the button, then by Cancel.
    for (const give of ['pauseCvt', 'cancel']) {
      const told = await viewer.evaluate(async (viewer, give) => {
        if (viewer.cvtStatus !== 'running') viewer.playCvt();
        await new Promise((resolve) =>
          viewer.addEventListener('cvt-iteration', resolve, { once: true }),
        );
        await new Promise((resolve) => setTimeout(resolve, 50));
        const later = [];
        for (const type of ['cvt-iteration', 'sites-change', 'cvt-change', 'status-change']) {
          viewer.addEventListener(type, () => later.push(type));
        }
        viewer[give]();
        const { cvtStatus, status } = viewer;
        later.length = 0;
        viewer.later = later;
        return { cvtStatus, status };
      }, give);
      assert.deepEqual(told, { cvtStatus: 'paused', status: 'ready' }, 'at once');
      const atPause = await viewer.sites();
      const picture = await viewer.picture(['regions', 'bisectors', 'sites']);
      // Each takes as long as an iteration: the one that was under way is done after these.
      await viewer.evaluate(async ({ mesh, sites }) => {
        for (let i = 0; i < 3; ++i) (await mesh.voronoi(sites)).dispose();
      });
      assert.deepEqual(await viewer.evaluate(({ later }) => later), []);
      const change = await viewer.difference(
        picture,
        await viewer.picture(['regions', 'bisectors', 'sites']),
      );
      assert.equal(change.count, 0, 'nothing is drawn after it');
      assert.deepEqual(await viewer.sites(), atPause);
      // The diagram is that of the sites, and can be asked.
      const { sites, nearest } = await viewer.evaluate(async ({ diagram }) => {
        const { face, bary } = diagram.sites;
        const { label } = await diagram.locate({ face: [face[7]], bary: bary.slice(21, 24) });
        return { sites: { face: [...face], bary: [...bary] }, nearest: label[0] };
      });
      assert.deepEqual(sites, atPause);
      assert.equal(nearest, 7);
    }
    const numbers = (await iterations()).map(({ iteration }) => iteration);
    assert.deepEqual(numbers, [...numbers.keys()], 'no iteration is lost or comes twice');

    await viewer.after('diagram', () => press('#cvt-reset'));
    assert.deepEqual(await viewer.sites(), before);
  });

  test('sites are sampled in three ways', async () => {
    const sample = (sampling) =>
      viewer.after('diagram', async () => {
        await viewer.page.selectOption('#sampling', sampling);
        await press('#sampling-form [type=submit]');
      });
    const lists = [];
    for (const sampling of ['farthest', 'poisson', 'random']) {
      assert.equal((await sample(sampling)).sites, 60);
      lists.push(JSON.stringify(await viewer.sites()));
    }
    assert.equal(new Set(lists).size, 3);
  });
});
