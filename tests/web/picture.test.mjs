// SPDX-License-Identifier: MIT
//
// What the picture shows, by its pixels.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { glb, grid } from '../wasm/meshes.mjs';
import { torus } from '../../web/page/samples/shapes.mjs';
import { browserForTests } from './browser.mjs';

const browser = await browserForTests({}, { antialias: true });

/** The page with a model of our own. */
async function opened(mesh, { sites = 12, ...options } = {}) {
  const viewer = await browser.open(options);
  await viewer.evaluate((viewer, sites) => viewer.setAttribute('sites', sites), sites);
  // Not just the next diagram: the page evens out the regions of its first model meanwhile.
  await viewer.after('load', () => viewer.choose({ 'own.glb': glb(mesh) }));
  await viewer.page.waitForFunction((sites) => {
    const { status, diagram, sites: now } = document.querySelector('geodesic-voronoi');
    return status === 'ready' && diagram && now.face.length === sites;
  }, sites);
  return viewer;
}

/** Sums of a picture's pixels that its predicate holds for: their number and their mean lightness. */
const pixels = (viewer, picture, kind) =>
  viewer.evaluate(
    (viewer, { picture, kind }) => {
      const { data } = viewer.pictures[picture];
      let count = 0;
      let light = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b, alpha] = data.subarray(i, i + 4);
        const lightness = (r + g + b) / 3;
        const is = {
          drawn: alpha === 255,
          dark: alpha === 255 && lightness < 60,
          bright: alpha === 255 && Math.min(r, g, b) > 215,
          half: alpha > 0 && alpha < 255,
        }[kind];
        if (!is) continue;
        ++count;
        light += lightness;
      }
      return { count, lightness: light / Math.max(1, count) };
    },
    { picture, kind },
  );

/** A closed plate of width 2 and n × n squares on each side, the upper one first. */
function plate(n, thickness) {
  const positions = [0, -thickness].flatMap((y) =>
    Array.from({ length: (n + 1) ** 2 }, (_, i) => [
      (2 * (i % (n + 1))) / n - 1,
      y,
      (2 * Math.floor(i / (n + 1))) / n - 1,
    ]),
  );
  const indices = [];
  const add = (a, b, c, d) => indices.push(a, b, c, a, c, d);
  const at = (x, z, isLow) => (isLow ? (n + 1) ** 2 : 0) + z * (n + 1) + x;
  for (const isLow of [false, true])
    for (let z = 0; z < n; ++z)
      for (let x = 0; x < n; ++x) {
        const corners = [at(x, z), at(x, z + 1), at(x + 1, z + 1), at(x + 1, z)];
        const own = corners.map((corner) => corner + at(0, 0, isLow));
        add(...(isLow ? own.reverse() : own));
      }
  for (let i = 0; i < n; ++i) {
    add(at(i, 0), at(i + 1, 0), at(i + 1, 0, true), at(i, 0, true));
    add(at(i + 1, n), at(i, n), at(i, n, true), at(i + 1, n, true));
    add(at(0, i + 1), at(0, i), at(0, i, true), at(0, i + 1, true));
    add(at(n, i), at(n, i + 1), at(n, i + 1, true), at(n, i, true));
  }
  return { positions: positions.flat(), indices };
}

test('bisectors behind a thin wall do not show through it', async () => {
  const n = 20;
  const viewer = await opened(plate(n, 0.01));
  assert.equal(await viewer.evaluate(({ info }) => info.boundaryLoops), 0);
  const centre = n * n + n; // among the triangles of a side
  const below = [-2, 2].flatMap((x) => [-2, 2].map((z) => 2 * n * n + centre + 2 * (n * z + x)));
  const face = [centre, ...below];
  await viewer.after('diagram', () =>
    viewer.set({ sites: { face, bary: face.flatMap(() => [0.4, 0.3, 0.3]) } }),
  );
  await viewer.set({ cameraOrbit: '0deg 80deg auto' });
  const [bare, lined] = [await viewer.picture(), await viewer.picture(['regions', 'bisectors'])];
  // The regions below meet where x or z is 0, those above nowhere near the middle.
  const { left, top } = await viewer.evaluate((viewer) => viewer.getBoundingClientRect());
  const xs = [0.2, 0.3, 0.4, 0.5, 0.6];
  const middle = await viewer.evaluate(
    (viewer, places) => viewer.project(places),
    xs.flatMap((x) => [x, 0, 0]),
  );
  for (const { x, y } of middle)
    for (const below of [0, 1, 2, 3]) {
      const place = { x: left + x, y: top + y + below };
      assert.ok(!(await viewer.difference(bare, lined, place)).there, `${below} pixels below`);
    }
});

test('dots and lines leave the colours of thousands of small regions to be seen', async () => {
  const viewer = await opened(torus(), { sites: 10_000 });
  const picture = await viewer.picture(['regions', 'bisectors', 'sites']);
  const dark = (await pixels(viewer, picture, 'dark')).count;
  const drawn = (await pixels(viewer, picture, 'drawn')).count;
  assert.ok(dark < 0.2 * drawn, `${dark} of ${drawn} pixels are dark`);
  const fewer = await viewer.after('diagram', () =>
    viewer.evaluate((viewer) => viewer.setAttribute('sites', 12)),
  );
  assert.equal(fewer.sites, 12);
  const large = await viewer.picture(['bisectors']);
  assert.ok((await pixels(viewer, large, 'dark')).count > 300, 'lines are as wide as ever');
});

test('no background is seen between cells with detail and the faces beside them', async () => {
  const viewer = await opened(grid(40));
  await viewer.after('diagram', () =>
    viewer.evaluate((viewer) => viewer.setAttribute('detail', 2)),
  );
  await viewer.after('distances', () =>
    viewer.evaluate((viewer) => viewer.setAttribute('layers', 'distances')),
  );
  for (const layer of ['distances', 'regions']) {
    const picture = await viewer.picture([layer]);
    const gaps = await viewer.evaluate((viewer, picture) => {
      const { data, width } = viewer.pictures[picture];
      const isFull = (pixel) => data[4 * pixel + 3] === 255;
      const beside = [-2, 2, -2 * width, 2 * width];
      let count = 0;
      for (let pixel = 0; pixel < data.length / 4; ++pixel)
        if (!isFull(pixel) && beside.every((step) => isFull(pixel + step))) ++count;
      return count;
    }, picture);
    assert.equal(gaps, 0, layer);
  }
});

test('a file of the picture is what is seen, edges that are half transparent too', async () => {
  const viewer = await browser.open();
  const { count, worst } = await viewer.evaluate(async (viewer) => {
    const canvas = viewer.shadowRoot.querySelector('canvas');
    const { data: file } = await window.pixelsOf(await viewer.toBlob());
    const { data: seen } = await window.pixelsOf(canvas);
    // Divided by little opacity, colours are less exact.
    const share = (i) => seen[i - (i % 4) + 3] / 255;
    const differences = seen.map((channel, i) => Math.abs(channel - file[i]) * share(i));
    const isEdge = (channel, i) => i % 4 === 3 && channel > 0 && channel < 255;
    return {
      count: seen.filter(isEdge).length,
      worst: differences.reduce((most, each) => Math.max(most, each), 0),
    };
  });
  assert.ok(count > 100, `${count} pixels of edges`);
  assert.ok(worst <= 2, `they differ by ${worst} of 255`);
});

test('the mark of the selected site is in no file of the picture', async () => {
  const viewer = await opened(torus());
  const index = await viewer.evaluate((viewer) =>
    [...viewer.sites.face.keys()].findIndex((i) => viewer.sitePosition(i)),
  );
  const bare = await viewer.picture(['sites']);
  await viewer.set({ selected: index });
  assert.equal((await viewer.difference(bare, await viewer.picture(['sites']))).count, 0);
});

test('bisectors are dark on light pages and bright on dark ones', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const viewer = await opened(torus(60, 30), { colorScheme });
    const kind = colorScheme === 'light' ? 'dark' : 'bright';
    const bare = await pixels(viewer, await viewer.picture(['regions']), kind);
    const lined = await pixels(viewer, await viewer.picture(['regions', 'bisectors']), kind);
    assert.ok(lined.count > bare.count + 300, `${colorScheme}: ${lined.count} after ${bare.count}`);
    await viewer.close();
  }
});

test('the colours follow the theme of the page while it is open', async () => {
  const viewer = await opened(torus(60, 30));
  const light = await pixels(viewer, await viewer.picture(), 'drawn');
  await viewer.page.emulateMedia({ colorScheme: 'dark' });
  await viewer.drawn(); // Pages are told with the next frame.
  const dark = await pixels(viewer, await viewer.picture(), 'drawn');
  assert.ok(dark.lightness < 0.9 * light.lightness, `${dark.lightness} after ${light.lightness}`);
});

test('on paper there is the view alone, on one page, and not stretched to the shape of the paper', async () => {
  const viewer = await browser.open();
  const { page } = viewer;
  const pages = (await page.pdf()).toString('latin1').match(/\/Type \/Page\b/g);
  await page.emulateMedia({ media: 'print' });
  for (const rest of ['header', 'aside', '#toolbar', '#notices'])
    assert.equal(await page.isVisible(rest), false, rest);
  const { width, height } = await page.locator('geodesic-voronoi').boundingBox();
  assert.deepEqual({ width, height }, page.viewportSize());
  const fit = await viewer.evaluate(
    ({ shadowRoot }) => getComputedStyle(shadowRoot.querySelector('canvas')).objectFit,
  );
  assert.deepEqual([pages.length, fit], [1, 'contain']);
});

test('markers stay on the surface: none reaches beyond the silhouette', async () => {
  const viewer = await opened(torus(60, 30), { sites: 200 });
  const before = await viewer.coverage(await viewer.picture(['regions']));
  const after = await viewer.coverage(await viewer.picture(['regions', 'sites', 'voronoi-points']));
  assert.ok(after - before < 2e-4, `${after - before} of the view`);
});

test('markers grow with the zoom, up to a size', async () => {
  const viewer = await opened(grid(40), { sites: 60, viewport: { width: 800, height: 560 } });
  const marked = async () => {
    const [bare, sites] = [
      await viewer.picture(['regions']),
      await viewer.picture(['regions', 'sites']),
    ];
    const seen = await viewer.evaluate(
      (viewer) => [...viewer.sites.face.keys()].filter((i) => viewer.sitePosition(i)).length,
    );
    return (await viewer.difference(bare, sites)).count / seen;
  };
  const far = await (async () => {
    for (let i = 0; i < 6; ++i) await viewer.evaluate((viewer) => viewer.perform('farther'));
    return marked();
  })();
  await viewer.evaluate((viewer) => viewer.refit());
  const near = await marked();
  assert.ok(near > 1.5 * far, `${near} pixels each after ${far}`);
});

test('distances are shown with a scale in the units of the model', async () => {
  const viewer = await opened(grid(40), { sites: 5 });
  const legend = viewer.page.locator('geodesic-voronoi .distances');
  assert.equal(await legend.isVisible(), false);
  const regions = await viewer.picture(['regions']);
  await viewer.page.check('#layers [value=distances]');
  await legend.waitFor();
  assert.match(
    await legend.textContent(),
    /^00\.\d+Distance to the nearest site, in the model's units/,
  );
  const longest = await viewer.evaluate(async (viewer) => {
    const vertex = [...viewer.mesh.positions.keys()].filter((i) => i % 3 === 0).map((i) => i / 3);
    const { distance } = await viewer.diagram.locate({ vertex });
    return Math.max(...distance);
  });
  const told = Number((await legend.locator('.ends span').last().textContent()) ?? 0);
  assert.ok(Math.abs(told / longest - 1) < 0.05, `${told} for ${longest}`);
  const marksFromLeft = await viewer.evaluate((viewer) => {
    document.dir = 'rtl'; // where the colours go from left to right, too
    const [first, last] = viewer.shadowRoot.querySelectorAll('.distances .ends span');
    return first.getBoundingClientRect().x < last.getBoundingClientRect().x;
  });
  assert.ok(marksFromLeft, 'numbers go the way of the colours');
  await viewer.evaluate((viewer) => {
    document.dir = 'ltr';
    viewer.setAttribute('exploded', '0.5');
  });
  await legend.waitFor({ state: 'hidden' }); // the parts have the colours of regions
  await viewer.evaluate((viewer) => viewer.removeAttribute('exploded'));
  await legend.waitFor();
  assert.deepEqual(viewer.complaints, []);
  await viewer.page.uncheck('#layers [value=distances]');
  await legend.waitFor({ state: 'hidden' });
  assert.equal((await viewer.difference(regions, await viewer.picture(['regions']))).count, 0);
});

test('the scale of distances is as short for a model of any size', async () => {
  const { positions, indices } = torus();
  const viewer = await opened({ positions: positions.map((x) => 1e-9 * x), indices });
  await viewer.page.check('#layers [value=distances]');
  const legend = viewer.page.locator('geodesic-voronoi .distances');
  await legend.waitFor();
  assert.match(
    await legend.textContent(),
    /^0\d\.\d\de-\d+Distance .* a line every \d\.\d\de-\d+$/,
  );
});

test('the pointer shows the shortest path to the site', async () => {
  const viewer = await opened(torus(60, 30));
  const bare = await viewer.picture(['regions']);
  const place = await viewer.freePlace();
  await viewer.after('hover', () => viewer.page.mouse.move(place.x, place.y));
  // The region's outline and the path; the outline is ink, the path has the colour of what is selected.
  const isAccent = (await viewer.difference(bare, await viewer.picture(['regions']), place)).there;
  assert.ok(isAccent, 'it begins under the pointer');
});

test('nothing is cut off near the camera, also where it looks beside the model', async () => {
  const kite = {
    positions: [0, 0, 1, 0.5, 0, 0, 0, 0, -1, -0.5, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
  };
  const viewer = await opened(kite, { sites: 3 });
  await viewer.set({ cameraOrbit: '0deg 70deg 250% -1.2 0 0' });
  const picture = await viewer.picture();
  const alpha = await viewer.evaluate((viewer, picture) => {
    const { data, width } = viewer.pictures[picture];
    const [{ x, y }] = viewer.project([0, 0, 0.95]);
    const scale = width / viewer.clientWidth;
    return data[4 * (Math.round(y * scale) * width + Math.round(x * scale)) + 3];
  }, picture);
  assert.equal(alpha, 255, 'the tip in front is seen');
});
