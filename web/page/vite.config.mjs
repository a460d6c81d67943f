// SPDX-License-Identifier: MIT
//
// How the page is built: everything needed at first sight is fetched early and kept small.

import { statSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import samples from './samples/samples.json' with { type: 'json' };
import { makeSamples } from './samples/samples.mjs';

const inBuild = (name) => fileURLToPath(new URL(`../../build/${name}`, import.meta.url));

/** Preloads the large script and its parts together with the first script, which imports it. */
const preloadMain = {
  name: 'preload-main',
  transformIndexHtml: {
    order: 'post',
    handler(_, { bundle = {} }) {
      const main = Object.values(bundle).find(
        (file) => file.isDynamicEntry && file.name === 'main',
      );
      return [main?.fileName, ...(main?.imports ?? [])]
        .filter((name) => name !== undefined)
        .map((name) => ({
          tag: 'link',
          attrs: { rel: 'modulepreload', href: `./${name}`, crossorigin: true },
          injectTo: 'head',
        }));
    },
  },
};

/** The indentation of the page is for those who write it. */
const withoutIndentation = {
  name: 'without-indentation',
  transformIndexHtml: (html) => html.replace(/^ +/gm, ''),
};

/**
 * Shader texts of three.js for features that the page does not use: other materials, maps other
 * than of colour, shadows, fog, skins, morph targets, particles, light probes, clipping planes,
 * dithering, packed depths and tone mapping. They are a tenth of the first download, and bundlers
 * cannot see that they are unused. A material that needs one of them does not compile until it is
 * taken off this list.
 */
const neededByNothing = {
  ShaderLib:
    /background|cube|depth|distance|equirect|linedashed|matcap|normal|phong|physical|points|shadow|sprite|toon|vsm/,
  ShaderChunk:
    /physical|phong|toon|transmission|iridescence|clearcoat|lightprobes|tonemapping_pars|shadowm|(ao|bump|displacement|emissive|env|gradient|light|metalness|normal|roughness)map|fragment_maps|alphahash|batching|clipping|dithering|fog|logdepth|morph|packing|particle|skin/,
};

/**
 * Modules of three.js that its renderer makes or names, but that do nothing here: virtual reality,
 * shadows, clipping planes, surroundings, morph targets, light probes, passes after the picture,
 * uniforms in groups. Stubs replace them, with just the members that the renderer uses in any case.
 */
const idleModules = {
  'extras/PMREMGenerator.js': 'export class PMREMGenerator {}',
  'renderers/webgl/WebGLClipping.js': `
    export class WebGLClipping {
      uniform = {};
      numPlanes = 0;
      numIntersection = 0;
      init() {
        return false;
      }
    }`,
  'renderers/webgl/WebGLEnvironments.js':
    'export class WebGLEnvironments { get() { return null; } dispose() {} }',
  'renderers/webgl/WebGLMorphtargets.js': 'export class WebGLMorphtargets {}',
  'renderers/webgl/WebGLOutput.js': 'export class WebGLOutput {}',
  'renderers/webgl/WebGLShadowMap.js':
    'export class WebGLShadowMap { enabled = false; render() {} }',
  'renderers/webgl/WebGLUniformsGroups.js': 'export class WebGLUniformsGroups { dispose() {} }',
  'renderers/webxr/WebXRManager.js': `
    import { EventDispatcher } from '../../core/EventDispatcher.js';
    export class WebXRManager extends EventDispatcher {
      enabled = false;
      isPresenting = false;
      getEnvironmentBlendMode() {}
      setAnimationLoop() {}
      dispose() {}
    }`,
};

const leaveOutOfThree = {
  name: 'leave-out-of-three',
  load(id) {
    const [, module] = /three\/src\/([\w/]+\.js)$/.exec(id) ?? [];
    if (idleModules[module]) return idleModules[module];
    const [, folder, name] =
      /three\/src\/renderers\/shaders\/(?:(\w+)\/)?(\w+)[.\w]*\.js$/.exec(id) ?? [];
    if (name === 'DFGLUTData') return 'export const getDFGLUT = () => null;';
    if (!neededByNothing[folder]?.test(name)) return undefined;
    return folder === 'ShaderLib'
      ? "export const vertex = '', fragment = '';"
      : "export default '';";
  },
};

/** Shaders and styles are texts, whose indentation and comments are left by what minifies scripts. */
const withoutComments = {
  name: 'without-comments',
  transform: (code, id) =>
    /three\/(src\/renderers\/shaders|examples\/jsm\/lines)\/|\/web\/viewer\//.test(id)
      ? code.replace(/^\s*((\/\/.*|\/\*.*\*\/)\n\s*)*/gm, '')
      : undefined,
};

export default defineConfig(({ isPreview }) => {
  const publicDir = inBuild('page-public');
  if (!isPreview) makeSamples(`${publicDir}/samples`);
  const first = [
    fileURLToPath(import.meta.resolve('geodesic-voronoi/core.wasm')),
    `${publicDir}/samples/${samples[0].file}`,
  ];
  const firstBytes = isPreview ? 0 : first.reduce((sum, file) => sum + statSync(file).size, 0);
  return {
    define: { firstBytes },
    base: './',
    plugins: [preloadMain, withoutIndentation, leaveOutOfThree, withoutComments],
    // The source modules of three.js: those not needed at first sight come with code that needs
    // them.
    resolve: { alias: [{ find: /^three$/, replacement: 'three/src/Three.js' }] },
    publicDir,
    build: {
      outDir: inBuild('page'),
      emptyOutDir: true,
      target: 'es2022',
      // A strict content security policy allows no data: addresses.
      assetsInlineLimit: 0,
      // Most of the large chunk is three.js.
      chunkSizeWarningLimit: 800,
    },
    worker: { format: 'es' },
  };
});
