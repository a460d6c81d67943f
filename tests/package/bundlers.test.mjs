// SPDX-License-Identifier: MIT
//
// The package in pages, the way others put pages together: by bundlers, by a development server, or
// by nothing but an import map. The library, its worker and the element have to work in each, and
// nothing may come from the network but what the page's own server has.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { build as buildWithEsbuild } from 'esbuild';
import { chromium } from 'playwright-core';
import * as vite8 from 'vite';
import * as vite6 from 'vite6';
import { glb, octahedron } from '../wasm/meshes.mjs';
import { assertWorkersAreNotImported, browserOptions } from '../web/browser.mjs';
import { install, run } from './installed.mjs';

const webpack = createRequire(import.meta.url)('webpack');

const page = (head) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8" /><title>App</title>${head}</head>
<body>
<geodesic-voronoi src="model.glb" sites="3" layers="regions original"></geodesic-voronoi>
</body></html>
`;

/** Counts the regions of three sites, here and in a worker, and waits for the element and its readers. */
const app = `
import { load, loadWorker } from 'geodesic-voronoi';
import 'geodesic-voronoi/element';

const element = document.querySelector('geodesic-voronoi');
const original = new Promise((resolve) =>
  element.addEventListener('original', ({ detail }) => resolve(detail.problem ?? 'no problem')),
);

async function countRegions(library) {
  const mesh = await library.mesh(${JSON.stringify(octahedron())});
  const { regions } = await mesh.voronoi({ vertex: [0, 1, 2] });
  library.dispose();
  return regions.length;
}

async function run() {
  const result = [await countRegions(await load()), await countRegions(await loadWorker())];
  while (!['ready', 'failed'].includes(element.status)) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  return [...result, element.status, await original];
}
run().then((result) => (window.result = result), (error) => (window.result = String(error)));
`;

/** The sources: what a page of each kind is made of. */
function writeApp(folder) {
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  writeFileSync(join(folder, 'main.js'), app);
  writeFileSync(
    join(folder, 'index.html'),
    page('<script type="module" src="./main.js"></script>'),
  );
  mkdirSync(join(folder, 'public'));
  writeFileSync(join(folder, 'public/model.glb'), glb(octahedron()));
}

const mediaTypes = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.wasm': 'application/wasm',
};

/** Serves a folder under a policy as strict as the package allows; `close()` ends it. */
async function serve(folder, policy = "script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'") {
  const server = createServer((request, response) => {
    const path = new URL(request.url, 'http://page').pathname.replace(/\/$/, '/index.html');
    try {
      const content = readFileSync(join(folder, path));
      response.writeHead(200, {
        'Content-Type': mediaTypes[extname(path)] ?? 'application/octet-stream',
        'Content-Security-Policy': `default-src 'self'; ${policy}`,
      });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** Opens a page and holds it to what it should come to. */
async function assertWorks(address) {
  const { origin } = new URL(address);
  const tab = await browser.newPage();
  const complaints = [];
  tab.on('pageerror', (error) => complaints.push(String(error)));
  tab.on('response', (response) => {
    if (response.status() >= 400 && !response.url().endsWith('/favicon.ico')) {
      complaints.push(`${response.status()} ${response.url()}`);
    }
  });
  tab.on('request', (request) => {
    const url = new URL(request.url());
    if (url.origin !== origin && !['blob:', 'data:'].includes(url.protocol))
      complaints.push(url.href);
  });
  try {
    await tab.goto(address, { timeout: 120_000 });
    await tab.waitForFunction(() => window.result, undefined, { timeout: 120_000 });
    assert.deepEqual(complaints, []);
    assert.deepEqual(await tab.evaluate(() => window.result), [3, 3, 'ready', 'no problem']);
  } finally {
    await tab.close();
  }
}

async function assertFolderWorks(folder, policy) {
  const server = await serve(folder, policy);
  try {
    await assertWorks(server.address);
  } finally {
    server.close();
  }
}

let installed;
let browser;
before(async () => {
  installed = install('three', 'three-mesh-bvh');
  writeApp(installed.folder);
  browser = await chromium.launch(browserOptions);
});
after(async () => {
  await browser?.close();
  installed?.remove();
});

for (const [name, vite] of [
  ['Vite 6', vite6],
  ['Vite 8', vite8],
]) {
  test(`${name}: a production build`, async () => {
    const outDir = join(installed.folder, `out-${name}`);
    await vite.build({
      configFile: false,
      logLevel: 'error',
      root: installed.folder,
      base: './',
      build: { outDir, target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 2000 },
      ...(name === 'Vite 6' && { worker: { format: 'es' } }),
    });
    await assertFolderWorks(outDir);
    await assertWorkersAreNotImported(outDir);
  });

  test(`${name}: the development server`, async () => {
    const server = await vite.createServer({
      configFile: false,
      logLevel: 'error',
      root: installed.folder,
      cacheDir: join(installed.folder, `cache-${name}`),
      // Bundled in advance, a package's addresses of its own files would be those of the bundle.
      optimizeDeps: { exclude: ['geodesic-voronoi'] },
      server: { host: '127.0.0.1', port: 0, fs: { strict: false } },
    });
    try {
      await server.listen();
      await assertWorks(`http://127.0.0.1:${server.httpServer.address().port}/`);
    } finally {
      await server.close();
    }
  });
}

test('webpack', async () => {
  const outDir = join(installed.folder, 'out-webpack');
  const stats = await new Promise((resolve, reject) => {
    const configuration = {
      context: installed.folder,
      mode: 'production',
      entry: './main.js',
      output: { path: outDir, filename: 'main.js' },
      // To minify three.js takes a minute, and tells nothing of the package.
      optimization: { minimize: false },
      performance: { hints: false },
    };
    webpack(configuration, (error, result) => (error ? reject(error) : resolve(result)));
  });
  const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true });
  assert.deepEqual(
    [...errors, ...warnings].map(({ message }) => message),
    [],
  );
  copyPage(outDir);
  await assertFolderWorks(outDir);
});

/** The page and its model, beside a bundle. */
function copyPage(folder) {
  for (const name of ['index.html', 'public/model.glb']) {
    cpSync(join(installed.folder, name), join(folder, name.split('/').at(-1)));
  }
}

test('esbuild, with the workers as entries of their own and the modules beside them', async () => {
  const outDir = join(installed.folder, 'out-esbuild');
  const inPackage = (name) => join(installed.packageFolder, 'dist', name);
  await buildWithEsbuild({
    absWorkingDir: installed.folder,
    entryPoints: {
      main: 'main.js',
      worker: inPackage('worker.js'),
      drawing_worker: inPackage('viewer/buffers/drawing_worker.js'),
    },
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    outdir: outDir,
    logLevel: 'error',
  });
  for (const name of ['core.wasm', 'gltf.wasm']) cpSync(inPackage(name), join(outDir, name));
  copyPage(outDir);
  await assertFolderWorks(outDir);
});

test('esbuild, as a script of Node that is no ES module and is given its modules', async () => {
  writeFileSync(
    join(installed.folder, 'script.js'),
    `import { load } from 'geodesic-voronoi';
     const count = async (options) => {
       const gvd = await load(options);
       return (await gvd.mesh(${JSON.stringify(octahedron())})).info.faces;
     };
     const wasm = ${JSON.stringify(join(installed.packageFolder, 'dist/core.wasm'))};
     count({ wasm }).then(console.log);
     count().catch((error) => console.log(error.message));`,
  );
  await buildWithEsbuild({
    absWorkingDir: installed.folder,
    entryPoints: ['script.js'],
    bundle: true,
    platform: 'node',
    format: 'cjs',
    outfile: 'script.cjs',
    logLevel: 'error',
  });
  const lines = run(process.execPath, ['script.cjs'], installed.folder).trim().split('\n');
  assert.ok(lines.includes('8'), lines.join());
  assert.match(lines.join(), /wasm is undefined, not an address/);
});

test('a plain page with an import map', async () => {
  const imports = {
    'geodesic-voronoi': './node_modules/geodesic-voronoi/dist/index.js',
    'geodesic-voronoi/element': './node_modules/geodesic-voronoi/dist/viewer/element.js',
    three: './node_modules/three/build/three.module.js',
    'three/addons/': './node_modules/three/examples/jsm/',
    'three-mesh-bvh': './node_modules/three-mesh-bvh/build/index.module.js',
  };
  const map = JSON.stringify({ imports });
  const folder = join(installed.folder, 'plain');
  mkdirSync(folder);
  for (const name of Object.values(imports)) {
    const [, module] = name.match(/^\.\/node_modules\/([^/]+)/);
    const from = join(installed.folder, 'node_modules', module);
    cpSync(from, join(folder, 'node_modules', module), {
      recursive: true,
      dereference: true,
      filter: (path) => !/\/(examples\/(fonts|textures|models)|src)(\/|$)/.test(path),
    });
  }
  const head = `<script type="importmap">${map}</script><script type="module" src="./main.js"></script>`;
  copyPage(folder);
  cpSync(join(installed.folder, 'main.js'), join(folder, 'main.js'));
  writeFileSync(join(folder, 'index.html'), page(head));
  const hash = createHash('sha256').update(map).digest('base64');
  await assertFolderWorks(
    folder,
    `script-src 'self' 'wasm-unsafe-eval' 'sha256-${hash}'; worker-src 'self'`,
  );
});
