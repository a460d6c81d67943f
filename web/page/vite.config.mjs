// SPDX-License-Identifier: MIT
import { statSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import samples from './samples.json' with { type: 'json' };
import { makeSamples } from './samples.mjs';

const inBuild = (name) => fileURLToPath(new URL(`../../build/${name}`, import.meta.url));

/** The large script is fetched together with the first one, which asks for it. */
const preloadMain = {
  name: 'preload-main',
  transformIndexHtml: {
    order: 'post',
    handler(_, { bundle = {} }) {
      const main = Object.values(bundle).find(
        (file) => file.isDynamicEntry && file.name === 'main',
      );
      const attrs = { rel: 'modulepreload', href: `./${main?.fileName}`, crossorigin: true };
      return main ? [{ tag: 'link', attrs, injectTo: 'head' }] : [];
    },
  },
};

export default defineConfig(({ isPreview }) => {
  const publicDir = inBuild('page-public');
  if (!isPreview) makeSamples(`${publicDir}/samples`);
  const first = [
    fileURLToPath(import.meta.resolve('geodesic-voronoi/core.wasm')),
    fileURLToPath(import.meta.resolve('geodesic-voronoi/gltf.wasm')),
    `${publicDir}/samples/${samples[0].file}`,
  ];
  const firstBytes = isPreview ? 0 : first.reduce((sum, file) => sum + statSync(file).size, 0);
  return {
    define: { firstBytes },
    base: './',
    plugins: [preloadMain],
    publicDir,
    build: {
      outDir: inBuild('page'),
      emptyOutDir: true,
      target: 'es2022',
      // A strict content security policy allows no data: addresses.
      assetsInlineLimit: 0,
      // three.js is most of it.
      chunkSizeWarningLimit: 800,
    },
    worker: { format: 'es' },
  };
});
