// SPDX-License-Identifier: MIT
//
// The view of the element: camera, colours, selected sites and pictures.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { octahedron } from '../wasm/meshes.mjs';
import { meshBinaryStl, meshObj } from '../wasm/model_files.mjs';
import { browserForTests } from './browser.mjs';
import { elementPages, emptyPage } from './element_pages.mjs';

const browser = await browserForTests(elementPages);

suite('the view of the element', () => {
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

  test('an STL has its third axis upwards, other models the second, and each another one on request', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    /** The axis whose end is highest in the view. */
    const highest = async () => {
      await viewer.drawn();
      return viewer.evaluate((viewer) => {
        const ends = viewer.project([2, 0, 0, 0, 2, 0, 0, 0, 2]).map((end) => end?.y ?? Infinity);
        return 'xyz'[ends.indexOf(Math.min(...ends))];
      });
    };
    const open = (name, bytes) =>
      viewer.after('diagram', () =>
        viewer.evaluate(
          (viewer, [name, bytes]) => viewer.loadFiles({ [name]: Uint8Array.from(bytes) }),
          [name, [...bytes]],
        ),
      );
    await open('a.stl', meshBinaryStl(octahedron()));
    assert.equal(await highest(), 'z');
    await open('a.obj', meshObj(octahedron()));
    assert.equal(await highest(), 'y');
    await viewer.evaluate((viewer) => viewer.setAttribute('up', 'y'));
    await open('a.stl', meshBinaryStl(octahedron()));
    assert.equal(await highest(), 'y');
  });

  test('on a slide that is scaled, its picture is as fine as it is seen, and labels stay in place', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const project = () => viewer.evaluate((viewer) => viewer.project([0, 0.42, 1])[0]);
    const before = await project();
    await viewer.evaluate((viewer) => {
      viewer.parentElement.style.cssText = 'transform: scale(1.5); transform-origin: 0 0';
      viewer.layers = 'regions'; // drawn anew
    });
    await viewer.drawn();
    const after = await project();
    assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 1, `${after.x}, ${after.y}`);
    const width = await viewer.evaluate(
      ({ shadowRoot }) => shadowRoot.querySelector('canvas').width,
    );
    assert.equal(width, 450);
  });

  test('where CSS turns, skews and mirrors it, sites are where they are drawn, and clicks meet them', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    const { index, place, label } = await viewer.evaluate(async (viewer) => {
      document.body.style.cssText =
        'transform: translate(250px, 120px) rotate(30deg) skewX(20deg) scale(-1, 0.8)';
      const places = viewer.project(await viewer.mesh.positionsOf(viewer.sites));
      const index = places.findIndex((place) => place);
      const label = document.createElement('i');
      viewer.shadowRoot.append(label);
      const { x, y } = places[index];
      label.style.cssText = `position: absolute; left: ${x}px; top: ${y}px`;
      return { index, place: viewer.sitePosition(index), label: label.getBoundingClientRect() };
    });
    const distance = Math.hypot(place.x - label.x, place.y - label.y);
    assert.ok(distance < 1, `drawn ${distance} pixels beside where it is`);
    await viewer.page.mouse.click(place.x, place.y);
    assert.equal(await viewer.evaluate(({ selected }) => selected), index);
    const { x, y } = await viewer.freePlace();
    const wanted = await viewer.evaluate((viewer, { x, y }) => viewer.surfaceFromPoint(x, y).face, {
      x,
      y,
    });
    await viewer.after('sites-change', () => viewer.page.mouse.click(x, y));
    const { face } = await viewer.sites();
    assert.equal(face.at(-1), wanted);
  });

  test('in full screen it is on the ground of the page, not on black', async () => {
    const viewer = await browser.open({ path: 'one.html' });
    await viewer.evaluate((viewer) => viewer.requestFullscreen());
    const ground = await viewer.evaluate((viewer) => getComputedStyle(viewer).backgroundColor);
    assert.equal(ground, 'rgb(255, 255, 255)');
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
    const viewer = await emptyPage(browser);
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
