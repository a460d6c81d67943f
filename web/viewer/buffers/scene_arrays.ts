// SPDX-License-Identifier: MIT
//
// Turns a model's mesh into arrays for the scene: a second of work for a large model, so it is done
// in a worker if possible (see `DrawingBuilder`).

import type { Mesh } from 'geodesic-voronoi';
import { cornerNormals } from './corner_normals.js';
import { ModelFrame } from './model_frame.js';
import { surfaceDensity } from './surface_density.js';

/** The triangles of a model in the scene; faces keep the numbers of the input. */
export interface SceneArrays {
  /** Where the model stands: see `ModelFrame`. */
  centre: readonly number[];
  scale: number;
  /** Per input vertex. */
  positions: Float32Array;
  indices: Int32Array;
  /** Per corner of every face: shading normal, and x, y, z. */
  normals: Float32Array;
  cornerPositions: Float32Array;
  /** The grid that `surface_density.ts` describes. */
  surfaceDensity: Uint8Array;
}

export function sceneArrays({
  positions,
  indices,
}: Pick<Mesh, 'positions' | 'indices'>): SceneArrays {
  const frame = ModelFrame.around(positions, indices);
  const scene = frame.toScene(positions);
  const isAllFinite = scene.every(Number.isFinite);
  // Vertices without finite coordinates belong to no face of the surface, but three.js would
  // measure them.
  const placed = isAllFinite ? scene : scene.map((x) => (Number.isFinite(x) ? x : 0));
  const faces = isAllFinite ? indices : collapsedWhereNotFinite(indices, scene);
  return {
    centre: frame.centre,
    scale: frame.scale,
    positions: placed,
    indices: faces,
    normals: cornerNormals(placed, faces),
    cornerPositions: cornerPositions(placed, faces),
    surfaceDensity: surfaceDensity({ positions: placed, indices: faces }),
  };
}

function cornerPositions(positions: Float32Array, indices: Int32Array): Float32Array {
  const corners = new Float32Array(3 * indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    for (let axis = 0; axis < 3; ++axis) {
      corners[3 * corner + axis] = positions[3 * indices[corner] + axis];
    }
  }
  return corners;
}

/** Faces with a corner without finite coordinates are collapsed to a point. */
function collapsedWhereNotFinite(indices: Int32Array, scene: Float32Array): Int32Array {
  const hasFinitePlace = (vertex: number) =>
    scene.subarray(3 * vertex, 3 * vertex + 3).every(Number.isFinite);
  return indices.map((vertex, i) => {
    const face = indices.subarray(i - (i % 3), i - (i % 3) + 3);
    return face.every(hasFinitePlace) ? vertex : face[0];
  });
}
