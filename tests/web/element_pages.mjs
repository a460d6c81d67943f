// SPDX-License-Identifier: MIT
//
// Pages with the element, for its tests.

import { createHash } from 'node:crypto';
import { gltf } from '../wasm/meshes.mjs';

const standalone = '<script type="module" src="/package/standalone.js"></script>';
const importMap = JSON.stringify({
  imports: {
    'geodesic-voronoi': '/package/index.js',
    three: '/modules/three/build/three.module.js',
    'three/addons/': '/modules/three/examples/jsm/',
    'three-mesh-bvh': '/modules/three-mesh-bvh/build/index.module.js',
  },
});
export const model = 'src="/samples/torus.glb" sites="12"';

export const tetrahedron = gltf({
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
  indices: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
});

function page(body, head = standalone) {
  return {
    html: `<!doctype html><html lang="en"><head><meta charset="utf-8" /><title>Test</title>
      <link rel="icon" href="/icon.svg" />${head}</head><body>${body}</body></html>`,
  };
}

/** A page that has every script of the package by itself. */
function byImportMap(body) {
  const hash = createHash('sha256').update(importMap).digest('base64');
  return {
    ...page(
      body,
      `<script type="importmap">${importMap}</script>
       <script type="module" src="/package/viewer/element.js"></script>`,
    ),
    policy:
      `default-src 'self'; script-src 'self' 'wasm-unsafe-eval' 'sha256-${hash}'; ` +
      "worker-src 'self'",
  };
}

export const longText = '<p>A paragraph</p>'.repeat(100);
const twenty = Array.from(
  { length: 20 },
  (_, i) => `<p>Paragraph ${i}</p>
    <geodesic-voronoi loading="lazy" ${model} seed="${i + 1}"></geodesic-voronoi>`,
).join('\n');

/** By their paths. */
export const elementPages = {
  '/icon.svg': { html: '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" />' },
  '/one.html': page(`<geodesic-voronoi ${model}></geodesic-voronoi>`),
  '/right-to-left.html': page(
    `<div dir="rtl" lang="ar"><geodesic-voronoi ${model}></geodesic-voronoi></div>`,
  ),
  '/elsewhere.html': {
    ...page(
      `<geodesic-voronoi ${model}></geodesic-voronoi>`,
      '<script type="module" src="http://cdn.example/standalone.js"></script>',
    ),
    policy:
      "default-src 'self'; script-src http://cdn.example 'wasm-unsafe-eval'; " +
      "worker-src blob: http://cdn.example; connect-src 'self' http://cdn.example",
  },
  '/twenty.html': page(twenty),
  '/early.html': page(`<geodesic-voronoi></geodesic-voronoi><script src="early.js"></script>`),
  '/early.js': {
    html: `Object.assign(document.querySelector('geodesic-voronoi'), {
      src: '/samples/torus.glb', sites: 7, layers: ['regions', 'dual'], cameraOrbit: '30deg 75deg 120%',
    });`,
  },
  '/early_sites.html': page(
    '<geodesic-voronoi sites="3"></geodesic-voronoi><script src="early_sites.js"></script>',
  ),
  '/early_sites.js': {
    html: `document.querySelector('geodesic-voronoi').sites = { face: [0], bary: [1, 0, 0] };`,
  },
  '/exploded.html': page(
    `<geodesic-voronoi ${model} exploded="0.8" layers="regions"></geodesic-voronoi>
     <script type="module" src="count.js"></script>`,
  ),
  '/count.js': {
    html: `const viewer = document.querySelector('geodesic-voronoi');
      viewer.addEventListener('exploded', ({ detail }) => { viewer.parts = detail?.regions; });`,
  },
  '/scheme.html': page(
    `<geodesic-voronoi ${model} layers="regions"></geodesic-voronoi>`,
    `<meta name="color-scheme" content="light dark" />${standalone}`,
  ),
  '/empty.html': page(''),
  '/unaddressed.gltf': {
    html: JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ uri: 'http://[', byteLength: 1 }],
    }),
  },
  '/vast.gltf': {
    html: JSON.stringify({
      asset: { version: '2.0' },
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ componentType: 5126, count: 20_000_001, type: 'VEC3' }],
    }),
  },
  '/half.gltf': {
    html: JSON.stringify({
      asset: { version: '2.0' },
      buffers: ['endless.bin', 'nowhere.bin'].map((uri) => ({ uri, byteLength: 1 })),
    }),
  },
  '/split.gltf': {
    html: JSON.stringify({
      ...tetrahedron.json,
      bufferViews: tetrahedron.json.bufferViews.map(({ byteLength }, buffer) => ({
        buffer,
        byteLength,
      })),
      buffers: tetrahedron.json.bufferViews.map(({ byteLength }, i) => ({
        byteLength,
        uri: `${i}.bin`,
      })),
    }),
  },
  '/pentagon.obj': { html: 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n' },
  '/inside-out.obj': {
    html: `v -1 -1 -1\nv 1 -1 1\nv -1 1 1\nv 1 1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n`,
  },
  '/article.html': page(`<geodesic-voronoi ${model}></geodesic-voronoi>${longText}`),
  '/import-map.html': byImportMap(`<geodesic-voronoi ${model}></geodesic-voronoi>`),
  '/coloured.html': byImportMap('<geodesic-voronoi src="/coloured.ply"></geodesic-voronoi>'),
  '/coloured.ply': {
    html: [
      ...['ply', 'format ascii 1.0', 'element vertex 3'],
      ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
      ...['red', 'green', 'blue'].map((channel) => `property uchar ${channel}`),
      ...['element face 1', 'property list uchar int vertex_indices', 'end_header'],
      ...['0 0 0 255 0 0', '1 0 0 255 0 0', '0 1 0 255 0 0', '3 0 1 2', ''],
    ].join('\n'),
  },
  '/unplaced.html': byImportMap(`<geodesic-voronoi ${model} sampling="none"></geodesic-voronoi>`),
};

/** A page without an element, to which the script has come. */
export async function emptyPage(browser, options) {
  const viewer = await browser.visit({ path: 'empty.html', ...options });
  await viewer.page.waitForFunction(() => customElements.get('geodesic-voronoi'));
  return viewer;
}
