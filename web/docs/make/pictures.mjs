// SPDX-License-Identifier: MIT
//
// The pictures of the README and of the gallery: the element, photographed in a browser. Sites come from the library, so
// the same code takes the same pictures, as far as the graphics card agrees.

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { load } from 'geodesic-voronoi';
import { chromium } from 'playwright-core';
import { browserOptions } from '../../../tests/web/browser.mjs';
import { makeSamples } from '../../page/samples/samples.mjs';
import { servePackages } from './packages_server.mjs';

/** Softer than the page in the dark, and the same in every reader's browser. */
const backdrop = 'radial-gradient(circle at 50% 42%, #3a4150, #20252d 62%, #15181d)';

/** Of a picture in the gallery. */
const small = { width: 330, height: 220 };

/** Writes hero.webp, stages.webp and those of the gallery into a folder. */
export async function takePictures(folder) {
  const models = mkdtempSync(join(tmpdir(), 'geodesic-voronoi-'));
  const server = await servePackages(models);
  const browser = await chromium.launch(browserOptions);
  try {
    makeSamples(models);
    const gvd = await load();
    const even = (model, count) => evenSites(gvd, join(models, model), count);
    const random = (model, count) => randomSites(gvd, join(models, model), count);
    const pictures = {
      'hero.webp': {
        size: { width: 1200, height: 460 },
        views: [
          { src: 'knot.glb', sites: await even('knot.glb', 120) },
          { src: 'bunny.ply', sites: await even('bunny.ply', 160) },
          { src: 'tangle.glb', sites: await even('tangle.glb', 150) },
        ],
      },
      'stages.webp': {
        size: { width: 1200, height: 340 },
        views: [
          { src: 'bunny.ply', sites: await random('bunny.ply', 70), name: 'random sites' },
          { src: 'bunny.ply', sites: await even('bunny.ply', 70), name: 'at centroids' },
          { src: 'bunny.ply', sites: await even('bunny.ply', 70), name: 'parts', exploded: 0.12 },
          {
            src: 'bunny.ply',
            sites: await even('bunny.ply', 70),
            name: 'dual',
            layers: 'dual sites',
          },
        ],
      },
      'even-sampling.webp': {
        size: small,
        views: [{ src: 'bunny.ply', sites: await even('bunny.ply', 300), layers: 'sites' }],
      },
      'base-mesh.webp': {
        size: small,
        views: [{ src: 'torus.glb', sites: await even('torus.glb', 30), layers: 'dual sites' }],
      },
      'feature-ids.webp': {
        size: small,
        views: [{ src: 'tangle.glb', sites: await even('tangle.glb', 50), exploded: 0.1 }],
      },
      'log-map.webp': {
        size: small,
        views: [
          { src: 'bunny.ply', sites: await random('bunny.ply', 1), layers: 'distances sites' },
        ],
      },
      'printable-parts.webp': {
        size: small,
        views: [{ src: 'bunny.ply', sites: await even('bunny.ply', 12), exploded: 0.3 }],
      },
    };
    for (const [name, picture] of Object.entries(pictures)) {
      writeFileSync(join(models, 'index.html'), pageOf(picture));
      writeFileSync(join(folder, name), await photograph(browser, server.address, picture));
    }
    gvd.dispose();
  } finally {
    await browser.close();
    server.close();
    rmSync(models, { recursive: true });
  }
}

async function evenSites(gvd, path, count) {
  const mesh = await gvd.mesh(readFileSync(path));
  let last;
  const options = { iterations: 40 };
  for await (const { sites } of mesh.cvt(await mesh.sampleSites(count, { seed: 4 }), options))
    last = sites;
  mesh.dispose();
  return plain(last);
}

async function randomSites(gvd, path, count) {
  const mesh = await gvd.mesh(readFileSync(path));
  const sites = await mesh.sampleSites(count, { seed: 4 });
  mesh.dispose();
  return plain(sites);
}

const plain = ({ face, bary }) => ({ face: [...face], bary: [...bary] });

function pageOf({ views }) {
  const elements = views.map(({ src, name, exploded, layers }) => {
    const attributes = [
      `src="${src}"`,
      `layers="${layers ?? (views.length < 4 ? 'regions bisectors' : 'regions bisectors sites')}"`,
    ];
    if (exploded) attributes.push(`exploded="${exploded}"`);
    return `<figure><geodesic-voronoi ${attributes.join(' ')}></geodesic-voronoi><figcaption>${name ?? ''}</figcaption></figure>`;
  });
  return `<!doctype html>
<meta charset="utf-8" />
<style>
  html { height: 100%; background: ${backdrop}; color: #e7eaee; font: 600 15px system-ui, sans-serif }
  body { display: flex; height: 100%; margin: 0 }
  figure { flex: 1; display: flex; flex-direction: column; margin: 0; min-width: 0 }
  geodesic-voronoi { flex: 1; width: 100% }
  figcaption { padding: 0 0 14px; text-align: center }
  geodesic-voronoi::part(distances) { display: none }
  figcaption:empty { display: none }
</style>
<script type="importmap">${readFileSync(new URL('../examples/live.html', import.meta.url), 'utf8').match(/<script type="importmap">([^]*?)<\/script>/)[1]}</script>
<script type="module">import 'geodesic-voronoi/element';</script>
${elements.join('\n')}`;
}

/** The page as it is when all views have drawn, as WebP. */
async function photograph(browser, address, { size, views }) {
  const page = await browser.newPage({
    viewport: size,
    deviceScaleFactor: 1.5,
    reducedMotion: 'reduce',
    colorScheme: 'dark',
  });
  page.setDefaultTimeout(120_000);
  await page.goto(address);
  const settled = () =>
    page.waitForFunction(() =>
      [...document.querySelectorAll('geodesic-voronoi')].every(({ status }) => status === 'ready'),
    );
  await settled();
  await page.evaluate(
    (lists) => {
      document.querySelectorAll('geodesic-voronoi').forEach((viewer, i) => {
        viewer.drawn = new Promise((resolve) =>
          viewer.addEventListener('diagram', resolve, { once: true }),
        );
        viewer.sites = lists[i];
      });
    },
    views.map(({ sites }) => sites),
  );
  await page.evaluate(() =>
    Promise.all([...document.querySelectorAll('geodesic-voronoi')].map(({ drawn }) => drawn)),
  );
  await settled();
  // What is derived from a diagram (the dual, parts) and then drawn comes a little later.
  await page.waitForTimeout(4000);
  const png = (await page.screenshot()).toString('base64');
  const webp = await page.evaluate(async (png) => {
    const image = await createImageBitmap(
      await (await fetch(`data:image/png;base64,${png}`)).blob(),
    );
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext('2d').drawImage(image, 0, 0);
    const bytes = new Uint8Array(
      await (await canvas.convertToBlob({ type: 'image/webp', quality: 0.86 })).arrayBuffer(),
    );
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  }, png);
  await page.close();
  return Buffer.from(webp, 'base64');
}
