// SPDX-License-Identifier: MIT
//
// The built page in a browser, for the tests: they wait for what the viewer says, never for frames.

import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { createServer } from 'node:http';
import { basename, extname, join } from 'node:path';
import { buffer } from 'node:stream/consumers';
import { after, afterEach, beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { coarseBunny } from '../../web/page/samples/samples.mjs';

/** Where files come from, by the beginning of their path. */
const folders = {
  '/package/': new URL('../../dist/', import.meta.url),
  '/modules/': new URL('../../node_modules/', import.meta.url),
  '/': new URL('../../build/page/', import.meta.url),
};

/** As strict as the package says it can be. */
const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'";

const mediaTypes = {
  '.css': 'text/css',
  '.glb': 'model/gltf-binary',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webp': 'image/webp',
};

/** A software renderer, and nothing on the network but the page. Slow machines are given time. */
export const browserOptions = {
  executablePath: process.env.CHROME_PATH ?? '/usr/bin/chromium',
  chromiumSandbox: false,
  args: [
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--no-first-run',
    // What is not WebGL is drawn without the renderer, which would compile programs for it first.
    '--disable-gpu-rasterization',
  ],
  timeout: 120_000,
};

/**
 * No module of a bundle imports the script of a worker: WebKit runs the first script of a worker once
 * more when a module of the worker imports it, which makes it forget what it has.
 */
export async function assertWorkersAreNotImported(folder) {
  const names = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith('.js'));
  const scripts = await Promise.all(names.map((name) => readFile(join(folder, name), 'utf8')));
  const quoted = /["'`]([^"'`]+\.js)["'`]/;
  const all = (pattern) =>
    scripts.flatMap((script) => [...script.matchAll(pattern)].map(([, name]) => basename(name)));
  const workers = all(new RegExp(`new Worker\\([^)]*?${quoted.source}`, 'g'));
  const imported = new Set(all(new RegExp(`(?:from|import)\\s*\\(?${quoted.source}`, 'g')));
  assert.ok(workers.length > 0, `there are no workers in ${names.join(', ')}`);
  assert.deepEqual(
    workers.filter((name) => imported.has(name)),
    [],
  );
}

/** What pages offer to the tests: the WebGL contexts that were made, and pixels of pictures. */
function preparePage() {
  window.contexts = [];
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (type, ...options) {
    const context = getContext.call(this, type, ...options);
    if (context && type.startsWith('webgl')) window.contexts.push(context);
    return context;
  };
  /** The pixels of a file or a canvas. */
  window.pixelsOf = async (source) => {
    const bitmap = await createImageBitmap(source);
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, width, height);
  };
  /** The share of pixels that are not transparent. */
  window.opaqueShare = ({ data }) =>
    data.filter((alpha, i) => i % 4 === 3 && alpha === 255).length / (data.length / 4);
}

/** The first model, coarser than it is: a software renderer takes its time for each vertex. */
const firstFile = { path: '/samples/bunny.ply', content: coarseBunny() };
/** How many triangles that has. */
export const firstTriangles = 3674;

/** Serves the page, the package, and documents by their path, on a free port; `close()` ends it. */
async function serve(documents) {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://page').pathname);
    const start = Object.keys(folders).find((start) => path.startsWith(start));
    const file = new URL(path === '/' ? 'index.html' : path.slice(start.length), folders[start]);
    try {
      const content =
        path === firstFile.path
          ? firstFile.content
          : (documents[path]?.html ?? (await readFile(fileURLToPath(file))));
      response.writeHead(200, {
        'Content-Type': mediaTypes[extname(file.pathname)] ?? 'application/octet-stream',
        'Content-Security-Policy': documents[path]?.policy ?? policy,
      });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** With its random sites: without a hash, the page would make them even. */
const firstModel = '#v=1&model=bunny.ply&sites=60&seed=4';

/**
 * A browser and a server for the pages. `documents` are pages besides the one that is built: their
 * `html`, and their `policy` if it is another. Antialiasing, of which only pictures tell, takes a
 * software renderer a fifth of all time.
 */
export async function startBrowser(documents = {}, { antialias = false } = {}) {
  const server = await serve(documents);
  const args = antialias ? [] : ['--webgl-antialiasing-mode=none'];
  const browser = await chromium.launch({
    ...browserOptions,
    args: [...browserOptions.args, ...args],
  });
  const pages = [];
  /**
   * The page, with the sample and the sites that the hash asks for, or a document, in a window of its
   * own; `prepare` may change it before anything is loaded. `complaint` is a pattern of the errors
   * that its console is expected to show.
   */
  async function visit({
    prepare,
    complaint,
    path = '',
    hash = path ? '' : firstModel,
    ...context
  } = {}) {
    const page = await browser.newPage({
      viewport: { width: 800, height: 420 },
      // A camera that glides on draws frame after frame, seconds each here.
      reducedMotion: 'reduce',
      ...context,
    });
    page.setDefaultTimeout(120_000);
    const viewer = new ViewerPage(page, complaint);
    pages.push(viewer);
    await page.addInitScript(preparePage);
    await prepare?.(page);
    await page.goto(server.address + path + hash);
    return viewer;
  }
  return {
    /** All that were opened. */
    pages,
    visit,
    /** The same page, once its viewer has nothing left to do. */
    async open(options) {
      const viewer = await visit(options);
      await viewer.settled();
      return viewer;
    },
    async stop() {
      await browser.close();
      server.close();
    },
  };
}

/**
 * A browser for all tests of a file. A page that a test opens is closed after it; one that is opened
 * before the tests stays. What their consoles say of errors, as under the strict policy that they are
 * served with, fails the test.
 */
export async function browserForTests(documents, options) {
  const browser = await startBrowser(documents, options);
  const { pages } = browser;
  let lasting = 0;
  beforeEach(() => {
    lasting = pages.length;
  });
  afterEach(async () => {
    const complaints = pages.flatMap((viewer) => viewer.complaints);
    for (const viewer of pages.splice(lasting)) await viewer.close();
    assert.deepEqual(complaints, []);
  });
  after(() => browser.stop());
  return browser;
}

/** Answers the request of a script with the script, after which a function is called. */
export async function changedScript(route, change) {
  const response = await route.fetch();
  await route.fulfill({ response, body: `${await response.text()}\n(${change})();` });
}

/** The page with its viewer. */
export class ViewerPage {
  /** What the console says of errors and warnings, exceptions and violated policies included. */
  complaints = [];
  /** How a question of the page is answered. */
  answer = (dialog) => dialog.accept();

  /** Without what is expected, and what a driver says of the pictures that tests take. */
  constructor(page, expected = /(?!)/) {
    this.page = page;
    const isExpected = (text) =>
      expected.test(text) || text.includes('GPU stall due to ReadPixels');
    page.on('dialog', (dialog) => this.answer(dialog));
    page.on('pageerror', (error) => this.complaints.push(String(error.stack ?? error)));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type()) && !isExpected(message.text()))
        this.complaints.push(message.text());
    });
  }

  /** Calls a function in the page with the viewer and one argument. */
  evaluate(f, argument) {
    return this.page.evaluate(
      `(${f})(document.querySelector('geodesic-voronoi'), ${JSON.stringify(argument)})`,
    );
  }

  /** Sets properties of the viewer. */
  set(properties) {
    return this.evaluate(
      (viewer, properties) => void Object.assign(viewer, properties),
      properties,
    );
  }

  /** Until the viewer has nothing left to do. */
  async settled() {
    await this.page.waitForFunction(() => {
      const { status } = document.querySelector('geodesic-voronoi') ?? {};
      return status === 'ready' || status === 'failed';
    });
  }

  /** Does something, and waits for the viewer's next event of a type and for its rest. */
  async after(type, action) {
    await this.evaluate((viewer, type) => {
      viewer.awaited = new Promise((resolve, reject) => {
        setTimeout(() => reject(new Error(`No ${type} event.`)), 120_000);
        viewer.addEventListener(type, ({ detail }) => resolve({ ...detail, cause: undefined }), {
          once: true,
        });
      });
    }, type);
    await action();
    const detail = await this.evaluate((viewer) => viewer.awaited);
    await this.settled();
    return detail;
  }

  /** Chooses files in the page's dialog, by their names. */
  choose(files) {
    const chosen = Object.entries(files).map(([name, content]) => ({
      name,
      mimeType: '',
      buffer: Buffer.from(content),
    }));
    return this.page.setInputFiles('#files', chosen);
  }

  /** Clicks in the menu of downloads, and returns the file's name and content. */
  async download(row, format) {
    await this.page.click('#download-button');
    const [file] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.click(`#download-${row}-${format}`),
    ]);
    return { name: file.suggestedFilename(), content: await buffer(await file.createReadStream()) };
  }

  /** Until so many sites have been placed. */
  haveSites(count) {
    return this.page.waitForFunction(
      (count) => document.querySelector('geodesic-voronoi').sites?.face.length === count,
      count,
    );
  }

  /** Until the page has been drawn as it is now, which may change it once more. */
  drawn() {
    return this.page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
  }

  siteCount() {
    return this.evaluate((viewer) => viewer.sites.face.length);
  }

  sites() {
    return this.evaluate(({ sites }) => ({ face: [...sites.face], bary: [...sites.bary] }));
  }

  regionCount() {
    return this.evaluate(
      ({ diagram }) => diagram?.regions.filter(({ area }) => area > 0).length ?? 0,
    );
  }

  /** Where a site is on the page. */
  sitePosition(index) {
    return this.evaluate((viewer, index) => viewer.sitePosition(index), index);
  }

  /** Waits until the view has stopped gliding: all sites are seen where they were. */
  async still() {
    const places = () =>
      this.evaluate((viewer) =>
        JSON.stringify([...viewer.sites.face.keys()].map((i) => viewer.sitePosition(i))),
      );
    let last;
    for (let now = await places(); now !== last; now = await places()) {
      last = now;
      await this.page.waitForTimeout(200);
    }
  }

  /** A place on the page where the surface is seen, as far as may be from all sites and from its edge. */
  async freePlace() {
    await this.still();
    const place = await this.evaluate((viewer) => {
      const box = viewer.getBoundingClientRect();
      const sites = [...viewer.sites.face.keys()]
        .map((i) => viewer.sitePosition(i))
        .filter(Boolean);
      const step = 12;
      let best;
      for (let x = box.left + step; x < box.right - step; x += step) {
        for (let y = box.top + step; y < box.bottom - step; y += step) {
          const isInside = [0, step, -step].every((dx) =>
            [0, step, -step].every((dy) => viewer.surfaceFromPoint(x + dx, y + dy)),
          );
          // Buttons lie on the view.
          if (!isInside || document.elementFromPoint(x, y) !== viewer) continue;
          const distance = Math.min(...sites.map((site) => Math.hypot(site.x - x, site.y - y)), 60);
          if (!best || distance > best.distance) best = { x, y, distance };
        }
      }
      return best;
    });
    assert.ok(place, 'the surface is seen somewhere');
    assert.ok(place.distance > 15, `a place ${place.distance} pixels from all sites`);
    return place;
  }

  /** The highest place in a box of the page where the surface is seen, if there is one. */
  surfaceIn(box) {
    return this.evaluate((viewer, { x: left, y: top, width, height }) => {
      for (let y = top; y <= top + height; y += 2) {
        for (let x = left; x <= left + width; x += 4) {
          if (viewer.surfaceFromPoint(x, y)) return { x, y };
        }
      }
      return undefined;
    }, box);
  }

  /** A place of the view beside the model. */
  emptyPlace() {
    return this.evaluate((viewer) => {
      const box = viewer.getBoundingClientRect();
      const places = [box.left + 30, box.right - 30].map((x) => ({ x, y: box.bottom - 120 }));
      return places.find(({ x, y }) => !viewer.surfaceFromPoint(x, y));
    });
  }

  /** Keeps, in the page, what the view shows when only these layers are drawn; returns its number. */
  async picture(layers = ['regions']) {
    await this.still();
    return this.evaluate(async (viewer, layers) => {
      const before = viewer.getAttribute('layers');
      viewer.layers = layers;
      await null; // Attributes take effect together, after the code that sets them.
      const picture = await window.pixelsOf(await viewer.toBlob());
      if (before === null) viewer.removeAttribute('layers');
      else viewer.setAttribute('layers', before);
      viewer.pictures ??= [];
      return viewer.pictures.push(picture) - 1;
    }, layers);
  }

  /** The share of a picture's pixels that are not transparent. */
  coverage(picture) {
    return this.evaluate(
      (viewer, picture) => window.opaqueShare(viewer.pictures[picture]),
      picture,
    );
  }

  /** How many pixels differ between two pictures, and whether the one at a place of the page does. */
  difference(a, b, place = { x: 0, y: 0 }) {
    return this.evaluate(
      (viewer, { a, b, place }) => {
        const first = viewer.pictures[a];
        const second = viewer.pictures[b];
        const differs = (i) =>
          [0, 1, 2, 3].some((k) => Math.abs(first.data[4 * i + k] - second.data[4 * i + k]) > 8);
        let count = 0;
        for (let i = 0; i < first.width * first.height; ++i) if (differs(i)) ++count;
        const box = viewer.getBoundingClientRect();
        const scale = first.width / box.width;
        const column = Math.round((place.x - box.left) * scale);
        const row = Math.round((place.y - box.top) * scale);
        return { count, there: differs(row * first.width + column) };
      },
      { a, b, place },
    );
  }

  close() {
    return this.page.close();
  }
}
