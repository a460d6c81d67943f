// SPDX-License-Identifier: MIT
//
// npm run build: the package in dist/ and the page in build/page; with `package`, dist/ alone.

import { copyFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { setUp } from './setup.mjs';
import { at, exists, isScript, main, run, step } from './tasks.mjs';

const wasmModules = ['core', 'gltf'];
const tool = (name) => at('node_modules', '.bin', name);

/** Configures once and builds with CMake; `configure` is the command that configures. */
export function buildNative(folder, configure, targets = []) {
  if (!exists(at(folder, 'build.ninja'))) {
    run(configure[0], [...configure.slice(1), '-S', '.', '-B', folder, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release']);
  }
  const selection = targets.flatMap((target) => ['--target', target]);
  run('cmake', ['--build', folder, '--parallel', String(availableParallelism()), ...selection]);
}

/** dist/: the JavaScript, the modules beside it, the viewer. */
export async function buildPackage() {
  // Empties dist/ first: nothing that a deleted source left behind may be published.
  await step('TypeScript', { inputs: ['wasm/src', 'tsconfig.json', 'package-lock.json'], output: 'dist/index.js' }, () => {
    rmSync(at('dist'), { recursive: true, force: true });
    run(tool('tsc'), []);
  });
  const sources = ['CMakeLists.txt', 'core', 'wasm', 'package.json'];
  await step('WebAssembly', { inputs: sources, output: 'dist/core.wasm' }, () => {
    buildNative('build/wasm', ['emcmake', 'cmake'], wasmModules);
    for (const name of wasmModules) copyFileSync(at('build/wasm/wasm', `${name}.wasm`), at('dist', `${name}.wasm`));
  });
  await step('Viewer', { inputs: ['web/viewer', 'dist/index.d.ts', 'tsconfig.json'], output: 'dist/viewer' }, () =>
    run(tool('tsc'), ['-p', 'web/viewer']),
  );
}

/** build/page: the demo, ready for a static host. */
export async function buildPage() {
  await step('Page', { inputs: ['web', 'dist', 'package-lock.json'], output: 'build/page/index.html' }, () =>
    run(tool('vite'), ['build', 'web/page']),
  );
}

if (isScript(import.meta.url)) {
  await main(async () => {
    setUp('build');
    await buildPackage();
    if (process.argv[2] !== 'package') await buildPage();
  });
}
