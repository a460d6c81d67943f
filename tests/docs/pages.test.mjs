// SPDX-License-Identifier: MIT
//
// The documents' pages for a browser: the README's and the example of a live diagram.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { servePackages } from '../../web/docs/make/packages_server.mjs';
import { torus } from '../../web/page/samples/shapes.mjs';
import { glb } from '../wasm/meshes.mjs';
import { browserOptions } from '../web/browser.mjs';
import { blocks, root } from './documents.mjs';
import { temporaryFolder } from '../wasm/temporary_folder.mjs';

const live = readFileSync(join(root, 'web/docs/examples/live.html'), 'utf8');
const folder = temporaryFolder();
writeFileSync(join(folder, 'model.glb'), glb(torus(40, 20)));
const server = await servePackages(folder);
after(() => server.close());
const browser = await chromium.launch(browserOptions);
after(() => browser.close());

/** Opens a page and waits until its element is at rest. */
async function open(html) {
  writeFileSync(join(folder, 'index.html'), html);
  const page = await browser.newPage({
    viewport: { width: 500, height: 400 },
    reducedMotion: 'reduce',
  });
  page.setDefaultTimeout(120_000);
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(server.address);
  await page.waitForFunction(() =>
    ['ready', 'failed'].includes(document.querySelector('geodesic-voronoi')?.status),
  );
  assert.deepEqual(complaints, []);
  return page;
}

const regionCount = (page) =>
  page.evaluate(() => document.querySelector('geodesic-voronoi').diagram.regions.length);

test('the live diagram tells its regions, and one more when a site is added', async () => {
  const page = await open(live);
  assert.equal(await regionCount(page), 40);
  assert.match(await page.textContent('output'), /^40 regions in \d+ ms$/);
  await page.evaluate(() =>
    document.querySelector('geodesic-voronoi').addSite({ face: 3, bary: [0.2, 0.3, 0.5] }),
  );
  await page.waitForFunction(() => document.querySelector('output').textContent.startsWith('41 '));
  await page.close();
});

test('what scrolls in a document is reached by keys, and its examples are saved', async () => {
  const page = await browser.newPage({ viewport: { width: 360, height: 640 } });
  const missing = [];
  page.on('requestfailed', (request) => missing.push(request.url()));
  await page.goto(String(pathToFileURL(join(root, 'build/page/docs/gallery.html'))));
  const unreached = await page.evaluate(() =>
    [...document.querySelectorAll('pre, .wide')]
      .filter(({ scrollWidth, clientWidth, tabIndex }) => scrollWidth > clientWidth && tabIndex < 0)
      .map(({ textContent }) => textContent),
  );
  assert.deepEqual(unreached, []);
  assert.ok((await page.locator('pre[aria-label=Code]').count()) > 0);
  assert.equal(await page.getAttribute('a[href="examples/live.html"]', 'download'), '');
  assert.equal(await page.locator('link[rel=icon]').count(), 1);
  assert.deepEqual(missing, []);
  await page.close();
});

const [importMap] = live.match(/<script type="importmap">[^]*?<\/script>/);

test('the page of the element’s document tells areas, and its sites come back', async () => {
  const html = blocks('web/docs/element.md', 'html').find((block) =>
    block.includes('localStorage'),
  );
  const page = await open(`<!doctype html>\n${importMap}\n${html}`);
  assert.match(await page.textContent('output'), /^40 regions, areas up to 0\.\d+$/);
  await page.evaluate(() => document.querySelector('geodesic-voronoi').removeSite(3));
  await page.waitForFunction(() => document.querySelector('output').textContent.startsWith('39 '));
  await page.reload();
  await page.waitForFunction(() => document.querySelector('output').textContent.startsWith('39 '));
  await page.close();
});

test('the element of the readme shows a diagram', async () => {
  const [snippet, ...more] = blocks('README.md', 'html');
  assert.equal(more.length, 0);
  const page = await open(`<!doctype html>\n${importMap}\n${snippet}`);
  assert.equal(await regionCount(page), 40);
  await page.close();
});
