// SPDX-License-Identifier: MIT
//
// `loadWorker` in a browser with real workers: found beside the library, and where they are not, as
// under bundlers that do not understand `new URL(…, import.meta.url)`.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { browserOptions } from './browser.mjs';

const dist = new URL('../../dist/', import.meta.url);
const mediaTypes = { js: 'text/javascript', wasm: 'application/wasm' };

/** /lib/ has all files; /app/ has the library without the worker's script and the modules. */
async function answer(route) {
  const [, folder, ...path] = new URL(route.request().url()).pathname.split('/');
  const file = path.join('/');
  if (!file) return route.fulfill({ contentType: 'text/html', body: '<!doctype html>' });
  const ending = file.split('.').at(-1);
  const isMissing = folder === 'app' && (file === 'worker.js' || ending === 'wasm');
  if (isMissing) return route.fulfill({ status: 404 });
  const body = await readFile(new URL(file, dist));
  return route.fulfill({ contentType: mediaTypes[ending], body });
}

let browser;
let page;
before(async () => {
  browser = await chromium.launch(browserOptions);
  const context = await browser.newContext();
  await context.route('**/*', answer);
  page = await context.newPage();
  await page.goto('http://page.test/');
});
after(() => browser.close());

/** How many regions a library has found that was loaded with such options, written as code. */
function regions(folder, options) {
  return page.evaluate(`(async () => {
    const { loadWorker } = await import('/${folder}/index.js');
    try {
      const gvd = await loadWorker(${options});
      const mesh = await gvd.mesh({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2] });
      const { length } = (await mesh.voronoi({ vertex: [0, 1, 2] })).regions;
      gvd.dispose();
      return length;
    } catch (error) {
      return error.code + ': ' + error.message;
    }
  })()`);
}

const modules = `wasm: '/lib/core.wasm', gltfWasm: '/lib/gltf.wasm'`;

test('a worker and its modules are found beside the library', async () => {
  assert.equal(await regions('lib', ''), 3);
});

test('an answer of a Worker that cannot be received ends what waits', async () => {
  const worker = `Object.assign(new Worker('/lib/worker.js', { type: 'module' }), {
    postMessage() {
      this.dispatchEvent(new MessageEvent('messageerror'));
    },
  })`;
  assert.equal(
    await regions('lib', `{ worker: ${worker} }`),
    'load-failed: the worker has stopped: its answer cannot be received',
  );
});

test('elsewhere they are given: an address, a Worker; addresses, a Response or bytes', async () => {
  assert.match(await regions('app', ''), /^load-failed: the worker "worker\.js" has stopped/);
  assert.match(await regions('app', `{ worker: '/lib/worker.js' }`), /^load-failed: .*404/);
  assert.equal(await regions('app', `{ worker: '/lib/worker.js', ${modules} }`), 3);
  const worker = `new Worker('/lib/worker.js', { type: 'module' })`;
  assert.equal(await regions('app', `{ worker: ${worker}, ${modules} }`), 3);
  const url = `new URL('/lib/worker.js', location)`;
  const response = `await fetch('/lib/core.wasm')`;
  assert.equal(await regions('app', `{ worker: ${url}, wasm: ${response} }`), 3);
  const bytes = `await (${response}).arrayBuffer()`;
  assert.equal(await regions('app', `{ worker: ${url}, wasm: ${bytes} }`), 3);
});
