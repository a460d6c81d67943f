// SPDX-License-Identifier: MIT
//
// The page's sample models, made when the page is built: they come with npm packages or from
// formulas, and none is kept in the repository.

import { copyFileSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { GlbBuilder } from '../../../dist/output/glb.js';
import { ply } from '../../../dist/output/ply.js';
import { bearingBlock, tangleCube, tripleTorus } from './implicit_shapes.mjs';
import { knot, moebiusStrip, ripples, torus } from './shapes.mjs';
import { subdivide } from './subdivision.mjs';

const require = createRequire(import.meta.url);

/**
 * How each model of `samples.json` comes about: its triangles, or the path of a file in a package.
 */
const sources = {
  'bunny.ply': () => bunny(2),
  'hand.glb': '@webxr-input-profiles/assets/dist/profiles/generic-hand/left.glb',
  'bearing.glb': bearingBlock,
  'triple-torus.glb': tripleTorus,
  'tangle.glb': tangleCube,
  'torus.glb': torus,
  'knot.glb': knot,
  'ripples.glb': ripples,
  'moebius.glb': moebiusStrip,
};

/** Writes the models into a folder, and removes everything else from it. */
export function makeSamples(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const [file, source] of Object.entries(sources)) {
    const target = join(folder, file);
    if (typeof source === 'string') copyFileSync(require.resolve(source), target);
    else writeFileSync(target, file.endsWith('.ply') ? plyOf(source()) : glbOf(source()));
  }
}

/** The first model before it is subdivided: 3,674 triangles, for tests that need no more. */
export function coarseBunny() {
  return plyOf(bunny(0));
}

/** A PLY of triangles. The first model is one, because reading it takes no other module. */
function plyOf({ positions, indices }) {
  const offset = Array.from({ length: indices.length / 3 + 1 }, (_, face) => 3 * face);
  const vertices = [{ names: ['x', 'y', 'z'], type: 'float', values: positions }];
  return ply('A sample', vertices, { offset, points: indices }, []);
}

/** The bunny of its package has 3,674 triangles, and four times as many after each round of subdivision. */
function bunny(rounds) {
  const { positions, cells } = require('bunny');
  let surface = { positions: positions.flat(), indices: cells.flat() };
  for (let round = 0; round < rounds; ++round) surface = subdivide(surface);
  return surface;
}

/** A binary glTF of one mesh. */
function glbOf({ positions, indices }) {
  const places = Float64Array.from(positions);
  const file = new GlbBuilder(places, 1);
  const attributes = { POSITION: file.positions([...Array(places.length / 3).keys()]) };
  const primitives = [{ attributes, indices: file.indices(Uint32Array.from(indices)) }];
  return file.finish({ nodes: [{ mesh: 0 }], meshes: [{ primitives }] });
}
