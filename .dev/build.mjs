// SPDX-License-Identifier: MIT
//
// npm run build: the package in dist/ and the page in build/page; with `package`, dist/ alone.

import { copyFileSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename, posix } from 'node:path';
import { gzipSync } from 'node:zlib';
import { thirdPartyNotices } from './notices.mjs';
import { setUp } from './setup.mjs';
import { at, isScript, main, run, step } from './tasks.mjs';

const wasmModules = ['core', 'gltf'];
/** How large each may be as it is transferred, compressed by gzip: kilobytes of 1000 bytes. */
const largestModules = { core: 258, gltf: 135 };
/** npm packages of which there is code in dist/. */
const bundledPackages = ['three', 'three-mesh-bvh', 'draco3d', 'earcut', 'fflate', 'meshoptimizer'];
const tool = (name) => at('node_modules', '.bin', name);

/** Configures and builds with CMake; `emcmake` in `wrapper` makes it a WebAssembly build. */
export function buildWithCMake(
  folder,
  { wrapper = [], options = ['-DCMAKE_BUILD_TYPE=Release'], targets = [] } = {},
) {
  const [command, ...args] = [...wrapper, 'cmake', '-S', '.', '-B', folder, '-G', 'Ninja'];
  run(command, [...args, ...options]);
  const selection = targets.flatMap((target) => ['--target', target]);
  run('cmake', ['--build', folder, '--parallel', String(availableParallelism()), ...selection]);
}

/** dist/: the JavaScript with the WebAssembly modules beside it, the viewer, and all of it in one file. */
export async function buildPackage() {
  const modules = wasmModules.map((name) => `build/wasm/wasm/${name}.wasm`);
  // Without wasm/src, which is TypeScript.
  const bindings = readdirSync(at('wasm')).filter((name) => name !== 'src');
  const sources = ['CMakeLists.txt', 'core', ...bindings.map((n) => `wasm/${n}`), 'package.json'];
  await step('WebAssembly', { inputs: sources, outputs: modules }, () =>
    buildWithCMake('build/wasm', { wrapper: ['emcmake'], targets: wasmModules }),
  );
  const inputs = [
    '.dev',
    'wasm/src',
    'wasm/module_address.d.ts',
    'wasm/tsconfig.json',
    'web/viewer',
    'package-lock.json',
    ...modules,
  ];
  await step('Package', { inputs, outputs: ['dist'] }, () => {
    // Nothing that a deleted source left behind may be published.
    rmSync(at('dist'), { recursive: true, force: true });
    run(tool('tsc'), ['-p', 'wasm']);
    run(tool('tsc'), ['-p', 'web/viewer']);
    for (const module of modules) copyFileSync(at(module), at('dist', basename(module)));
    copyDraco();
    copyImported();
    for (const module of ['core.wasm', 'gltf.wasm', 'draco.wasm']) {
      copyFileSync(at('wasm/module_address.d.ts'), at('dist', `${module}.d.ts`));
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

/**
 * Modules of other packages, copied to where all of dist/ finds them by their address. By its name, nothing can be
 * imported in a worker of a page with an import map, which does not count there.
 */
const copiedModules = {
  earcut: 'earcut/src/earcut.js',
  fflate: 'fflate/esm/browser.js',
  'meshoptimizer/decoder': 'meshoptimizer/meshopt_decoder.mjs',
};

function copyImported() {
  const copyOf = (name) => `input/${name.split('/')[0]}_module.js`;
  for (const [name, file] of Object.entries(copiedModules)) {
    copyFileSync(at('node_modules', file), at('dist', copyOf(name)));
  }
  const scripts = readdirSync(at('dist'), { recursive: true }).filter((p) => p.endsWith('.js'));
  for (const path of scripts) {
    const script = readFileSync(at('dist', path), 'utf8');
    const moved = script.replace(/(\bfrom |\bimport\()'([^']+)'/g, (whole, before, name) => {
      if (!Object.hasOwn(copiedModules, name)) return whole;
      const address = posix.relative(posix.dirname(path), copyOf(name));
      return `${before}'${address.startsWith('.') ? address : `./${address}`}'`;
    });
    if (moved !== script) writeFileSync(at('dist', path), moved);
  }
}

/**
 * Draco's decoder. Its script is one of Node or of a page; as a module of either it needs nothing of
 * Node, since the library gives it its WebAssembly.
 */
function copyDraco() {
  const script = readFileSync(at('node_modules/draco3d/draco_decoder_nodejs.js'), 'utf8');
  const absent = `const exports = undefined, module = undefined, define = undefined;
const __dirname = '', require = () => ({});`;
  writeFileSync(
    at('dist/input/draco_decoder.js'),
    `// Draco, copyright Google, Apache License 2.0: https://github.com/google/draco
${absent}
${script}
export default DracoDecoderModule;
`,
  );
  copyFileSync(at('node_modules/draco3d/draco_decoder.wasm'), at('dist/draco.wasm'));
}

/** build/page: the demo, ready for a static host; and the package, of which it is made. */
export async function buildPage() {
  await buildPackage();
  await step(
    'Page',
    { inputs: ['web', 'dist', 'package-lock.json'], outputs: ['build/page/index.html'] },
    async () => {
      run(tool('tsc'), ['-p', 'web/page']);
      // Not by its command: there are two Vites, the older one for the tests of the package.
      const { build } = await import('vite');
      await build({ root: at('web/page') });
      checkPageSize();
    },
  );
}

/** Compressed, in kilobytes, of what the page fetches until the first diagram is seen, the model aside. */
const mostKilobytes = { page: 221, all: 479 };
/** What that is, by the names before Vite's hashes; the scripts that these import come with them. */
const firstFiles = [
  ...['index', 'main', 'worker', 'worker_server', 'drawing_worker', 'ply_reader'],
  ...['core', 'icon', 'poster'],
];

/** Prints it, and fails if it is more than that. */
function checkPageSize() {
  const folder = 'build/page/assets';
  const files = readdirSync(at(folder));
  const names = new Set();
  for (const first of firstFiles) {
    const found = files.filter((file) => file.replace(/-.{8}\.\w+$/, '') === first);
    if (found.length === 0) throw new Error(`${folder} has no ${first}, of which the size counts`);
    for (const name of found) names.add(name);
  }
  for (const name of names) {
    if (!name.endsWith('.js')) continue;
    const imports = readFileSync(at(folder, name), 'utf8').matchAll(
      /(?:from|import)"\.\/([^"]+)"/g,
    );
    for (const [, imported] of imports) names.add(imported);
  }
  const sizes = [...names, '../index.html'].map((name) => {
    const size = gzipSync(readFileSync(at(folder, name)), { level: 9 }).length / 1000;
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
    await (process.argv[2] === 'package' ? buildPackage() : buildPage());
  });
}
