// SPDX-License-Identifier: MIT
//
// The triangles of a partition, ready for the exploded view.

import type { Partition } from 'geodesic-voronoi';
import { LabelColours } from './label_colours.js';
import type { SceneMesh } from './scene_mesh.js';

/** The parts of a partition that are drawn. */
export interface Parts {
  points: Pick<Partition['points'], 'position'>;
  triangles: Partition['triangles'];
  regions: Pick<Partition['regions'], 'centroid'>;
}

/** Per corner. */
export interface PartTriangles {
  /** The corner's place on the model. */
  position: Float32Array;
  /** Its movement in the exploded view, and the shading normal: as shares of the greatest number. */
  direction: Int16Array;
  normal: Int16Array;
  colour: Uint8Array;
}

const one = 32767;

/** Each part moves away from the middle of the model, by the place of its own middle. */
export function partTriangles(
  mesh: SceneMesh,
  { points, triangles, regions }: Parts,
  tones: Uint16Array,
): PartTriangles {
  const places = mesh.frame.toScene(points.position);
  const centres = mesh.frame.toScene(regions.centroid);
  const colours = new LabelColours(tones);
  const corners = triangles.points.length;
  const position = new Float32Array(3 * corners);
  const direction = new Int16Array(3 * corners);
  const normal = new Int16Array(3 * corners);
  const colour = new Uint8Array(3 * corners);
  const bary = [0, 0, 0];
  const outward = new Float32Array(3);
  for (let c = 0; c < corners; ++c) {
    const triangle = Math.floor(c / 3);
    const label = triangles.label[triangle];
    const point = triangles.points[c];
    for (let axis = 0; axis < 3; ++axis) {
      position[3 * c + axis] = places[3 * point + axis];
      if (label >= 0) direction[3 * c + axis] = one * centres[3 * label + axis];
      bary[axis] = triangles.bary[3 * c + axis];
    }
    mesh.writeNormal(triangles.face[triangle], bary, outward, 0);
    for (let axis = 0; axis < 3; ++axis) normal[3 * c + axis] = one * outward[axis];
    colours.write(label, colour, 3 * c);
  }
  return { position, direction, normal, colour };
}
