// SPDX-License-Identifier: MIT
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { makeSamples } from './samples.mjs';

const inBuild = (name) => fileURLToPath(new URL(`../../build/${name}`, import.meta.url));

export default defineConfig(({ isPreview }) => {
  const publicDir = inBuild('page-public');
  if (!isPreview) makeSamples(`${publicDir}/samples`);
  return {
    base: './',
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
