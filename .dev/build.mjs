// SPDX-License-Identifier: MIT
//
// npm run build: the package in dist/ and the page in build/page; with `package`, dist/ alone.

import { copyFileSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import { thirdPartyNotices } from './notices.mjs';
import { setUp } from './setup.mjs';
import { at, exists, isScript, main, run, step } from './tasks.mjs';

const wasmModules = ['core', 'gltf'];
/** How large each may be as it is transferred, compressed by gzip: kilobytes of 1000 bytes. */
const largestModules = { core: 220, gltf: 130 };
/** npm packages of which there is code in dist/. */
const bundledPackages = ['three', 'three-mesh-bvh'];
const tool = (name) => at('node_modules', '.bin', name);

/** Configures once and builds with CMake; `emcmake` in `wrapper` makes it a WebAssembly build. */
export function buildWithCMake(
  folder,
  { wrapper = [], options = ['-DCMAKE_BUILD_TYPE=Release'], targets = [] } = {},
) {
  if (!exists(at(folder, 'build.ninja'))) {
    const [command, ...args] = [...wrapper, 'cmake', '-S', '.', '-B', folder, '-G', 'Ninja'];
    run(command, [...args, ...options]);
  }
  const selection = targets.flatMap((target) => ['--target', target]);
  run('cmake', ['--build', folder, '--parallel', String(availableParallelism()), ...selection]);
}

/** dist/: the JavaScript with the WebAssembly modules beside it, the viewer, and all of it in one file. */
export async function buildPackage() {
  const modules = wasmModules.map((name) => `build/wasm/wasm/${name}.wasm`);
  const sources = ['CMakeLists.txt', 'core', 'wasm', 'package.json'];
  await step('WebAssembly', { inputs: sources, output: modules[0] }, () =>
    buildWithCMake('build/wasm', { wrapper: ['emcmake'], targets: wasmModules }),
  );
  const inputs = [
    'wasm/src',
    'wasm/module_address.d.ts',
    'wasm/tsconfig.json',
    'web/viewer',
    'package-lock.json',
    ...modules,
  ];
  await step('Package', { inputs, output: 'dist' }, () => {
    // Nothing that a deleted source left behind may be published.
    rmSync(at('dist'), { recursive: true, force: true });
    run(tool('tsc'), ['-p', 'wasm']);
    run(tool('tsc'), ['-p', 'web/viewer']);
    for (const module of modules) {
      const copy = at('dist', basename(module));
      copyFileSync(at(module), copy);
      copyFileSync(at('wasm/module_address.d.ts'), `${copy}.d.ts`);
    }
    run(tool('rolldown'), ['--config', 'web/viewer/standalone.config.mjs']);
    const folders = readFileSync(at('build/wasm/header_folders.txt'), 'utf8').trim().split('\n');
    writeFileSync(at('dist/THIRD_PARTY_NOTICES.txt'), thirdPartyNotices(folders, bundledPackages));
    checkSizes();
  });
}

/** Prints how large the WebAssembly modules are; one above its limit is an error. */
function checkSizes() {
  for (const [name, limit] of Object.entries(largestModules)) {
    const bytes = readFileSync(at('dist', `${name}.wasm`));
    const compressed = gzipSync(bytes, { level: 9 }).length / 1000;
    const size = `${compressed.toFixed(1)} KB compressed, ${(bytes.length / 1000).toFixed(1)} KB plain`;
    console.log(`${name}.wasm: ${size}; at most ${limit} KB compressed`);
    if (compressed > limit) throw new Error(`${name}.wasm is larger than ${limit} KB compressed`);
  }
}

/** build/page: the demo, ready for a static host. */
export async function buildPage() {
  await step(
    'Page',
    { inputs: ['web', 'dist', 'package-lock.json'], output: 'build/page/index.html' },
    () => {
      run(tool('tsc'), ['-p', 'web/page']);
      run(tool('vite'), ['build', 'web/page']);
      checkPageSize();
    },
  );
}

/** What the page fetches until the first diagram is seen, the model aside: compressed, in kilobytes. */
const mostKilobytes = { page: 230, all: 590 };

/** Fetched when somebody downloads something, and when the first picture is under way. */
const laterScripts = ['exports', 'encoding_worker', 'search_tree'];

/** Prints it, and fails if it is more than that. */
function checkPageSize() {
  const sizes = readdirSync(at('build/page/assets'))
    .filter((name) => !laterScripts.some((later) => name.startsWith(`${later}-`)))
    .map((name) => ({ name, path: at('build/page/assets', name) }))
    .concat({ name: 'index.html', path: at('build/page/index.html') })
    .map(({ name, path }) => {
      const size = gzipSync(readFileSync(path), { level: 9 }).length / 1000;
      return { name, size };
    });
  const sum = (list) => list.reduce((total, { size }) => total + size, 0);
  const page = sum(sizes.filter(({ name }) => !name.endsWith('.wasm')));
  const all = sum(sizes);
  const tell = (size, what) => console.log(`${size.toFixed(1).padStart(8)} KB  ${what}`);
  for (const { name, size } of sizes) tell(size, name);
  tell(all, `until the first diagram, ${page.toFixed(1)} of it the page itself`);
  if (page > mostKilobytes.page || all > mostKilobytes.all) {
    const most = `${mostKilobytes.page} KB for the page itself or ${mostKilobytes.all} KB in all`;
    throw new Error(`That is more than ${most}.`);
  }
}

if (isScript(import.meta.url)) {
  await main(async () => {
    setUp('build');
    await buildPackage();
    if (process.argv[2] !== 'package') await buildPage();
  });
}
