// SPDX-License-Identifier: MIT
//
// The package installed from its tarball: what is in it, its exports and types, and its use in Node.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { zipSync } from 'fflate';
import { outlineOf } from '../../web/docs/make/pages.mjs';
import { blocks } from '../docs/documents.mjs';
import { octahedron } from '../wasm/meshes.mjs';
import { dracoModels, meshObj } from '../wasm/model_files.mjs';
import { inModules, install, run } from './installed.mjs';

let installed;
before(() => {
  installed = install('@types/node', '@types/three', 'three', 'three-mesh-bvh');
});
after(() => installed.remove());

const read = (name) => readFileSync(join(installed.packageFolder, name), 'utf8');

/** Runs a module in the folder of the installation; resolves with what it wrote. */
function runModule(code, ...options) {
  writeFileSync(join(installed.folder, 'use.mjs'), code);
  return run(process.execPath, [...options, 'use.mjs'], installed.folder);
}

test('nothing is published but what is built, its licences and its documents', () => {
  const documents =
    /^(web\/docs\/([\w-]+\.md|bench\.json|(examples|figures|pictures|plots)\/)|\.github\/C)/;
  const others = installed.files.filter((path) => !/^dist\//.test(path) && !documents.test(path));
  assert.deepEqual(others.sort(), ['LICENSE', 'README.md', 'package.json']);
});

test('what its documents link to is in it', () => {
  const documents = installed.files.filter((path) => path.endsWith('.md'));
  assert.ok(documents.length >= 9);
  for (const document of documents) {
    const { links } = outlineOf(read(document));
    for (const link of links.filter((href) => !/^([a-z]+:|#)/.test(href))) {
      const path = join(dirname(document), link.split('#')[0]);
      assert.ok(existsSync(join(installed.packageFolder, path)), `${document}: ${link}`);
    }
  }
});

test('everything that package.json names is there', () => {
  const pathsIn = (value) =>
    typeof value === 'string' ? [value] : Object.values(value).flatMap(pathsIn);
  const { bin, exports, sideEffects } = JSON.parse(read('package.json'));
  for (const path of [...pathsIn(bin), ...pathsIn(exports), ...sideEffects]) {
    assert.ok(existsSync(join(installed.packageFolder, path)), path);
  }
});

test('everything that its modules import is declared', () => {
  const { name, peerDependencies } = JSON.parse(read('package.json'));
  const declared = [name, ...Object.keys(peerDependencies)];
  const seen = new Set();
  for (const path of installed.files.filter((file) => /^dist\/.*\.js$/.test(file))) {
    const imports = read(path).matchAll(
      /(?:^(?:import|export)\b(?:[\w\s{},*]*\bfrom)?\s*|\bimport\()['"]([^.'"][^'"]*)['"]/gm,
    );
    for (const [, specifier] of imports) {
      const isDeclared = declared.some((known) => `${specifier}/`.startsWith(`${known}/`));
      assert.ok(isDeclared || specifier.startsWith('node:'), `${path} imports ${specifier}`);
      seen.add(specifier);
    }
  }
  for (const specifier of ['three', 'three-mesh-bvh', 'node:fs/promises'])
    assert.ok(seen.has(specifier), specifier);
});

test('the licences of all that is compiled in are told', () => {
  const notices = read('dist/THIRD_PARTY_NOTICES.txt');
  for (const name of ['Eigen', 'tinygltf', 'JSON for Modern C++', 'LLVM', 'musl', 'Emscripten']) {
    assert.ok(notices.includes(`\n${name} `), name);
  }
});

test('publint finds nothing', async () => {
  const pkg = JSON.parse(read('package.json'));
  const { messages } = await publint({ pkgDir: installed.packageFolder, strict: true });
  assert.deepEqual(
    messages.map((message) => formatMessage(message, pkg)),
    [],
  );
});

test('types are found as the modules are: attw finds nothing', async () => {
  const { problems } = await checkPackage(createPackageFromTarballData(installed.tarball));
  // It is a package of ES modules: require() of them works in newer versions of Node only.
  const found = problems.filter(({ kind }) => kind !== 'CJSResolvesToESM');
  // The resolution of old CommonJS projects knows no exports.
  const isOfNode10 = ({ resolutionKind, resolutionOption }) =>
    [resolutionKind, resolutionOption].includes('node10');
  assert.deepEqual(
    found.filter((problem) => !isOfNode10(problem)),
    [],
  );
});

const use = `
  import { load } from 'geodesic-voronoi';
  const gvd = await load();
  const mesh = await gvd.mesh(${JSON.stringify(octahedron())});
  const { regions } = await mesh.voronoi({ vertex: [0, 1, 2] });
  console.log(regions.length);`;

test('it works where it is installed, without code made at run time', () => {
  assert.equal(runModule(use, '--disallow-code-generation-from-strings'), '3\n');
});

test('the command works where it is installed', () => {
  const main = join(
    installed.packageFolder,
    JSON.parse(read('package.json')).bin['geodesic-voronoi'],
  );
  assert.match(run(process.execPath, [main, '--help'], installed.folder), /^Usage: /m);
});

test('files of every format are read there, without code made at run time', () => {
  writeFileSync(join(installed.folder, 'model.obj'), meshObj(octahedron()));
  writeFileSync(join(installed.folder, 'model.zip'), zipSync({ 'a.obj': meshObj(octahedron()) }));
  writeFileSync(join(installed.folder, 'draco.glb'), dracoModels()[0].bytes);
  const main = join(installed.packageFolder, 'dist/cli/main.js');
  const formats = ['model.obj', 'model.zip', 'draco.glb'].map((file) => {
    const options = ['--disallow-code-generation-from-strings', main, 'info', file];
    return run(process.execPath, options, installed.folder).split('\n')[0].replace(/\s+/, ' ');
  });
  assert.deepEqual(formats, [
    'format OBJ (model.obj)',
    'format OBJ (a.obj)',
    'format glTF (draco.glb)',
  ]);
});

test('its modules are found by their addresses', () => {
  const code = `console.log(import.meta.resolve('geodesic-voronoi/core.wasm').slice(-15));`;
  assert.equal(runModule(code), '/dist/core.wasm\n');
});

test('everything can be imported on a server, where that does nothing', () => {
  const code = `
    globalThis.fetch = () => { throw new Error('something is fetched'); };
    const before = Object.keys(globalThis).join();
    await import('geodesic-voronoi');
    await import('geodesic-voronoi/element');
    console.log(Object.keys(globalThis).join() === before);`;
  assert.equal(runModule(code), 'true\n');
});

test('importing it takes nothing that a test environment may lack, and loading tells what is missing', () => {
  const code = `
    // What Jest's jsdom lacks, for which it takes the module of pages.
    for (const name of ['TextEncoder', 'TextDecoder', 'fetch']) delete globalThis[name];
    const { load } = await import('./node_modules/geodesic-voronoi/dist/index.js');
    await load().catch(({ code, message }) => console.log(code, message));`;
  assert.match(
    runModule(code),
    /^load-failed .*core\.wasm cannot be loaded: fetch is not defined\n$/,
  );
});

test('its types are complete, with and without those of Node', () => {
  writeFileSync(
    join(installed.folder, 'use.mts'),
    `import { load, partitionGlb, type Diagram, type DiagramData, type Mesh } from 'geodesic-voronoi';
     import type { GeodesicVoronoiElement } from 'geodesic-voronoi/element';
     type Attribute = (typeof GeodesicVoronoiElement.observedAttributes)[number];
     const seed: Attribute = 'seed';
     // @ts-expect-error: not an attribute
     const seeds: Attribute = 'seeds';
     const gvd = await load();
     const mesh: Mesh = await gvd.mesh({ 'model.glb': new Uint8Array(8) });
     // As older types of three.js have it: an attribute may be one of WebGL, without getters.
     type Attributes = { [name: string]: { getX(index: number): number } | { itemSize: number } };
     const geometry = {} as { isBufferGeometry: true; attributes: Attributes; index: null };
     if (!mesh) await gvd.mesh(geometry);
     const diagram: Diagram = await mesh.voronoi(await mesh.sampleSites(3), { metric: 'exact' });
     const data: DiagramData = diagram.data;
     const loops: Int32Array[] = diagram.regions[data.arcs.labels[0]].loops;
     diagram[Symbol.dispose]();
     const unset = undefined as string | undefined; // where exactOptionalPropertyTypes is on
     await gvd.mesh(new Uint8Array(8), { file: unset, signal: undefined, onProgress: undefined });
     await mesh.remesh({ vertex: [0] }, { metric: undefined, density: undefined });
     await load({ wasm: unset });
     partitionGlb(await diagram.partition(), { mesh, layout: undefined, colours: [undefined] });
     // @ts-expect-error: not a metric
     await mesh.voronoi({ vertex: [0] }, { metric: 'euclid' });
     for await (const { data, diagram } of mesh.cvt({ vertex: [0] }, { diagrams: true }))
       console.log(data.siteCount, diagram.sites);
     for await (const { data } of mesh.cvt({ vertex: [0] }, { data: true })) console.log(data.cells);
     // @ts-expect-error: data is asked for, no diagram
     for await (const { diagram: { sites } } of mesh.cvt({ vertex: [0] }, { data: true })) break;
     const { points } = await diagram.partition();
     structuredClone(points, { transfer: [points.position.buffer, data.regionArea.buffer] });
     export { loops };`,
  );
  writeFileSync(
    join(installed.folder, 'page.mts'),
    `import { loadWorker } from 'geodesic-voronoi';
     import 'geodesic-voronoi/element';
     import { type GeodesicVoronoiElement, layers } from 'geodesic-voronoi/standalone';
     // @ts-expect-error: the script has types alone
     const known: string[] = [...layers];
     const element: GeodesicVoronoiElement = document.createElement('geodesic-voronoi');
     await loadWorker({ worker: new Worker('w.js') });
     // @ts-expect-error: no worker
     await loadWorker({ worker: { postMessage() {} } });
     const viewer = document.createElement('geodesic-voronoi');
     viewer.addEventListener('load', ({ detail }) => console.log(detail.info.faces));
     viewer.addEventListener('click', ({ clientX }) => console.log(clientX)); // as of every element
     viewer.addEventListener('dragover', (event) => event.preventDefault());
     viewer.addEventListener('mine', (event) => console.log(event.type));`,
  );
  const strict = ['--strict', '--exactOptionalPropertyTypes'];
  const options = ['--noEmit', ...strict, '--target', 'es2022', '--lib', 'es2022,dom'];
  const kinds = [
    ['--module', 'nodenext', '--types', 'node'],
    ['--module', 'node16', '--types', 'node'],
    ['--module', 'esnext', '--moduleResolution', 'bundler', '--types', ''],
  ];
  const compile = (...args) => run(inModules('.bin', 'tsc'), args, installed.folder);
  for (const kind of kinds) compile(...kind, ...options, 'use.mts', 'page.mts');
});

test('the code of its documents is strict, and Node needs no types of the DOM', () => {
  const compile = (file, code, ...args) => {
    writeFileSync(join(installed.folder, file), code);
    const options = ['--noEmit', '--strict', '--target', 'es2022', '--module', 'nodenext', file];
    run(inModules('.bin', 'tsc'), ['--types', 'node', ...options, ...args], installed.folder);
  };
  compile('node.mts', use, '--lib', 'es2022');
  for (const source of ['README.md', 'web/docs/guide.md']) {
    const code = blocks(source, 'js').join('\n');
    compile('document.mts', code, '--lib', 'es2022,dom', '--skipLibCheck');
  }
});

test('the declaration for React knows attributes and events', () => {
  const { folder } = installed;
  const [declaration] = blocks('web/docs/element.md', 'ts');
  writeFileSync(join(folder, 'element.d.ts'), declaration);
  // What the declaration and JSX ask of React's types.
  const react = join(folder, 'node_modules/react');
  mkdirSync(react);
  writeFileSync(
    join(react, 'index.d.ts'),
    `export interface HTMLAttributes<T> { onLoad?: (event: { currentTarget: T }) => void }
     export type DetailedHTMLProps<Attributes, T> = Attributes & { ref?: (element: T | null) => void };
     export namespace JSX { interface IntrinsicElements {} }`,
  );
  writeFileSync(join(react, 'jsx-runtime.d.ts'), `export { JSX } from './index.js';`);
  writeFileSync(
    join(folder, 'app.tsx'),
    `export const view = (
       <geodesic-voronoi src="a.glb" sites={40} layers={['regions']} camera-orbit="0deg 75deg 105%"
         ref={(element) => element?.refit()}
         onload={({ detail }) => console.log(detail.info.faces.toFixed())}
         onsites-change={({ detail }) => console.log(detail.count.toFixed())} />
     );
     // @ts-expect-error: not an attribute
     export const other = <geodesic-voronoi seeds={1} />;`,
  );
  const strict = ['--strict', '--noEmit', '--skipLibCheck', '--types', ''];
  const modules = ['--module', 'esnext', '--moduleResolution', 'bundler', '--jsx', 'react-jsx'];
  const libraries = ['--target', 'es2022', '--lib', 'es2022,dom'];
  const files = ['app.tsx', 'element.d.ts'];
  run(inModules('.bin', 'tsc'), [...strict, ...modules, ...libraries, ...files], folder);
});
