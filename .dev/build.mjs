// SPDX-License-Identifier: MIT
//
// npm run build: the package in dist/ and the page in build/page; with `package`, dist/ alone.

import { copyFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename } from 'node:path';
import { setUp } from './setup.mjs';
import { at, exists, isScript, main, run, step } from './tasks.mjs';

const wasmModules = ['core', 'gltf'];
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
  const inputs = ['wasm/src', 'wasm/tsconfig.json', 'web/viewer', 'package-lock.json', ...modules];
  await step('Package', { inputs, output: 'dist' }, () => {
    // Nothing that a deleted source left behind may be published.
    rmSync(at('dist'), { recursive: true, force: true });
    run(tool('tsc'), ['-p', 'wasm']);
    run(tool('tsc'), ['-p', 'web/viewer']);
    for (const module of modules) copyFileSync(at(module), at('dist', basename(module)));
    run(tool('rolldown'), ['--config', 'web/viewer/standalone.config.mjs']);
  });
}

/** build/page: the demo, ready for a static host. */
export async function buildPage() {
  await step(
    'Page',
    { inputs: ['web', 'dist', 'package-lock.json'], output: 'build/page/index.html' },
    () => {
      run(tool('tsc'), ['-p', 'web/page']);
      run(tool('vite'), ['build', 'web/page']);
    },
  );
}

if (isScript(import.meta.url)) {
  await main(async () => {
    setUp('build');
    await buildPackage();
    if (process.argv[2] !== 'package') await buildPage();
  });
}
